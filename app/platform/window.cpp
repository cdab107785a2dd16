#include "app/platform/window.h"

#include <algorithm>
#include <array>
#include <limits>
#include <memory>
#include <utility>

#include <GLFW/glfw3.h>
#include <backends/imgui_impl_opengl3.h>
#include <glm/common.hpp>
#include <glm/vec2.hpp>

#include "app/platform/glfw_keys.h"
#include "app/platform/imgui_session.h"
#include "app/platform/input_collector.h"
#include "app/platform/opengl_textures.h"
#include "core/base/rect.h"

namespace texelscope {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();
constexpr double kShortestFrame = 1.0 / 250;  ///< where the driver does not wait for the screen [s]
constexpr double kLongestSleep = 3600;        ///< [s]
constexpr int kFramesPerEvent = 2;
constexpr std::pair kSides{64, 16384};  ///< of a window [px]

struct GlfwLibrary {
    const bool ready = glfwInit() == GLFW_TRUE;
    GlfwLibrary() = default;
    GlfwLibrary(const GlfwLibrary&) = delete;
    GlfwLibrary& operator=(const GlfwLibrary&) = delete;
    ~GlfwLibrary() { glfwTerminate(); }
};

struct DestroyWindow {
    void operator()(GLFWwindow* window) const { glfwDestroyWindow(window); }
};
using WindowHandle = std::unique_ptr<GLFWwindow, DestroyWindow>;

struct DestroyCursor {
    void operator()(GLFWcursor* cursor) const { glfwDestroyCursor(cursor); }
};
using CursorHandle = std::unique_ptr<GLFWcursor, DestroyCursor>;

class OpenGlRenderer {
public:
    explicit OpenGlRenderer(const ImGuiSession& session) : session_(session) {
        session_.activate();
        ready_ = ImGui_ImplOpenGL3_Init("#version 330 core");
    }
    OpenGlRenderer(const OpenGlRenderer&) = delete;
    OpenGlRenderer& operator=(const OpenGlRenderer&) = delete;
    ~OpenGlRenderer() {
        session_.activate();
        if (ready_) ImGui_ImplOpenGL3_Shutdown();
    }
    [[nodiscard]] bool ready() const { return ready_; }

private:
    const ImGuiSession& session_;
    bool ready_ = false;
};

/// GLFW's last complaint after `what` has failed, in one line.
[[nodiscard]] Error no_window(const std::string& what) {
    const char* reason = nullptr;
    glfwGetError(&reason);
    std::string line = what + (reason == nullptr ? std::string() : std::string(": ") + reason);
    std::replace(line.begin(), line.end(), '\n', ' ');
    return {"window", line};
}

[[nodiscard]] int cursor_shape(ImGuiMouseCursor cursor) {
    switch (cursor) {
        case ImGuiMouseCursor_TextInput: return GLFW_IBEAM_CURSOR;
        case ImGuiMouseCursor_ResizeAll: return GLFW_CROSSHAIR_CURSOR;
        case ImGuiMouseCursor_ResizeNS: return GLFW_VRESIZE_CURSOR;
        case ImGuiMouseCursor_ResizeEW: return GLFW_HRESIZE_CURSOR;
        case ImGuiMouseCursor_Hand: return GLFW_HAND_CURSOR;
        default: return GLFW_ARROW_CURSOR;
    }
}

/// The monitor that shows most of the window; null where there is none.
[[nodiscard]] GLFWmonitor* monitor_of(const Rect& window) {
    int count = 0;
    GLFWmonitor** const monitors = glfwGetMonitors(&count);
    GLFWmonitor* best = glfwGetPrimaryMonitor();
    long long most = 0;
    for (int i = 0; i < count; ++i) {
        const GLFWvidmode* const mode = glfwGetVideoMode(monitors[i]);
        if (mode == nullptr) continue;
        int x = 0, y = 0;
        glfwGetMonitorPos(monitors[i], &x, &y);
        const Rect shown = intersection(window, {x, y, x + mode->width, y + mode->height});
        const long long area = static_cast<long long>(shown.width()) * shown.height();
        if (area > most) most = area, best = monitors[i];
    }
    return best;
}

class GlfwHost final : public Host {
public:
    GlfwHost(GLFWwindow* window, const WindowCallbacks& callbacks);

