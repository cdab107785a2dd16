// The header: what is open, where the cursor stands, and the switches that are always at hand. A button that has no
// room at a size is left out from the least needed on; at one size none ever moves.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "app/state/lesson_cursor.h"
#include "app/ui/text.h"
#include "app/ui/widgets.h"
#include "app/views/math_of_tape.h"
#include "app/views/screen_parts.h"

namespace texelscope {
namespace {

using ui::Area;
using ui::Face;
using ui::Role;

constexpr std::array<std::string_view, kLevels> kHeaderLetters{"T", "G", "S", "P", "E"};
constexpr std::array<std::string_view, kLevels> kHeaderLevelTips{
    "Triangles: one step draws a whole shape", "Stages: one step is a part of a shape's work",
    "Scanlines: one step is a row", "Pixels: one step is a sample", "Expressions: one step is a value"};
constexpr std::string_view kFormatTip = "The numbers that the method computes with: from float to exact";
constexpr std::string_view kHeaderVariantTip = "As the source has it, or corrected (X); and each of its quirks";
constexpr std::string_view kSmaller = "A−", kLarger = "A+", kSmallerTip = "Smaller text (Ctrl −)",
                           kLargerTip = "Larger text (Ctrl +)";
constexpr std::string_view kUndoTip = "Undo (Ctrl Z)", kRedoTip = "Redo (Ctrl Y)", kThemeTip = "Dark or light (T)",
                           kPresentTip = "Present (F5)";
constexpr std::string_view kListTip = "List of lessons (L)";
constexpr std::string_view kGoToHint = "t0/s3/y11/x16 or 16, 11";
constexpr std::string_view kNoSuchPlace =
    "{} is no step and no pixel that a shape visits: expected a path such as t0/s5/y11/x16, or x, y";
constexpr std::string_view kUntitled = "Scene";
constexpr std::string_view kWidestFormat = "fx16.16", kWidestVariant = "as published";

enum class Item : std::uint8_t { undo, redo, levels, format, variant, smaller, larger, theme, present };
constexpr std::size_t kItems = 9;
/// The last that are left out first.
constexpr std::array kByNeed{Item::format,  Item::variant, Item::smaller, Item::larger, Item::levels,
                             Item::present, Item::theme,   Item::undo,    Item::redo};

struct Places {
    std::array<Area, kItems> of{};
    float left = 0;  ///< where the first begins
    [[nodiscard]] const Area& at(Item item) const { return of[static_cast<std::size_t>(item)]; }
};

/// Widths depend on the widest label, never on the one that stands there.
[[nodiscard]] float width_of(const ui::Ui& ui, Item item, float height) {
    const float small = std::max(height, ui::text_width(ui.font(Face::title), kSmaller) + ui.px(8));
    switch (item) {
        case Item::levels: return std::round(std::max(height, ui.px(26)) * kLevels);
        case Item::format: return std::ceil(ui::text_width(ui.font(Face::code_note), kWidestFormat)) + 2 * ui.px(7);
        case Item::variant: return std::ceil(ui::text_width(ui.font(Face::title), kWidestVariant)) + 2 * ui.px(8);
        case Item::smaller:
        case Item::larger: return std::ceil(small);
        default: return height;
    }
}

[[nodiscard]] Places place_items(const ui::Ui& ui, const Area& header) {
    constexpr float kTitleShare = .34F;
    const float height = std::min(ui.px(ui::size::kHeaderButton), header.h - 8), gap = ui.px(4), group = ui.px(12);
    const float y = header.y + std::floor((header.h - height) / 2), room = header.w * (1 - kTitleShare);
    std::array<bool, kItems> shown{};
    float used = ui.px(16);
    for (const Item item : kByNeed) {
        const float needs = width_of(ui, item, height) + group;
        if (used + needs > room) break;
        used += needs;
        shown[static_cast<std::size_t>(item)] = true;
    }
    Places places;
    float x = header.right() - ui.px(16);
    for (std::size_t i = kItems; i-- > 0;) {
        const auto item = static_cast<Item>(i);
        if (!shown[i]) continue;
        const float w = width_of(ui, item, height);
        x -= w;
        places.of[i] = {std::round(x), y, w, height};
        const bool tight = item == Item::redo || item == Item::variant || item == Item::larger || item == Item::present;
        x -= tight ? gap : group;
    }
    places.left = x;
    return places;
}

/// Glyphs of commands that no icon has: drawn, so that no font needs them.
void draw_glyph(ui::Ui& ui, Item item, const Area& area, ui::Color color) {
    ImDrawList& list = ui.list();
    const glm::vec2 c = area.centre();
    const float r = std::round(area.h * .24F), w = std::max(1.3F, area.h * .06F);
    if (item == Item::theme) {
        list.AddCircle(ui::to_im(c), r, color, 0, w);
        list.PathArcTo(ui::to_im(c), r, -1.5708F, 1.5708F);
        list.PathFillConvex(color);
    } else if (item == Item::present) {
        ui::frame(list, {std::round(c.x - 1.3F * r), std::round(c.y - r), std::round(2.6F * r), std::round(1.7F * r)},
                  color, std::round(w));
        ui::line(list, {c.x, c.y + .7F * r}, {c.x, c.y + 1.3F * r}, w, color);
        ui::line(list, {c.x - .7F * r, c.y + 1.3F * r}, {c.x + .7F * r, c.y + 1.3F * r}, w, color);
    } else {
        const float way = item == Item::undo ? -1.0F : 1.0F;
        list.PathArcTo({c.x, c.y + .2F * r}, r, way < 0 ? -2.6F : -3.6F, way < 0 ? .5F : -.54F);
        list.PathStroke(color, 0, w);
        const glm::vec2 tip{c.x + way * r * .98F, c.y - .35F * r};
        ui::line(list, tip, {tip.x, tip.y - .9F * r}, w, color);
        ui::line(list, tip, {tip.x - way * .9F * r, tip.y}, w, color);
    }
}

[[nodiscard]] bool glyph_button(const ViewContext& c, std::string_view name, Item item, const Area& area,
                                std::string_view tip, bool enabled = true) {
    if (area.empty()) return false;
    ui::ButtonStyle style;
    style.enabled = enabled;
    const ui::Control control = ui::button(c.ui, name, area, " ", tip, style);
    const bool down = control.held && control.hovered;
    draw_glyph(c.ui, item, area, c.ui.theme()[!enabled ? Role::faint : down ? Role::on_now : Role::text]);
    return control.clicked;
}

void draw_levels(const ViewContext& c, const Area& area) {
    if (area.empty()) return;
    ui::Ui& ui = c.ui;
    const std::string allowed =
        c.state.document && c.state.document->lesson ? c.state.document->lesson->levels : "TGSPE";
    ui::frame(ui.list(), area, ui.theme().hairline, 1, ui::size::kRadius);
    const float width = area.w / kLevels;
    for (int n = 0; n < kLevels; ++n) {
        const auto k = static_cast<std::size_t>(n);
        ui::ButtonStyle style;
        style.face = Face::code_note;
        style.quiet = true;
        style.chosen = static_cast<int>(c.state.cursor.level) == n;
        style.enabled = style.chosen || allowed.find(kHeaderLetters[k]) != std::string::npos;
        style.kind = ui::Kind::choice;
        const Area place{std::round(area.x + width * static_cast<float>(n)), area.y, std::round(width), area.h};
        if (style.enabled && !style.chosen) ui::fill(ui.list(), place.inset(1, 1), ui.theme().raise);
        if (style.enabled && !style.chosen) ui.set_ground(ui.theme().raise);
        if (ui::button(ui, fmt::format("level/{}", kHeaderLetters[k]), place, kHeaderLetters[k], kHeaderLevelTips[k],
                       style)
                .clicked)
            c.act(action::SetLevel{static_cast<Level>(n)});
        ui.set_ground(ui.theme().bg);
    }
}

void draw_buttons(const ViewContext& c, const Places& places) {
    ui::Ui& ui = c.ui;
    const auto look_button = [&](std::string_view name, Item item, std::string_view label, std::string_view tip,
                                 float scale) {
        if (places.at(item).empty() || !ui::button(ui, name, places.at(item), label, tip).clicked) return;
        Look look = c.state.look;
        look.scale = scale;
        c.act(action::SetLook{look});
    };
    constexpr float kStep = .25F;
    if (glyph_button(c, "undo", Item::undo, places.at(Item::undo), kUndoTip, c.can_undo)) c.act(action::Undo{});
    if (glyph_button(c, "redo", Item::redo, places.at(Item::redo), kRedoTip, c.can_redo)) c.act(action::Redo{});
    draw_levels(c, places.at(Item::levels));
    const auto list_button = [&](std::string_view name, Item item, std::string_view label, std::string_view tip,
                                 Face face, Overlay list) {
        if (places.at(item).empty()) return;
        ui::ButtonStyle style;
        style.face = face;
        style.chosen = c.state.overlay == list;
        if (ui::button(ui, name, places.at(item), label, tip, style).clicked) c.act(action::Show{list});
    };
    list_button("format", Item::format, id_of(c.state.work.format), kFormatTip, Face::code_note, Overlay::formats);
    list_button("variant", Item::variant, spaced(c.state.work.variant), kHeaderVariantTip, Face::title,
                Overlay::quirks);
    look_button("smaller", Item::smaller, kSmaller, kSmallerTip, c.state.look.scale - kStep);
    look_button("larger", Item::larger, kLarger, kLargerTip, c.state.look.scale + kStep);
    Look look = c.state.look;
    if (glyph_button(c, "theme", Item::theme, places.at(Item::theme), kThemeTip)) {
        look.theme = look.theme == Theme::dark ? Theme::light : Theme::dark;
        c.act(action::SetLook{look});
    }
    if (glyph_button(c, "present", Item::present, places.at(Item::present), kPresentTip)) {
        look.presenting = true;
        c.act(action::SetLook{look});
    }
}

/// The step that a person typed: a path, or a pixel's "x, y".
[[nodiscard]] std::optional<Path> place_typed(const std::string& text, const Derived& derived) {
    if (auto path = parse_path(text)) return path;
    const std::size_t comma = text.find(',');
    if (comma == std::string::npos) return std::nullopt;
    char* end = nullptr;
    const long x = std::strtol(text.c_str(), &end, 10);
    if (end != text.c_str() + comma) return std::nullopt;
    const char* rest = text.c_str() + comma + 1;
    const long y = std::strtol(rest, &end, 10);
    if (end == rest || *end != '\0') return std::nullopt;
    constexpr long kFar = 1L << 30;
    if (std::abs(x) > kFar || std::abs(y) > kFar) return std::nullopt;
    return derived.last_write({static_cast<int>(x), static_cast<int>(y)});
}

void draw_go_to(const ViewContext& c, const Area& area) {
    constexpr std::string_view kName = "go-to";
    ui::Ui& ui = c.ui;
    const ui::FieldResult field = ui::field(ui, kName, area, "", kGoToHint);
    const bool left = ui.input().pressed[0] && !area.contains(ui.input().mouse);
    if (field.committed || field.cancelled || left) {
        c.act(action::Show{Overlay::none});
        if (!field.committed || field.text.empty()) return;
        if (const auto path = place_typed(field.text, c.derived))
            c.act(action::StepTo{*path});
        else
            c.act(action::Say{{fmt::format(kNoSuchPlace, field.text), true}});
    } else if (!field.editing && ui.memory().focus == 0) {
        ui.set_focus(ui::id_of(kName), true);
        ui.request_frame();
    }
}

void draw_crumbs(const ViewContext& c, float x, float right, float baseline) {
    ui::Ui& ui = c.ui;
    const std::vector<Crumb> all = crumbs(c.state, c.derived);
    const float gap = ui.px(6), step = ui.px(18), middle = baseline - ui.font(Face::title).x_height / 2;
    const auto what_width = [&](const Crumb& crumb) { return ui::text_width(ui.font(Face::title), crumb.what); };
    const auto width_of = [&](const Crumb& crumb) {
        return what_width(crumb) + (crumb.value.empty() ? 0 : gap + ui.rich_width(Face::code_note, crumb.value));
    };
    // Where they do not all fit, the innermost tell most: the shape is to be seen in the timeline.
    std::size_t first = all.size();
    for (float used = 0; first > 0; --first) {
        used += width_of(all[first - 1]) + (first < all.size() ? step : 0);
        if (x + used > right) break;
    }
    for (std::size_t n = first; n < all.size(); ++n) {
        const Crumb& crumb = all[n];
        const float what = what_width(crumb), width = width_of(crumb);
        if (n > first) {
            const float r = ui.px(4), mid = x + step / 2;
            ui::line(ui.list(), {mid - r / 2, middle - r}, {mid + r / 2, middle}, 1.3F, ui.theme()[Role::muted]);
            ui::line(ui.list(), {mid + r / 2, middle}, {mid - r / 2, middle + r}, 1.3F, ui.theme()[Role::muted]);
            x += step;
        }
        const bool last = n + 1 == all.size();
        const Area place{x - 2, baseline - ui.px(14), width + 4, ui.px(20)};
        const ui::Control control =
            ui.control({fmt::format("crumb/{}", n), place, ui::Kind::link, crumb.what, {}, true, !last});
        if (control.clicked) c.act(action::StepTo{crumb.path});
        ui.text(Face::title, {x, baseline}, control.hovered ? Role::text : Role::muted, crumb.what);
        if (!crumb.value.empty())
            ui.rich(Face::code_note, {x + what + gap, baseline}, last ? Role::now : Role::text, crumb.value);
        x += width;
    }
}

}  // namespace

std::string spaced(std::string_view id) {
    std::string text(id);
    std::replace(text.begin(), text.end(), '-', ' ');
    return text;
}

std::vector<Crumb> crumbs(const State& state, const Derived& derived) {
    std::vector<Crumb> all;
    const Path& step = state.cursor.step;
    const std::vector<Lane> lanes = step.empty() ? std::vector<Lane>{} : derived.lanes();
    for (std::size_t n = 0; n < step.parts.size(); ++n) {
        const PathPart& part = step.parts[n];
        const Path path = step.prefix(static_cast<int>(n) + 1);
        const std::string index = std::to_string(part.index);
        if (part.letter == 't') {
            all.push_back({derived.method().triangles ? "triangle" : "polygon", std::to_string(part.index + 1), path});
        } else if (part.letter == 's') {
            const Lane& stages = lanes[1];
            if (part.index < 0 || part.index >= static_cast<Integer>(stages.labels.size())) continue;
            const std::string& label = stages.labels[static_cast<std::size_t>(part.index)];
            const std::string name = label == "delta" ? "Δ" : label;  // as on the timeline
            const std::size_t digit = name.find_last_of(' ');
            const bool numbered =
                digit != std::string::npos && name.find_first_not_of("0123456789", digit + 1) == std::string::npos;
            if (numbered)
                all.push_back({name.substr(0, digit), name.substr(digit + 1), path});
            else if (n + 1 == step.parts.size() || step.parts[n + 1].letter == 'e')
                all.push_back({"stage", name, path});
        } else if (part.letter == 'e') {
            const Named* named = derived.named();
            if (named != nullptr) all.push_back({"value", markup_of_name(named->name.text()), step});
        } else {
            all.push_back({part.letter == 'y'   ? "row"
                           : part.letter == 'x' ? "pixel"
                                                : std::string(1, part.letter),
                           index, path});
        }
    }
    return all;
}

ui::Area header_button(const ui::Ui& ui, const Area& header, Overlay of) {
    const Places places = place_items(ui, header);
    return places.at(of == Overlay::formats ? Item::format : Item::variant);
}

void draw_header(const ViewContext& c, const Area& place) {
    ui::Ui& ui = c.ui;
    ui.begin_panel("header", place, {}, {}, ui.theme().bg);
    const Places places = place_items(ui, place);
    const float baseline = ui::baseline_at_middle(ui.font(Face::lesson_title), place.centre().y),
                right = places.left - ui.px(4);
    float x = place.x + ui.px(16);
    const State& state = c.state;
    const bool lesson = state.document && state.document->lesson;
    const std::string title = lesson           ? state.document->lesson->title
                              : state.document ? state.document->id
                                               : std::string(kUntitled);
    const float begin = x;
    if (lesson && state.document->lesson->number > 0)
        x += ui.text(Face::code, {x, baseline}, Role::muted, fmt::format("{:02}", state.document->lesson->number)) +
             ui.px(11);
    x += ui.text_within(Face::lesson_title, {x, baseline}, std::max(0.0F, right - x), Role::text, title);
    const Area button{begin - ui.px(4), place.y + 4, x - begin + ui.px(8), place.h - 8};
    const ui::Control list = ui.control({"lessons", button, ui::Kind::button, kListTip, kListTip});
    if (list.hovered) ui::frame(ui.list(), button, ui.theme()[Role::now], 1, ui::size::kRadius);
    if (list.clicked) c.act(action::Show{Overlay::lessons});
    x += ui.px(28);
    if (state.overlay == Overlay::go_to) {
        const float height = std::min(ui.px(ui::size::kHeaderButton), place.h - 8),
                    width = std::min(ui.px(240), right - x + ui.px(24));
        draw_go_to(c, {std::max(begin, right - std::max(width, ui.px(80))),
                       place.y + std::floor((place.h - height) / 2), std::max(width, ui.px(80)), height});
    } else {
        draw_crumbs(c, x, right, baseline);
    }
    draw_buttons(c, places);
    ui.end_panel();
}

}  // namespace texelscope
