// What a frame put on the screen, for checks that nobody can do by eye on every lesson, size and theme.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "app/ui/color.h"
#include "app/ui/geometry.h"

namespace texelscope::ui {

/// A control's name, hashed. 0 is none.
using Id = std::uint64_t;
[[nodiscard]] Id id_of(std::string_view name, Id within = 0);

enum class Kind : std::uint8_t { button, toggle, choice, tab, slider, field, handle, link, region };

struct ControlRecord {
    Id id = 0, panel = 0;
    Kind kind = Kind::button;
    Area area;  ///< as drawn
    Area hit;   ///< where the mouse counts, at least 24 x 24 before clipping
    Area clip;
    bool enabled = true, focusable = true;
    bool round = false;  ///< the hit area is the inscribed circle
    std::string name, label;
};

struct TextRecord {
    Area area, clip;
    float px = 0;          ///< nominal size
    bool scrolls = false;  ///< lies in a region that scrolls, where being cut is no fault
    bool subscript = false;
    Color color = 0, ground = 0;
    std::string text;
};

struct PanelRecord {
    Id id = 0;
    std::string name;
    Area area;
};

struct FrameReport {
    std::vector<TextRecord> texts;
    std::vector<ControlRecord> controls;  ///< in the order in which Tab visits those that can have the focus
    std::vector<PanelRecord> panels;
};

/// Texts that reach over their clip rectangle by over `slack` pixels, outside scrolling regions.
[[nodiscard]] std::vector<TextRecord> texts_cut(const FrameReport& report, float slack = 1);
/// Infinite where there is no text.
[[nodiscard]] float smallest_text(const FrameReport& report, bool subscripts);
/// Controls whose hit area is under `least` in a direction although their clip rectangle has room for it.
[[nodiscard]] std::vector<ControlRecord> small_targets(const FrameReport& report, float least = 24);
/// Texts with less contrast to their ground than `least`.
[[nodiscard]] std::vector<TextRecord> faint_texts(const FrameReport& report, double least);

}  // namespace texelscope::ui
