// The platform without a display: the same frames as in a window, drawn by core/fast/paint.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "app/platform/host.h"
#include "app/platform/imgui_session.h"
#include "app/platform/texture_cache.h"
#include "app/ui/input.h"
#include "core/image/image.h"

namespace texelscope {

class SoftwareTextures final : public TextureCache {
public:
    ~SoftwareTextures() override { release_all(); }
    /// The pixels behind a handle; null where it is no handle of this store.
    [[nodiscard]] const Grid<Rgba>* find(ImTextureID id) const;

private:
    ImTextureID upload(ImTextureID old, const Grid<Rgba>& pixels) override;
    void release(ImTextureID held) override;

    std::unordered_map<std::uintptr_t, Grid<Rgba>> pixels_;
    std::uintptr_t last_ = 1;  ///< 1 is the font's
};

/// What the application asked of its host; a test looks here.
struct HostWishes {
    double frames_until = 0, wake_at = 0, poll_every = 0;  ///< 0 where never asked
    bool fullscreen = false;
    std::string title, clipboard;
    std::optional<int> exit_code;
};

class SoftwarePlatform final : public Host {
public:
    SoftwarePlatform() : session_(*this) {}

    /// Runs one frame: `draw` may call ImGui, whose current context is this platform's and stays so.
    void frame(const ui::Input& input, const std::function<void()>& draw);
    /// The last frame as pixels, over black; empty before the first. Its size is Input::size, rounded up.
    [[nodiscard]] Image picture() const;
    [[nodiscard]] const HostWishes& wishes() const { return wishes_; }

    [[nodiscard]] TextureStore& textures() override { return textures_; }
    void set_fonts(ImFontAtlas& atlas) override { session_.set_fonts(atlas); }
    [[nodiscard]] float content_scale() const override { return 1; }
    void wants_frames_until(double time) override { wishes_.frames_until = time; }
    void wake_at(double time) override { wishes_.wake_at = time; }
    void poll_every(double seconds) override { wishes_.poll_every = seconds; }
    [[nodiscard]] bool fullscreen() const override { return wishes_.fullscreen; }
    void set_fullscreen(bool on) override { wishes_.fullscreen = on; }
    void set_title(const std::string& title) override { wishes_.title = title; }
    [[nodiscard]] std::string clipboard() override { return wishes_.clipboard; }
    void set_clipboard(const std::string& text) override { wishes_.clipboard = text; }
    void close(int exit_code) override { wishes_.exit_code = exit_code; }

private:
    HostWishes wishes_;
    SoftwareTextures textures_;
    ImGuiSession session_;
    const ImDrawData* drawn_ = nullptr;
};

/// Paints what ImGui drew over `picture`. A handle that neither is the font's nor in `textures` draws nothing.
void paint_draw_data(Image& picture, const ImDrawData& drawn, ImFontAtlas& fonts, const SoftwareTextures& textures);

}  // namespace texelscope
