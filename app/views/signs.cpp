// The three edge functions of the current sample: value, sign on a bar, and what follows from them.
#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "app/ui/text.h"
#include "app/ui/widgets.h"
#include "app/views/canvas_values.h"

namespace texelscope::canvas::signs_view {
namespace {

using ui::Role;

constexpr std::string_view kTitle = "Signs", kNote = "inside: all −";
constexpr std::string_view kNotComputed = "not computed", kNoSample = "Step to a pixel: its three signs show here.";
constexpr std::string_view kRejected = "{}, so rejected", kInside = "inside A, B and C, so drawn";
constexpr std::string_view kUndecided = "undecided: {} to go";
constexpr std::string_view kOwned = "on side {}, its own", kNotOwned = "on side {}, not its own";
constexpr std::string_view kTip = "$E_{}$ is negative on the inner side of {}, positive on the outer side, zero on it.";
constexpr float kRow = 44, kVerdict = 36, kMark = 4.5F, kBar = 6;

struct Sign {
    std::optional<double> value;
    std::optional<bool> inside, owns;
    std::string text;
};

[[nodiscard]] Sign sign_of(const Derived& derived, int e) {
    const char letter = static_cast<char>('A' + e);
    Sign sign;
    // Set-up knows no E; a pixel's unit computes them one after the other.
    const Variable* found = find_variable(derived, fmt::format("E_{}", letter));
    if (found == nullptr) return sign;
    sign.value = approximate(found->value);
    const ui::Number number = ui::format_number(*sign.value);
    sign.text = number.exact ? number.text : fmt::format("≈ {}", number.text);
    sign.inside = truth_of(derived, fmt::format("in_{}", letter));
    sign.owns = truth_of(derived, fmt::format("owns_{}", letter));
    return sign;
}

/// The value at a bar's ends: a power of two, so that it seldom changes while stepping.
[[nodiscard]] double bar_end(const std::array<Sign, 3>& signs) {
    double most = 1;
    for (const Sign& sign : signs)
        if (sign.value && std::isfinite(*sign.value)) most = std::max(most, std::abs(*sign.value));
    return std::exp2(std::ceil(std::log2(most)));
}

void draw_bar(const ViewContext& ctx, const ui::Area& area, double share, int edge) {
    const ui::Theme& theme = ctx.ui.theme();
    const float zero = std::round(area.centre().x), tick = ctx.ui.px(14), y = std::round(area.centre().y);
    ui::fill(ctx.ui.list(), area, theme[Role::rejected]);
    ui::fill(ctx.ui.list(), {area.x, area.y, zero - area.x, area.h}, ui::with_alpha(theme[Role::covered], .7F));
    ui::fill(ctx.ui.list(), {zero - 1, y - tick / 2, 2, tick}, theme[Role::text]);
    const float at = std::round(zero + static_cast<float>(std::clamp(share, -1.0, 1.0)) * (area.w / 2 - 2));
    ui::fill(ctx.ui.list(), {at - 2, y - tick / 2 - 1, 5, tick + 2}, theme.panel);
    ui::fill(ctx.ui.list(), {at - 1, y - tick / 2, 3, tick}, theme[ui::edge_role(edge)]);
}

void draw_row(const ViewContext& ctx, const ui::Area& row, const Sign& sign, double end, int edge) {
    ui::Ui& ui = ctx.ui;
    const char letter = static_cast<char>('A' + edge);
    const std::string name = fmt::format("E_{}", letter), control = fmt::format("signs/{}", name);
    const std::string tip = fmt::format(kTip, letter, letter);
    const ui::Control c = ui.control({.name = control, .area = row, .kind = ui::Kind::link, .label = name, .tip = tip});
    const Selection what{.kind = Selection::Kind::name, .name = name};
    tell_hover(ctx, row, c.hovered, what);
    if (c.clicked) ctx.act(action::Pin{what});
    const auto named = [&](const Highlight& h) {
        return std::find(h.names.begin(), h.names.end(), name) != h.names.end();
    };
    if (named(ctx.pinned))
        ui::current_row(ui, row.inset(-ui.px(6), 1));
    else if (named(ctx.hover))
        ui::frame(ui.list(), row.inset(-ui.px(6), 1), ui.theme()[Role::now], 1, ui::size::kRadius);

    const ui::MathBox label = ui::set_math(ui::symbol(name), {.fonts = &ui.fonts(), .size = ui::MathSize::row});
    const float middle = std::round(row.centre().y), mark = ui.px(kMark), text = row.x + 2 * mark + ui.px(12);
    ui::edge_mark(ui.list(), edge, {row.x + mark, middle}, mark, ui.theme()[ui::edge_role(edge)]);
    ui.formula(label, {text, middle + label.ascent / 2});
    const float left = text + label.width + ui.px(12), width = row.right() - left;
    const bool bare = !sign.value;
    const ui::Font& font = ui.font(bare ? ui::Face::title : ui::Face::code);
    const std::string shown = ui::elided(font, bare ? kNotComputed : std::string_view(sign.text), width);
    if (bare) {
        ui.text_right(ui::Face::title, {row.right(), ui::baseline_at_middle(font, middle)}, Role::muted, shown);
        return;
    }
    const float bar = ui.px(kBar);
    ui.text_right(ui::Face::code, {row.right(), middle - ui.px(4)}, Role::text, shown);
    if (width > ui.px(24)) draw_bar(ctx, {left, middle + ui.px(6), width, bar}, *sign.value / end, edge);
}

struct Verdict {
    std::string text;
    int edge = -1;
};

[[nodiscard]] Verdict verdict_of(const std::array<Sign, 3>& signs) {
    int open = 0;
    for (int e = 0; e < 3; ++e) {
        const Sign& sign = signs[static_cast<std::size_t>(e)];
        const char letter = static_cast<char>('A' + e);
        if (!sign.inside) ++open;
        if (sign.inside && !*sign.inside && sign.value == 0.0) return {fmt::format(kNotOwned, letter), e};
        if (sign.inside && !*sign.inside) return {fmt::format(kRejected, text_of(outside_edge(e))), e};
        const bool last = e == 2 || !signs[static_cast<std::size_t>(e) + 1].value;
        if (sign.inside && sign.value == 0.0 && sign.owns == true && last) return {fmt::format(kOwned, letter), e};
    }
    if (open == 0) return {std::string(kInside), -1};
    return {fmt::format(kUndecided, open), -1};
}

void draw_verdict(const ViewContext& ctx, const ui::Area& area, const Verdict& verdict) {
    ui::Ui& ui = ctx.ui;
    ui::hairline(ui, {area.x, area.y}, area.w);
    const float middle = std::round(area.centre().y), mark = ui.px(kMark), text = area.x + 2 * mark + ui.px(12);
    if (verdict.edge >= 0)
        ui::edge_mark(ui.list(), verdict.edge, {area.x + mark, middle}, mark, ui.theme()[ui::edge_role(verdict.edge)]);
    const float x = verdict.edge >= 0 ? text : area.x;
    ui.text_within(ui::Face::title, {x, ui::baseline_at_middle(ui.font(ui::Face::title), middle)}, area.right() - x,
                   Role::text, verdict.text);
}

void draw(const ViewContext& ctx, const ui::Area& place) {
    ui::Ui& ui = ctx.ui;
    const ui::Area content = ui.begin_panel("signs", place, ui.presenting() ? std::string_view{} : kTitle,
                                            ui.presenting() ? std::string_view{} : kNote);
    if (!is_triangle(ctx.derived) || !ctx.derived.pixel()) {
        ui.prose("signs/empty", content, ui::spans_of(kNoSample, Role::muted));
        ui.end_panel();
        return;
    }
    const std::array<Sign, 3> signs{sign_of(ctx.derived, 0), sign_of(ctx.derived, 1), sign_of(ctx.derived, 2)};
    const float low = std::min(std::max(ui.px(kVerdict), 2.4F * ui.font(ui::Face::title).em), content.h / 4);
    const float least = 3.2F * ui.font(ui::Face::code).em;
    const float height = std::min(std::max(ui.px(kRow), least), (content.h - low) / 3);
    const double end = bar_end(signs);
    for (int e = 0; e < 3; ++e)
        draw_row(ctx,
                 {content.x, std::round(content.y + static_cast<float>(e) * height), content.w, std::floor(height)},
                 signs[static_cast<std::size_t>(e)], end, e);
    const float below =
        std::max(content.y + 3 * height, std::min(content.bottom() - low, content.y + 3 * height + ui.px(24)));
    draw_verdict(ctx, {content.x, std::round(below), content.w, low}, verdict_of(signs));
    ui.end_panel();
}

constexpr View kView{"signs", kTitle, draw};
const RegisterView kRegistered(kView);

}  // namespace
}  // namespace texelscope::canvas::signs_view
