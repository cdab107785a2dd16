#include "app/platform/imgui_session.h"

#include <algorithm>
#include <array>
#include <cfloat>
#include <utility>

namespace texelscope {
namespace {

constexpr float kLargestSide = 16384;  // of a window [px]

constexpr std::array kKeys{
    std::pair{ImGuiKey_Tab, ui::Key::tab},
    std::pair{ImGuiKey_LeftArrow, ui::Key::left},
    std::pair{ImGuiKey_RightArrow, ui::Key::right},
    std::pair{ImGuiKey_UpArrow, ui::Key::up},
    std::pair{ImGuiKey_DownArrow, ui::Key::down},
    std::pair{ImGuiKey_PageUp, ui::Key::page_up},
    std::pair{ImGuiKey_PageDown, ui::Key::page_down},
    std::pair{ImGuiKey_Home, ui::Key::home},
    std::pair{ImGuiKey_End, ui::Key::end},
    std::pair{ImGuiKey_Delete, ui::Key::del},
    std::pair{ImGuiKey_Backspace, ui::Key::backspace},
    std::pair{ImGuiKey_Space, ui::Key::space},
    std::pair{ImGuiKey_Enter, ui::Key::enter},
    std::pair{ImGuiKey_Escape, ui::Key::escape},
    std::pair{ImGuiKey_A, ui::Key::a},
    std::pair{ImGuiKey_C, ui::Key::c},
    std::pair{ImGuiKey_V, ui::Key::v},
    std::pair{ImGuiKey_X, ui::Key::x},
    std::pair{ImGuiKey_Y, ui::Key::y},
    std::pair{ImGuiKey_Z, ui::Key::z},
};

[[nodiscard]] float side(float px) { return px >= 1 ? std::min(px, kLargestSide) : 1; }

}  // namespace

void feed(ImGuiIO& io, const ui::Input& input, double elapsed) {
    io.DisplaySize = {side(input.size.x), side(input.size.y)};
    io.DisplayFramebufferScale = {1, 1};
    io.DeltaTime = static_cast<float>(std::clamp(elapsed, 1e-4, 1.0));
    const bool nowhere = !(input.mouse.x > -1e8F && input.mouse.y > -1e8F);
    io.MousePos = nowhere ? ImVec2(-FLT_MAX, -FLT_MAX) : ImVec2(input.mouse.x, input.mouse.y);
    for (std::size_t i = 0; i < input.down.size(); ++i) io.MouseDown[i] = input.down[i] || input.pressed[i];
    io.MouseWheelH += input.wheel.x;
    io.MouseWheel += input.wheel.y;
    io.KeyCtrl = input.ctrl;
    io.KeyShift = input.shift;
    io.KeyAlt = input.alt;
    io.KeySuper = false;
    std::fill(std::begin(io.KeysDown), std::end(io.KeysDown), false);
    for (const ui::Key key : input.held) io.KeysDown[static_cast<std::size_t>(key)] = true;
    for (const ui::KeyPress& press : input.keys) io.KeysDown[static_cast<std::size_t>(press.key)] = true;
    io.KeysDown[static_cast<std::size_t>(ui::Key::none)] = false;
    io.AddInputCharactersUTF8(input.text.c_str());
}

ImGuiSession::ImGuiSession(Host& host)
    : host_(host), built_in_(std::make_unique<ImFontAtlas>()), atlas_(built_in_.get()), next_atlas_(atlas_) {
    IMGUI_CHECKVERSION();
    ImGuiContext* const before = ImGui::GetCurrentContext();
    context_ = ImGui::CreateContext(atlas_);
    activate();
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.LogFilename = nullptr;
    io.BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset | ImGuiBackendFlags_HasMouseCursors;
    std::fill(std::begin(io.KeyMap), std::end(io.KeyMap), -1);
    for (const auto& [imgui, key] : kKeys) io.KeyMap[imgui] = static_cast<int>(key);
    io.ClipboardUserData = this;
    io.GetClipboardTextFn = get_clipboard;
    io.SetClipboardTextFn = set_clipboard;
    if (before != nullptr) ImGui::SetCurrentContext(before);
}

ImGuiSession::~ImGuiSession() {
    ImGuiContext* const current = ImGui::GetCurrentContext();
    activate();
    ImGui::DestroyContext(context_);
    if (current != context_) ImGui::SetCurrentContext(current);
}

void ImGuiSession::set_fonts(ImFontAtlas& atlas) { next_atlas_ = &atlas; }

bool ImGuiSession::change_fonts() {
    if (atlas_ != next_atlas_) {
        atlas_ = next_atlas_;
        changed_ = true;
    }
    if (atlas_->Fonts.empty()) atlas_->AddFontDefault();
    if (!atlas_->IsBuilt()) atlas_->Build();
    activate();
    ImGui::GetIO().Fonts = atlas_;
    ImGui::GetIO().FontDefault = nullptr;
    return std::exchange(changed_, false);
}

void ImGuiSession::begin_frame(const ui::Input& input) {
    activate();
    // Lines whose smoothness is baked into the atlas need bilinear sampling, which the software picture has not.
    ImGui::GetStyle().AntiAliasedLinesUseTex = false;
    feed(ImGui::GetIO(), input, last_time_ < 0 ? 1.0 / 60 : input.time - last_time_);
    last_time_ = input.time;
    ImGui::NewFrame();
}

const ImDrawData& ImGuiSession::end_frame() {
    activate();
    ImGui::Render();
    return *ImGui::GetDrawData();
}

const char* ImGuiSession::get_clipboard(void* session) {
    auto& self = *static_cast<ImGuiSession*>(session);
    self.clipboard_ = self.host_.clipboard();
    return self.clipboard_.c_str();
}

void ImGuiSession::set_clipboard(void* session, const char* text) {
    static_cast<ImGuiSession*>(session)->host_.set_clipboard(text);
}

}  // namespace texelscope
