#include "app/views/front_axes.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "app/ui/text.h"

namespace texelscope::front {
namespace {

using ui::Face;
using ui::Role;

constexpr std::string_view kTime = "time of a pixel [ns]", kError = "greatest error of u or v [texels]";
constexpr std::string_view kNone = "no error", kEndless = "not a number", kTexel = "1 texel";
constexpr double kLeast = 1e-15, kMost = 1e6;                 ///< the scale of errors goes no further [texels]
constexpr double kTimeMargin = 1.7;                           ///< beyond the fastest and the slowest point, as a factor
constexpr float kShelf = 34, kTop = 24, kFrontAxesLine = 16;  ///< [px at 100 %]
constexpr float kMostShelf = .2F;                             ///< of a low plot
constexpr float kLeastLines = 1.15F;                          ///< from one line to the next, in letters' heights
constexpr float kFaintGrid = .45F;
constexpr float kCapitals = .75F;  ///< their height in letters' heights
constexpr float kRoundMark = 14;   ///< from a mark's middle to text beside it, at least [px at 100 %]

[[nodiscard]] int decade_below(double value) { return static_cast<int>(std::floor(std::log10(value) + 1e-9)); }
[[nodiscard]] int decade_above(double value) { return static_cast<int>(std::ceil(std::log10(value) - 1e-9)); }
[[nodiscard]] double ten_to(int exponent) { return std::pow(10.0, exponent); }

/// 500, 2k, 1M.
[[nodiscard]] std::string brief(double value) {
    if (value > 999'999) return fmt::format("{:g}M", value / 1e6);
    return value > 999 ? fmt::format("{:g}k", value / 1e3) : fmt::format("{:g}", value);
}

}  // namespace

float Scale::at(double value) const {
    const double share = std::log10(value / low) / std::log10(high / low);
    return from + (to - from) * static_cast<float>(std::clamp(share, 0.0, 1.0));
}

Axes::Axes(ui::Ui& ui, const ui::Area& area, std::span<const FrontPoint* const> points) : ui_(ui), area_(area) {
    const float left =
        ui::text_width(ui.font(Face::code_note), "10") + ui::text_width(ui.font(Face::ruler), "-15") + ui.px(12);
    // In a hall letters grow more than all else does.
    line_ = std::max(ui.px(kFrontAxesLine), kLeastLines * ui.font(Face::note).em);
    const float top = std::max(ui.px(3 * kFrontAxesLine), 2.2F * line_), bottom = 2 * line_;
    plot_ = {area.x + left, area.y + top, area.w - left, area.h - top - bottom};
    shelf_ = std::min(ui.px(kShelf), kMostShelf * plot_.h);
    double least = 1, most = 1, fastest = 1e9, slowest = 0;
    for (const FrontPoint* p : points) {
        endless_ = endless_ || std::isinf(p->max_error);
        for (const double error : {p->max_error, p->bound})
            if (error > 0 && std::isfinite(error)) least = std::min(least, error), most = std::max(most, error);
        fastest = std::min(fastest, p->min_ns), slowest = std::max(slowest, p->min_ns);
    }
    if (points.empty()) fastest = 1, slowest = 100;
    time_ = {fastest / kTimeMargin, slowest * kTimeMargin, plot_.x, plot_.right()};
    error_ = {std::max(ten_to(decade_below(least)), kLeast), std::clamp(ten_to(decade_above(most * 1.01)), 10.0, kMost),
              plot_.bottom() - shelf_ - ui.px(8), plot_.y + (endless_ ? ui.px(kTop) : 0.0F)};
    for (const FrontPoint* p : points) {
        if (p->max_error == 0) exact_marks_.push_back(time_.at(p->min_ns));
        if (std::isinf(p->max_error)) endless_marks_.push_back(time_.at(p->min_ns));
    }
    std::sort(exact_marks_.begin(), exact_marks_.end()), std::sort(endless_marks_.begin(), endless_marks_.end());
}

glm::vec2 Axes::place_of(const FrontPoint& point) const { return {time_.at(point.min_ns), height_of(point.max_error)}; }

float Axes::height_of(double error) const {
    if (std::isinf(error)) return plot_.y + ui_.px(kTop) / 2;
    return error > 0 ? error_.at(error) : plot_.bottom() - shelf_ / 2;
}

void Axes::draw() const {
    const ui::Theme& theme = ui_.theme();
    ui_.text_within(Face::note, {plot_.x, plot_.y - ui_.px(6)}, plot_.w, Role::muted, kError);
    ui::fill(ui_.list(), plot_, theme.canvas);
    draw_times();
    draw_errors();
    shelf({plot_.x, plot_.bottom() - shelf_, plot_.w, shelf_}, Role::now, kNone, exact_marks_);
    if (endless_) shelf({plot_.x, plot_.y, plot_.w, ui_.px(kTop)}, Role::error, kEndless, endless_marks_);
    const float zero = height_of(0);
    ui_.text_right(Face::code_note, {plot_.x - ui_.px(6), ui::baseline_at_middle(ui_.font(Face::code_note), zero)},
                   Role::text, "0");
    ui::frame(ui_.list(), plot_, theme.hairline);
}

/// Its name stands in the rightmost gap between its marks that has room for it.
void Axes::shelf(const ui::Area& area, Role role, std::string_view name, std::span<const float> marks) const {
    const ui::Theme& theme = ui_.theme();
    const float wash = role == Role::now ? 1.4F * ui::alpha::kRowBand : ui::alpha::kRowBand;
    ui::fill(ui_.list(), area, ui::over(theme[role], wash, theme.canvas));
    const float width = ui::text_width(ui_.font(Face::note), name), room = width + 2 * ui_.px(kRoundMark);
    float right = plot_.right();
    for (auto mark = marks.rbegin(); mark != marks.rend() && right - *mark < room; ++mark) right = *mark;
    const auto before = std::lower_bound(marks.begin(), marks.end(), right);
    const float left = before == marks.begin() ? plot_.x : *(before - 1);
    if (right - left < room) return;
    const float at = right == plot_.right() ? right - ui_.px(6) - width : (left + right - width) / 2;
    ui_.text(Face::note, {at, area.bottom() - ui_.px(4)}, Role::muted, name);
}

void Axes::draw_times() const {
    const ui::Theme& theme = ui_.theme();
    const ui::Font& font = ui_.font(Face::code_note);
    // Whole decades get their numbers first, 2 and 5 where there is room left.
    std::vector<ui::Area> taken;
    for (const bool whole : {true, false})
        for (int exponent = decade_below(time_.low); exponent <= decade_above(time_.high); ++exponent)
            for (int n = 1; n < 10; ++n) {
                const double value = n * ten_to(exponent);
                if (whole != (n == 1) || value < time_.low || value > time_.high) continue;
                const float x = std::round(time_.at(value));
                ui::line(ui_.list(), {x, plot_.y}, {x, plot_.bottom()}, 1,
                         ui::with_alpha(theme.grid, whole ? 1 : kFaintGrid));
                if (n != 1 && n != 2 && n != 5) continue;
                const std::string text = brief(value);
                const float width = ui::text_width(font, text);
                const ui::Area at{x - width / 2 - ui_.px(5), plot_.bottom(), width + ui_.px(10), 1};
                const auto meets = [&](const ui::Area& other) { return !ui::intersection(at, other).empty(); };
                if (at.right() > area_.right() + ui_.px(5) || std::any_of(taken.begin(), taken.end(), meets)) continue;
                taken.push_back(at);
                ui_.text(Face::code_note, {x - width / 2, plot_.bottom() + .875F * line_}, Role::muted, text);
            }
    ui_.text_right(Face::note, {plot_.right(), plot_.bottom() + 1.75F * line_}, Role::muted, kTime);
}

void Axes::power(float right, float middle, int exponent) const {
    const std::string digits = fmt::format("{}", exponent);
    const float width = ui::text_width(ui_.font(Face::ruler), digits);
    const float y = ui::baseline_at_middle(ui_.font(Face::code_note), middle);
    ui_.text(Face::ruler, {right - width, y - ui_.px(5)}, Role::muted, digits);
    ui_.text_right(Face::code_note, {right - width - 1, y}, Role::muted, "10");
}

void Axes::draw_errors() const {
    const ui::Theme& theme = ui_.theme();
    const int first = decade_below(error_.low), last = decade_above(error_.high);
    const float pitch = (error_.from - error_.to) / static_cast<float>(std::max(1, last - first));
    const int every = std::max(1, static_cast<int>(std::ceil(1.125F * line_ / pitch)));
    for (int exponent = first; exponent <= last; ++exponent) {
        const float y = std::round(error_.at(ten_to(exponent)));
        const bool labelled = exponent % every == 0;
        ui::line(ui_.list(), {plot_.x, y}, {plot_.right(), y}, 1,
                 exponent == 0 ? theme[Role::faint] : ui::with_alpha(theme.grid, labelled ? 1 : kFaintGrid));
        if (labelled) power(plot_.x - ui_.px(6), y, exponent);
        const float above = y - ui_.px(4);
        if (exponent == 0 && above - kCapitals * ui_.font(Face::note).em > plot_.y)
            ui_.text_right(Face::note, {plot_.right() - ui_.px(6), above}, Role::muted, kTexel);
    }
}

}  // namespace texelscope::front