    [[nodiscard]] bool ready() const { return renderer_.ready(); }
    int run();

    [[nodiscard]] TextureStore& textures() override { return textures_; }
    void set_fonts(ImFontAtlas& atlas) override { session_.set_fonts(atlas); }
    [[nodiscard]] float content_scale() const override;
    void wants_frames_until(double time) override { animate_until_ = time; }
    void wake_at(double time) override { wake_at_ = time; }
    void poll_every(double seconds) override;
    [[nodiscard]] bool fullscreen() const override { return glfwGetWindowMonitor(window_) != nullptr; }
    void set_fullscreen(bool on) override;
    void set_title(const std::string& title) override;
    [[nodiscard]] std::string clipboard() override;
    void set_clipboard(const std::string& text) override { glfwSetClipboardString(window_, text.c_str()); }
    void close(int exit_code) override;

private:
    static GlfwHost& of(GLFWwindow* window) { return *static_cast<GlfwHost*>(glfwGetWindowUserPointer(window)); }
    void listen_to_keys();
    void listen_to_mouse();
    void listen_to_window();
    void touch() { pending_ = kFramesPerEvent; }
    void on_key(int key, int scancode, int action, int mods);
    [[nodiscard]] glm::ivec2 framebuffer() const;
    [[nodiscard]] glm::vec2 in_pixels(double x, double y) const;
    [[nodiscard]] bool frame_due(double now) const;
    void sleep() const;
    void poll();
    void draw(glm::ivec2 size);
    void show_cursor();
    [[nodiscard]] bool held(int left, int right) const;
    void set_modifiers(int mods);

