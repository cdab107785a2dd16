// An immediate-mode layer with this program's own look: it draws into an ImDrawList and reads ui::Input, nothing else.
// A frame: construct Ui, draw panels and controls (widgets.h), end(). What was hit is decided by the places that the
// controls had in the frame before, so that a press and its effect fall into the same frame.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/ui/fonts.h"
#include "app/ui/formula.h"
#include "app/ui/input.h"
#include "app/ui/paint.h"
#include "app/ui/prose.h"
#include "app/ui/report.h"
#include "app/ui/theme.h"

namespace texelscope::ui {

/// What outlives a frame. A plain value: copy it, compare pictures, throw it away.
struct UiMemory {
    Id hot = 0, active = 0, focus = 0;  ///< under the mouse; held by it; the keys' target. 0: none, the canvas
    bool ring = false;                  ///< the focus came by keys and is drawn
    bool focus_moved = false;           ///< in this frame: regions scroll to it
    glm::vec2 press{0}, mouse{0};       ///< where `active` was pressed; the mouse in the frame before
    int presses = 0;                    ///< of the left button so far: a number for each drag
    int right_presses = 0;              ///< of the right button so far, the same
    glm::vec2 right_press{0};           ///< where it was pressed last
    double hot_since = 0;               ///< [s]
    std::vector<ControlRecord> controls;
    Id field = 0;            ///< being edited, with its text and the caret's byte
    Id cancelled_field = 0;  ///< whose editing Esc ended in this frame
    std::string field_text;
    std::size_t caret = 0;
    struct Scroll {
        float offset = 0, content = 0;
    };
    std::map<Id, Scroll> scroll;
    struct Fade {
        float value = 0;
        double time = 0;
    };
    std::map<Id, Fade> fades;
    struct Glow {
        std::uint64_t what = 0;
        double since = 0;
    };
    std::map<Id, Glow> glows;
};

struct UiOptions {
    bool reduced_motion = false;
    bool record_texts = true;
    double tip_delay = 0.4;  ///< [s]
};

struct ControlSpec {
    std::string_view name;  ///< unique in the frame; what scripts and tests call it
    Area area;
    Kind kind = Kind::button;
    std::string_view label = {};  ///< for people who cannot see it
    std::string_view tip = {};    ///< shown on hovering: meaning, unit, formula; may hold $mathematics$
    bool enabled = true, focusable = true, round = false;
};

struct Control {
    Id id = 0;
    bool hovered = false, held = false, focused = false;
    bool clicked = false;  ///< released over it, or Enter or Space with the focus
    bool by_key = false;   ///< `clicked` came from the keyboard
    bool double_clicked = false;
    bool pressed = false;              ///< went down in this frame
    bool dragging = false;             ///< held, and the mouse has moved since
    glm::vec2 drag{0}, drag_total{0};  ///< in this frame; since the press [px]
};

class Ui {
public:
    Ui(UiMemory& memory, const Input& input, const Fonts& fonts, const Theme& theme, ImDrawList& list,
       const UiOptions& options = {});
    Ui(const Ui&) = delete;
    Ui& operator=(const Ui&) = delete;

    /// Draws the focus ring and the tip over everything, and remembers the controls. Last call of a frame.
    void end();

    [[nodiscard]] const Fonts& fonts() const { return fonts_; }
    [[nodiscard]] const Theme& theme() const { return theme_; }
    [[nodiscard]] const Input& input() const { return input_; }
    [[nodiscard]] ImDrawList& list() { return list_; }
    [[nodiscard]] UiMemory& memory() { return memory_; }
    [[nodiscard]] const FrameReport& report() const { return report_; }
    [[nodiscard]] const UiOptions& options() const { return options_; }
    [[nodiscard]] bool presenting() const { return fonts_.spec().presenting; }
    [[nodiscard]] const Font& font(Face face) const { return fonts_.face(face); }
    /// A length at 100 %, scaled, in whole pixels (at least 1 where `at_100` is positive).
    [[nodiscard]] float px(float at_100) const;

    /// The next frame differs without any input (a fade, a tip that is due): draw again, do not idle.
    [[nodiscard]] bool wants_frame() const { return wants_frame_; }
    void request_frame() { wants_frame_ = true; }
    /// Text is being typed: single letters are not commands.
    [[nodiscard]] bool typing() const { return memory_.field != 0; }
    /// Key presses that no control has used; complete after the last control.
    [[nodiscard]] std::vector<KeyPress> unused_keys() const;

