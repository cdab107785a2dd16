// One ImGui context, fed from ui::Input alone, so that a window and a test see the same thing.
#pragma once

#include <memory>
#include <string>

#include <imgui.h>

#include "app/platform/host.h"
#include "app/ui/input.h"

namespace texelscope {

class ImGuiSession {
public:
    /// `host` gives ImGui's text fields their clipboard, and must outlive the session.
    explicit ImGuiSession(Host& host);
    ImGuiSession(const ImGuiSession&) = delete;
    ImGuiSession& operator=(const ImGuiSession&) = delete;
    ~ImGuiSession();

    /// Makes this context ImGui's current one.
    void activate() const { ImGui::SetCurrentContext(context_); }
    /// As Host::set_fonts; until it is called, ImGui's built-in font is used.
    void set_fonts(ImFontAtlas& atlas);
    /// The atlas that the next, or the running, frame draws with.
    [[nodiscard]] ImFontAtlas& fonts() const { return *atlas_; }

    /// Puts an atlas that was set during the last frame in use. Comes before begin_frame; returns whether the atlas
    /// is another than at the last call.
    bool change_fonts();
    void begin_frame(const ui::Input& input);
    /// What to draw; valid until the next begin_frame.
    const ImDrawData& end_frame();

private:
    static const char* get_clipboard(void* session);
    static void set_clipboard(void* session, const char* text);

    Host& host_;
    std::string clipboard_;
    std::unique_ptr<ImFontAtlas> built_in_;
    ImFontAtlas* atlas_ = nullptr;
    ImFontAtlas* next_atlas_ = nullptr;
    bool changed_ = true;
    double last_time_ = -1;
    ImGuiContext* context_ = nullptr;
};

/// Copies `input` into ImGui's own fields. ImGui's native key codes are ui::Key.
/// @param elapsed  since the last frame [s]; brought into a range that ImGui accepts.
void feed(ImGuiIO& io, const ui::Input& input, double elapsed);

}  // namespace texelscope