    GLFWwindow* window_;
    const WindowCallbacks& callbacks_;
    ImGuiSession session_;
    OpenGlRenderer renderer_;
    OpenGlTextures textures_;
    InputCollector events_;
    std::array<CursorHandle, ImGuiMouseCursor_COUNT> cursors_;
    ImGuiMouseCursor cursor_ = ImGuiMouseCursor_Arrow;
    Rect windowed_;  ///< where the window goes back to from the full screen
    std::string title_;
    int pending_ = kFramesPerEvent + 1;
    double animate_until_ = 0, wake_at_ = kNever, last_frame_ = -1;
    double poll_interval_ = 0, next_poll_ = kNever;
    bool fonts_shown_ = false;
    int exit_code_ = 0;
};

GlfwHost::GlfwHost(GLFWwindow* window, const WindowCallbacks& callbacks)
    : window_(window), callbacks_(callbacks), session_(*this), renderer_(session_) {
    glfwSetWindowUserPointer(window, this);
    listen_to_keys();
    listen_to_mouse();
    listen_to_window();
}

void GlfwHost::listen_to_keys() {
    glfwSetKeyCallback(window_, [](GLFWwindow* w, int key, int scancode, int action, int mods) {
        of(w).on_key(key, scancode, action, mods);
    });
    glfwSetCharCallback(window_, [](GLFWwindow* w, unsigned int c) {
        of(w).events_.character(c);
        of(w).touch();
    });
}

void GlfwHost::listen_to_mouse() {
    glfwSetCursorPosCallback(window_, [](GLFWwindow* w, double x, double y) {
        of(w).events_.move(of(w).in_pixels(x, y));
        of(w).touch();
    });
    glfwSetCursorEnterCallback(window_, [](GLFWwindow* w, int entered) {
        if (entered == GLFW_FALSE) of(w).events_.leave();
        of(w).touch();
    });
    glfwSetMouseButtonCallback(window_, [](GLFWwindow* w, int button, int action, int mods) {
        double x = 0, y = 0;
        glfwGetCursorPos(w, &x, &y);
        of(w).set_modifiers(mods);
        of(w).events_.move(of(w).in_pixels(x, y));
        of(w).events_.button(button, action == GLFW_PRESS, glfwGetTime());
        of(w).touch();
    });
    glfwSetScrollCallback(window_, [](GLFWwindow* w, double x, double y) {
        of(w).events_.wheel({static_cast<float>(x), static_cast<float>(y)});
        of(w).touch();
    });
    glfwSetDropCallback(window_, [](GLFWwindow* w, int count, const char** paths) {
        for (int i = 0; i < count; ++i) of(w).events_.drop(paths[i]);
        of(w).touch();
    });
}

void GlfwHost::listen_to_window() {
    const auto two_sizes = [](GLFWwindow* w, int, int) { of(w).touch(); };
    glfwSetFramebufferSizeCallback(window_, two_sizes);
    glfwSetWindowSizeCallback(window_, two_sizes);
    glfwSetWindowContentScaleCallback(window_, [](GLFWwindow* w, float, float) { of(w).touch(); });
    glfwSetWindowRefreshCallback(window_, [](GLFWwindow* w) { of(w).touch(); });
    glfwSetWindowFocusCallback(window_, [](GLFWwindow* w, int) { of(w).touch(); });
    glfwSetWindowIconifyCallback(window_, [](GLFWwindow* w, int) { of(w).touch(); });
}

void GlfwHost::on_key(int key, int scancode, int action, int mods) {
    touch();
    if (action == GLFW_RELEASE) return events_.key_up(scancode);
    set_modifiers(mods);
    const ui::Key ours = key_from_glfw(key, glfwGetKeyName(key, scancode));
    events_.key_down(scancode, ours, action == GLFW_REPEAT);
    if ((mods & GLFW_MOD_CONTROL) != 0 && ours == ui::Key::v) events_.paste(clipboard());
}

void GlfwHost::set_modifiers(int mods) {
    events_.modifiers((mods & GLFW_MOD_CONTROL) != 0, (mods & GLFW_MOD_SHIFT) != 0, (mods & GLFW_MOD_ALT) != 0);
}

glm::ivec2 GlfwHost::framebuffer() const {
    glm::ivec2 size{0};
    glfwGetFramebufferSize(window_, &size.x, &size.y);
    return size;
}

glm::vec2 GlfwHost::in_pixels(double x, double y) const {
    glm::ivec2 window{0};
    glfwGetWindowSize(window_, &window.x, &window.y);
    const glm::vec2 scale = glm::vec2(framebuffer()) / glm::vec2(glm::max(window, glm::ivec2(1)));
    return glm::vec2(static_cast<float>(x), static_cast<float>(y)) * scale;
}

float GlfwHost::content_scale() const {
    float x = 1, y = 1;
    glfwGetWindowContentScale(window_, &x, &y);
    return x > 0 ? x : 1;
}

void GlfwHost::poll_every(double seconds) {
    if (poll_interval_ == seconds) return;
    poll_interval_ = seconds;
    next_poll_ = seconds > 0 ? glfwGetTime() + seconds : kNever;
}

void GlfwHost::set_fullscreen(bool on) {
    if (on == fullscreen()) return;
    touch();
    if (!on) {
        glfwSetWindowMonitor(window_, nullptr, windowed_.x0, windowed_.y0, windowed_.width(), windowed_.height(),
                             GLFW_DONT_CARE);
        return;
    }
    glm::ivec2 at{0}, size{0};
    glfwGetWindowPos(window_, &at.x, &at.y);
    glfwGetWindowSize(window_, &size.x, &size.y);
    windowed_ = {at.x, at.y, at.x + size.x, at.y + size.y};
    GLFWmonitor* const monitor = monitor_of(windowed_);
    const GLFWvidmode* const mode = monitor == nullptr ? nullptr : glfwGetVideoMode(monitor);
    if (mode == nullptr) return;
    glfwSetWindowMonitor(window_, monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
    glfwSwapInterval(1);
}

void GlfwHost::set_title(const std::string& title) {
    if (title == title_) return;
    title_ = title;
    glfwSetWindowTitle(window_, title.c_str());
}

std::string GlfwHost::clipboard() {
    const char* const text = glfwGetClipboardString(window_);
    return text == nullptr ? std::string() : std::string(text);
}

void GlfwHost::close(int exit_code) {
    exit_code_ = exit_code;
    glfwSetWindowShouldClose(window_, GLFW_TRUE);
}

bool GlfwHost::frame_due(double now) const {
    return pending_ > 0 || events_.waiting() || now < animate_until_ || now >= wake_at_;
}

/// Until something happens, a wished time has come, or the next frame is due.
void GlfwHost::sleep() const {
    const double now = glfwGetTime();
    const glm::ivec2 size = framebuffer();
    double until = next_poll_;
    if (size.x > 0 && size.y > 0) until = std::min(until, frame_due(now) ? last_frame_ + kShortestFrame : wake_at_);
    if (until <= now) return glfwPollEvents();
    if (until == kNever) return glfwWaitEvents();
    glfwWaitEventsTimeout(std::min(until - now, kLongestSleep));
}

void GlfwHost::poll() {
    const double now = glfwGetTime();
    if (now < next_poll_) return;
    next_poll_ = now + poll_interval_;
    if (callbacks_.poll && callbacks_.poll()) touch();
}

void GlfwHost::draw(glm::ivec2 size) {
    const double now = glfwGetTime();
    last_frame_ = now;
    pending_ = std::max(pending_ - 1, 0);
    if (now >= wake_at_) wake_at_ = kNever;
    // A modifier may come or go while another window has the keys.
    if (!events_.waiting())
        events_.modifiers(held(GLFW_KEY_LEFT_CONTROL, GLFW_KEY_RIGHT_CONTROL),
                          held(GLFW_KEY_LEFT_SHIFT, GLFW_KEY_RIGHT_SHIFT), held(GLFW_KEY_LEFT_ALT, GLFW_KEY_RIGHT_ALT));
    if (session_.change_fonts() && fonts_shown_) {
        ImGui_ImplOpenGL3_DestroyFontsTexture();
        ImGui_ImplOpenGL3_CreateFontsTexture();
    }
    fonts_shown_ = true;
    textures_.begin_frame();
    ImGui_ImplOpenGL3_NewFrame();
    const ui::Input input = events_.take(size, now);
    session_.begin_frame(input);
    if (callbacks_.frame) callbacks_.frame(input, *this);
    show_cursor();
    session_.end_frame();
    glViewport(0, 0, size.x, size.y);
    glClearColor(0, 0, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
    glfwSwapBuffers(window_);
}

bool GlfwHost::held(int left, int right) const {
    return glfwGetKey(window_, left) == GLFW_PRESS || glfwGetKey(window_, right) == GLFW_PRESS;
}

void GlfwHost::show_cursor() {
    const ImGuiMouseCursor wanted = ImGui::GetMouseCursor();
    if (wanted == cursor_) return;
    cursor_ = wanted;
    glfwSetInputMode(window_, GLFW_CURSOR, wanted == ImGuiMouseCursor_None ? GLFW_CURSOR_HIDDEN : GLFW_CURSOR_NORMAL);
    if (wanted < 0 || wanted >= ImGuiMouseCursor_COUNT) return;
    CursorHandle& cursor = cursors_[static_cast<std::size_t>(wanted)];
    if (cursor == nullptr) cursor.reset(glfwCreateStandardCursor(cursor_shape(wanted)));
    glfwSetCursor(window_, cursor.get());
}

int GlfwHost::run() {
    if (callbacks_.start) callbacks_.start(*this);
    while (glfwWindowShouldClose(window_) == GLFW_FALSE) {
        sleep();
        poll();
        const glm::ivec2 size = framebuffer();
        if (size.x > 0 && size.y > 0 && frame_due(glfwGetTime())) draw(size);
    }
    return exit_code_;
}

[[nodiscard]] WindowHandle open_window(const WindowOptions& options) {
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
    glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
    const auto side = [](int px) { return std::clamp(px, kSides.first, kSides.second); };
    return WindowHandle(
        glfwCreateWindow(side(options.width), side(options.height), options.title.c_str(), nullptr, nullptr));
}

}  // namespace

Result<int> run_window(const WindowOptions& options, const WindowCallbacks& callbacks) {
    const GlfwLibrary library;
    if (!library.ready) return no_window("there is no display to open a window on");
    const WindowHandle window = open_window(options);
    if (window == nullptr) return no_window("no window with OpenGL 3.3 can be opened");
    glfwMakeContextCurrent(window.get());
    glfwSwapInterval(1);
    GlfwHost host(window.get(), callbacks);
    if (!host.ready()) return no_window("OpenGL 3.3 cannot be used");
    if (options.fullscreen) host.set_fullscreen(true);
    return host.run();
}

}  // namespace texelscope