    // -- places
    /// Ground, hairlines at the left and top, title and right-hand note; F6 stops here. Clips until end_panel().
    /// @return the place for content.
    Area begin_panel(std::string_view name, const Area& area, std::string_view title = {}, std::string_view note = {},
                     std::optional<Color> ground = std::nullopt);
    void end_panel();
    void begin_clip(const Area& area);
    void end_clip();
    [[nodiscard]] const Area& clip() const { return clips_.back().area; }
    /// Wheel and, with the focus, keys move what is drawn between the two calls, clipped to `area`.
    /// @return where to draw: `area` without the bar, moved up by what was scrolled.
    Area begin_scroll(std::string_view name, const Area& area);
    void end_scroll(float content_height);
    void scroll_to(std::string_view name, float from, float to);  ///< content positions that are to be seen
    /// The opaque colour under the text that follows; letters too weak on it turn to the text colour.
    void set_ground(Color ground) { ground_ = ground; }
    [[nodiscard]] Color ground() const { return ground_; }

    // -- text; `pen` is the baseline's left (or right) end; the width is returned
    float text(Face face, glm::vec2 pen, Role role, std::string_view s);
    float text_right(Face face, glm::vec2 pen, Role role, std::string_view s);
    /// Shortened to `width` with an ellipsis.
    float text_within(Face face, glm::vec2 pen, float width, Role role, std::string_view s);
    void text_centred(Face face, const Area& area, Role role, std::string_view s);
    /// One line with $mathematics$, **strong** and `code`.
    float rich(Face face, glm::vec2 pen, Role role, std::string_view s);
    /// Shortened to `width` with an ellipsis.
    float rich_within(Face face, glm::vec2 pen, float width, Role role, std::string_view s);
    [[nodiscard]] float rich_width(Face face, std::string_view s) const;
    /// A block of text; returns its height. Spans with a link become controls "name/link".
    float prose(std::string_view name, const Area& area, std::span<const Span> spans, const ProseStyle& style = {},
                LinkId* hovered = nullptr, LinkId* clicked = nullptr);

    // -- formulas
    void formula(const MathBox& box, glm::vec2 pen);
    struct LinkEvent {
        LinkId link = 0;
        Control control;
    };
    /// As formula(), and every link is a control "name/link"; the event of the one under the mouse, held or focused.
    std::optional<LinkEvent> formula(std::string_view name, const MathBox& box, glm::vec2 pen);

    // -- controls
    Control control(const ControlSpec& spec);
    /// True once for each press of `key` that is unused and meant for the control `id`, which has the focus.
    bool take_key(Id id, Key key, KeyPress* press = nullptr);
    /// What hovering over the control `id` says, where it is known only after control().
    void set_tip(Id id, std::string_view tip) { tips_[id] = std::string(tip); }
    void set_focus(Id id, bool ring);
    /// 0 to 1 and back within 120 ms.
    float fade(std::string_view name, bool on);
    /// 1 where `what` is another than in the frame before, fading to 0 within 120 ms: the eye finds what has changed.
    float glow(std::string_view name, std::uint64_t what);

private:
    struct ClipState {
        Area area;
        bool scrolls = false;
    };
    struct ScrollState {
        Id id = 0;
        Area area;
        std::size_t first_control = 0;
    };

    void find_hot();
    void move_focus();
    void record(const Font& font, glm::vec2 pen, float width, Color color, std::string_view s, bool subscript = false);
    void draw_layout(const ProseLayout& layout, glm::vec2 at, Role role);
    void draw_ring();
    void draw_tip();
    void push_clip(const Area& area, bool scrolls);

    UiMemory& memory_;
    const Input& input_;
    const Fonts& fonts_;
    const Theme& theme_;
    ImDrawList& list_;
    UiOptions options_;
    FrameReport report_;
    std::vector<bool> used_keys_;
    std::vector<ClipState> clips_;
    std::vector<ScrollState> scrolls_;
    std::map<Id, std::string> tips_;
    Id panel_ = 0;
    Color ground_ = 0;
    bool wants_frame_ = false;
    Id wheel_target_ = 0;
};

}  // namespace texelscope::ui
