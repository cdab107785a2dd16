#include "app/views/terms.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

namespace texelscope {
namespace {

struct Meaning {
    std::string_view name, text;
};
/// By the whole name; `#` stands for a corner's number, `@` for a side's letter.
constexpr auto kMeanings = std::to_array<Meaning>({
    {"x_#", "corner #'s distance from the screen's left border [px]"},
    {"y_#", "corner #'s distance from the screen's top border [px]"},
    {"u_#", "corner #'s column on the texture [texels]"},
    {"v_#", "corner #'s row on the texture [texels]"},
    {"Δ", "twice the triangle's area, positive where its corners run clockwise [px²]"},
    {"L", "light: each channel is multiplied by it"},
    {"u_x", "how much $u$ grows with one pixel to the right [texels/px]"},
    {"u_y", "how much $u$ grows with one pixel down [texels/px]"},
    {"u_k", "$u$ at the screen's origin [texels]"},
    {"v_x", "how much $v$ grows with one pixel to the right [texels/px]"},
    {"v_y", "how much $v$ grows with one pixel down [texels/px]"},
    {"v_k", "$v$ at the screen's origin [texels]"},
    {"n_x_@", "side @'s normal, its part to the right [px]"},
    {"n_y_@", "side @'s normal, its part down [px]"},
    {"k_@", "side @'s equation at the screen's origin [px²]"},
    {"owns_@", "whether samples exactly on side @ belong to this triangle"},
    {"E_@", "side @'s equation at the sample: negative inside [px²]"},
    {"in_@", "whether the sample lies on the inner side of @"},
    {"x_min", "the leftmost corner [px]"},
    {"x_max", "the rightmost corner [px]"},
    {"y_min", "the topmost corner [px]"},
    {"y_max", "the lowest corner [px]"},
    {"x_a", "the box's first column [px]"},
    {"x_b", "the column after the box's last [px]"},
    {"y_a", "the box's first row [px]"},
    {"y_b", "the row after the box's last [px]"},
    {"X", "the sample's place along the row [px]"},
    {"Y", "the sample's place down the screen [px]"},
    {"x", "the pixel's column [px]"},
    {"y", "the pixel's row [px]"},
    {"u", "the sample's column on the texture, before it is rounded and wrapped [texels]"},
    {"v", "the sample's row on the texture, before it is rounded and wrapped [texels]"},
    {"column", "the texel's column"},
    {"row", "the texel's row"},
    {"r", "red, as it is stored [0, 255]"},
    {"g", "green, as it is stored [0, 255]"},
    {"b", "blue, as it is stored [0, 255]"},
    {"address", "the pixel's place in the framebuffer, counted row by row"},
    {"area", "twice the polygon's area, positive where its corners run clockwise [px²]"},
    {"left", "the corner at which the left side begins"},
    {"right", "the corner at which the right side begins"},
    {"y_beg", "where the section begins [px]"},
    {"y_end", "where the section ends: at the nearer of the next two corners [px]"},
    {"first_row", "the section's first row [px]"},
    {"last_row", "the row after the section's last [px]"},
    {"m_l", "how far down the left side the row lies, 0 at its upper end, 1 at its lower"},
    {"m_r", "how far down the right side the row lies, 0 at its upper end, 1 at its lower"},
    {"x_l", "where the row meets the left side [px]"},
    {"x_r", "where the row meets the right side [px]"},
    {"u_l", "$u$ at the row's left end [texels]"},
    {"u_r", "$u$ at the row's right end [texels]"},
    {"v_l", "$v$ at the row's left end [texels]"},
    {"v_r", "$v$ at the row's right end [texels]"},
    {"first", "the row's first pixel [px]"},
    {"last", "the pixel after the row's last [px]"},
    {"s", "how far along the row the sample lies, 0 at its left end, 1 at its right"},
    {"z", "depth, 0 near, 1 far"},
    {"w", "distance from the eye along its axis"},
    {"du", "how much $u$ grows from pixel to pixel [texels]"},
    {"dv", "how much $v$ grows from pixel to pixel [texels]"},
    {"dx", "the row's width [px]"},
    {"dx_long", "how much $x$ grows from row to row along the long side [px]"},
    {"dx_short", "how much $x$ grows from row to row along the short side [px]"},
    {"ahead", "how far the first sample lies behind the place that the walk starts from [px]"},
    {"A", "the triangle's area, positive where its corners run clockwise [px²]"},
    {"e_#", "corner #'s weight: 1 at it, 0 on the side across from it"},
    {"part_#", "the area between the sample and the side across from corner # [px²]"},
    {"in_#", "whether the sample lies on corner #'s side of the side across from it"},
    {"ratio", "texels for each pixel of the row [texels/px]"},
    {"start", "where on the texture the row's first pixel samples [texels]"},
    {"begin", "the row's first pixel on the screen, before it is cut [px]"},
    {"n", "how many pixels lie before this one in its row"},
    {"u_c", "the middle of the texel, along its row [texels]"},
    {"v_c", "the middle of the texel, down the texture [texels]"},
    {"tmp", "the column of the texel that the buffer holds here"},
});

/// Names of the methods in perspective.
constexpr std::array kTermsPerspective{
    Meaning{"w_#", "corner #'s distance from the eye along its axis"},
    Meaning{"X_#", "$x w$ of one of three corners that say how the texture lies [px]"},
    Meaning{"Y_#", "$y w$ of one of three corners that say how the texture lies [px]"},
    Meaning{"det", "the determinant of $P$: its cofactors are divided by it"},
    Meaning{"U", "$u/w$ at the sample [texels]"},
    Meaning{"V", "$v/w$ at the sample [texels]"},
    Meaning{"W", "$1/w$ at the sample"},
    Meaning{"U_start", "$u/w$ at the row's first sample [texels]"},
    Meaning{"V_start", "$v/w$ at the row's first sample [texels]"},
    Meaning{"W_start", "$1/w$ at the row's first sample"},
    Meaning{"l_u", "$u/w$ at the sample, from the corners' by their weights [texels]"},
    Meaning{"l_v", "$v/w$ at the sample, from the corners' by their weights [texels]"},
    Meaning{"l_1", "$1/w$ at the sample, from the corners' by their weights"},
};
constexpr std::string_view kCofactor = "a cofactor of $P$: what its inverse is made of";
/// a to i, which are numbers with a fraction; as whole numbers g and b are channels.
constexpr std::array<std::string_view, 9> kCoefficients{
    "how much $u/w$ grows with one pixel to the right [texels/px]",
    "how much $u/w$ grows with one pixel down [texels/px]",
    "$u/w$ at the screen's origin [texels]",
    "how much $v/w$ grows with one pixel to the right [texels/px]",
    "how much $v/w$ grows with one pixel down [texels/px]",
    "$v/w$ at the screen's origin [texels]",
    "how much $1/w$ grows with one pixel to the right [1/px]",
    "how much $1/w$ grows with one pixel down [1/px]",
    "$1/w$ at the screen's origin",
};
/// What one of a to i means, where the value is a coefficient.
[[nodiscard]] std::string_view coefficient(std::string_view name, const Value& value) {
    const bool one = name.size() == 1 && name[0] >= 'a' && name[0] <= 'i';
    if (!one || std::holds_alternative<Integer>(value)) return {};
    return kCoefficients[static_cast<std::size_t>(name[0] - 'a')];
}

constexpr std::string_view kDragHint = "Drag to change it.";
constexpr std::string_view kTermsWrong = "**{}** ";
constexpr float kDragStep = 1.0F / 16;  ///< scene pixels, or texels, for each pixel of the mouse
constexpr float kFineStep = 1.0F / 64, kCoarseStep = 1.0F / 2;

[[nodiscard]] std::string_view format_of(const Value& value) {
    constexpr std::array<std::string_view, 7> kNames{"", "whole", "f64", "f32", "16.16", "8.8", "exact"};
    return kNames[value.index()];
}

[[nodiscard]] std::string name_at(const Tape& tape, std::int32_t named) {
    return tape.names[static_cast<std::size_t>(named)].name.text();
}

[[nodiscard]] const Operation& operation_at(const Tape& tape, std::int32_t named) {
    return tape.operations[static_cast<std::size_t>(tape.names[static_cast<std::size_t>(named)].operation)];
}

void drag(const ViewContext& context, const ui::Control& control, const Handle& handle, bool along_x) {
    const ui::Input& input = context.ui.input();
    const float step = input.shift ? kFineStep : input.ctrl ? kCoarseStep : kDragStep;
    const float moved = std::round(control.drag.x) * step;
    if (!control.dragging || moved == 0) return;
    glm::vec2 to = position_of(context.derived.scene(), handle);
    (along_x ? to.x : to.y) += moved;
    context.act(action::MoveVertex{handle, to, context.ui.memory().presses});
}

}  // namespace

std::string meaning_of(std::string_view name) {
    const int corner = corner_of_name(name), edge = edge_of_name(name);
    std::string pattern(name), part;
    if (corner >= 0) pattern = std::string(name.substr(0, name.find('_'))) + "_#", part = std::to_string(corner);
    if (edge >= 0) pattern.back() = '@', part = std::string(1, static_cast<char>('A' + edge));
    const auto at =
        std::find_if(kMeanings.begin(), kMeanings.end(), [&](const Meaning& m) { return m.name == pattern; });
    const auto other = std::find_if(kTermsPerspective.begin(), kTermsPerspective.end(),
                                    [&](const Meaning& m) { return m.name == pattern; });
    if (at == kMeanings.end() && name.substr(0, 2) == "A_") return std::string(kCofactor);
    if (at == kMeanings.end() && other == kTermsPerspective.end()) return {};
    std::string text(at != kMeanings.end() ? at->text : other->text);
    const std::size_t hole = text.find_first_of("#@");
    if (hole != std::string::npos && !part.empty()) text.replace(hole, 1, part);
    return text;
}

std::string tip_of(const Tape& tape, std::int32_t named) {
    const std::string name = name_at(tape, named);
    const Value& value = operation_at(tape, named).value;
    const std::string_view of_matrix = coefficient(name, value);
    const std::string meaning = of_matrix.empty() ? meaning_of(name) : std::string(of_matrix);
    const std::string_view fault = fault_of(value);
    std::string tip = markup_of_name(name) + " = " + all_digits(value);
    if (const std::string_view format = format_of(value); !format.empty() && format != "whole")
        tip += fmt::format(" ({})", format);
    if (!fault.empty()) tip += " " + fmt::format(kTermsWrong, fault);
    if (!meaning.empty()) tip += ": " + meaning;
    return tip;
}

std::optional<Handle> handle_of(const Drawing& drawing, int shape, const Tape& tape, std::int32_t named) {
    const std::string name = name_at(tape, named);
    const int corner = corner_of_name(name);
    if (corner < 0 || shape < 0 || corner >= static_cast<int>(drawing.corners(shape).size())) return std::nullopt;
    if (std::string_view("xyuv").find(name[0]) == std::string_view::npos) return std::nullopt;
    return Handle{drawing.polygon_of(shape), drawing.vertex_of(shape, corner), name[0] == 'u' || name[0] == 'v'};
}

Light light_of_name(const ViewContext& context, std::string_view name) {
    const auto has = [&](const Highlight& h) {
        return std::find(h.names.begin(), h.names.end(), name) != h.names.end();
    };
    const bool pinned = context.state.pinned.kind == Selection::Kind::name && has(context.pinned);
    if (pinned) return Light::pinned;
    return context.state.hover.kind == Selection::Kind::name && has(context.hover) ? Light::hovered : Light::none;
}

void draw_light(ui::Ui& ui, const ui::Area& area, Light light) {
    if (light == Light::none) return;
    const float width = light == Light::pinned ? 2 : 1;
    ui::frame(ui.list(), area, ui.theme()[ui::Role::now], width, ui::size::kBadgeRadius);
}

void act_on_name(const ViewContext& context, const ui::Control& control, std::string_view name) {
    const Selection what{.kind = Selection::Kind::name, .name = std::string(name)};
    const bool by_key = control.focused && context.ui.memory().ring;
    if (control.hovered || by_key) context.act(action::Hover{what});
    if (control.clicked) context.act(action::Pin{what});
}

void draw_terms(const ViewContext& context, std::string_view name, const Tape& tape, const ui::MathBox& box,
                glm::vec2 pen) {
    ui::Ui& ui = context.ui;
    pen = {std::round(pen.x), std::round(pen.y)};
    const int shape = context.derived.shape();
    for (std::size_t n = 0; n < box.links.size(); ++n) {
        const std::int32_t named = named_of(box.links[n].id);
        if (named < 0 || named >= static_cast<std::int32_t>(tape.names.size())) continue;
        const std::string text = name_at(tape, named), full = fmt::format("{}/{}", name, n);
        const auto handle = handle_of(context.derived.drawing(), shape, tape, named);
        std::string tip = tip_of(tape, named);
        if (handle) tip += ". " + std::string(kDragHint);
        const ui::Area area = box.links[n].area.moved(pen.x, pen.y), plate = area.inset(-ui.px(3), -ui.px(4));
        const ui::Control control = ui.control({full, area, ui::Kind::link, text, tip});
        const bool dragged = control.dragging && handle;
        if (handle && control.held) drag(context, control, *handle, text[0] == 'x' || text[0] == 'u');
        if (handle && control.clicked) context.act(action::ChooseHandle{*handle});
        if (!dragged) act_on_name(context, control, text);
        Light light = light_of_name(context, text);
        if (control.hovered || control.held) light = std::max(light, Light::hovered);
        const bool under_work = named == current_name(context.derived);  // it has a mark already
        if (!under_work || control.hovered) draw_light(ui, plate, under_work ? Light::hovered : light);
    }
    ui.formula(box, pen);
}

ui::Area begin_view(const ViewContext& context, std::string_view name, const ui::Area& place, std::string_view title,
                    std::string_view note) {
    ui::Ui& ui = context.ui;
    if (!ui.presenting()) return ui.begin_panel(name, place, title, note);
    const ui::Area area = ui.begin_panel(name, place);
    return area;
}

void draw_empty(const ViewContext& context, const ui::Area& area, std::string_view text) {
    const std::vector<ui::Span> spans = ui::spans_of(text, ui::Role::muted);
    const std::string name = "hint/" + std::string(text);
    const float top = context.ui.px(8);
    const ui::Area inner = context.ui.begin_scroll(name, {area.x, area.y + top, area.w, area.h - top});
    context.ui.end_scroll(context.ui.prose(name, inner, spans));
}

float pitch(const ui::Ui& ui, float at_100, ui::Face face) {
    return std::max(ui.px(at_100), std::ceil(ui.font(face).em * 1.36F));
}

void foresee(ui::Ui& ui, std::string_view name, float content_height) {
    ui.memory().scroll[ui::id_of(name)].content = content_height;
}

void follow(ui::Ui& ui, std::string_view name, float region_height, float content_height, float from, float to,
            float key) {
    const ui::Id id = ui::id_of(name);
    ui::UiMemory::Scroll& scroll = ui.memory().scroll[id];
    scroll.content = content_height;
    const auto [seen, fresh] = ui.memory().fades.try_emplace(ui::id_of("followed", id));
    if (!fresh && seen->second.value == key) return;
    seen->second.value = key;
    if (to > scroll.offset + region_height) scroll.offset = to - region_height;
    if (from < scroll.offset) scroll.offset = from;
    scroll.offset = std::max(0.0F, scroll.offset);
}

std::int32_t current_name(const Derived& derived) {
    const Named* named = derived.named();
    return named == nullptr ? -1 : static_cast<std::int32_t>(named - derived.visit().tape.names.data());
}

std::int32_t find_name(const Tape& tape, std::string_view text, std::int32_t last) {
    for (std::int32_t n = std::min(last, static_cast<std::int32_t>(tape.names.size()) - 1); n >= 0; --n) {
        if (name_at(tape, n) == text) return n;
    }
    return -1;
}

}  // namespace texelscope
