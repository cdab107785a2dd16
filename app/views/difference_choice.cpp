#include "app/views/difference_choice.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "app/state/compared_run.h"
#include "app/ui/text.h"
#include "app/ui/widgets.h"
#include "app/views/screen_parts.h"
#include "app/views/terms.h"

namespace texelscope::canvas {
namespace {

constexpr std::string_view kAgainst = "against {}";
constexpr std::string_view kPrevious = "previous method", kNext = "next method";
constexpr std::string_view kMethodTip = "Compares with another method, or with this one run otherwise.",
                           kVariantTip = "Compares with its next variant.",
                           kNumberTip = "Compares with its next number format.";

/// The index `by` places behind that of `id`, round and round.
[[nodiscard]] std::size_t behind(const auto& list, std::string_view id, auto id_of_entry, std::size_t by = 1) {
    const auto at = std::find_if(list.begin(), list.end(), [&](const auto& entry) { return id_of_entry(entry) == id; });
    return (static_cast<std::size_t>(at - list.begin()) + by) % list.size();
}

}  // namespace

RunChoice::RunChoice(const ViewContext& context, float width)
    : ctx_(context),
      ui_(context.ui),
      line_(std::max(ui_.px(28), pitch(ui_, 24, ui::Face::title))),
      side_(line_ - ui_.px(4)) {
    float title = 0;
    for (const Method* method : methods()) {
        title = std::max(title, ui::text_width(ui_.font(ui::Face::title), fmt::format(kAgainst, method->title)));
        for (const VariantInfo& variant : method->variants)
            variant_ = std::max(variant_, ui::button_width(ui_, spaced(variant.id), ui::Face::note));
    }
    for (const NumberFormatInfo& info : kNumberFormats)
        number_ = std::max(number_, ui::button_width(ui_, info.id, ui::Face::note));
    const float gaps = ui_.px(32);
    one_line_ = width >= 2 * side_ + title + variant_ + number_ + gaps;
    const float most = width - ui_.px(4);
    variant_ = std::min(variant_, most * .65F), number_ = std::min(number_, most * .35F);
}

void RunChoice::draw(const ui::Area& bar) const {
    const ComparedRun now = completed(ctx_.state.look.other, ctx_.derived.drawing().settings());
    ComparedRun next = now;
    draw_method(bar, now, next);
    draw_variant_and_number(bar, now, next);
    if (next == now) return;
    Look look = ctx_.state.look;
    look.other = completed(next, ctx_.derived.drawing().settings());
    ctx_.act(action::SetLook{look});
}

void RunChoice::draw_method(const ui::Area& bar, const ComparedRun& now, ComparedRun& next) const {
    const float y = bar.y + std::floor((line_ - side_) / 2);
    const auto arrow = [&](float x, ui::Icon icon, std::string_view name, std::string_view label) {
        return ui::icon_button(ui_, name, {x, y, side_, side_}, icon, label, kMethodTip, {.quiet = true}).clicked;
    };
    const auto take = [&](std::size_t by) {
        const auto id = [](const Method* method) { return method->id; };
        next = {std::string(methods()[behind(methods(), now.method, id, by)]->id), "", now.format};
    };
    if (arrow(bar.x, ui::Icon::previous, "difference/previous", kPrevious)) take(methods().size() - 1);
    if (arrow(bar.x + side_ + ui_.px(4), ui::Icon::next, "difference/next", kNext)) take(1);
    const float x = bar.x + 2 * side_ + ui_.px(12);
    const float right = one_line_ ? bar.right() - variant_ - number_ - ui_.px(12) : bar.right();
    ui_.text_within(ui::Face::title, {x, ui::baseline_at_middle(ui_.font(ui::Face::title), y + side_ / 2)}, right - x,
                    ui::Role::text, fmt::format(kAgainst, find_method(now.method)->title));
}

/// Behind the method's name, or below it from the left.
void RunChoice::draw_variant_and_number(const ui::Area& bar, const ComparedRun& now, ComparedRun& next) const {
    const auto& variants = find_method(now.method)->variants;
    const float y = bar.bottom() - line_ + std::floor((line_ - side_) / 2), gap = ui_.px(4);
    const float x = one_line_ ? bar.right() - variant_ - number_ - gap : bar.x;
    const auto choice = [&](std::string_view name, const ui::Area& at, std::string_view text, std::string_view tip,
                            bool enabled) {
        return ui::button(ui_, name, at, text, tip, {.face = ui::Face::note, .enabled = enabled}).clicked;
    };
    if (choice("difference/variant", {x, y, variant_, side_}, spaced(now.variant), kVariantTip, variants.size() > 1))
        next.variant = variants[behind(variants, now.variant, [](const VariantInfo& v) { return v.id; })].id;
    const std::string_view format = id_of(*now.format);
    if (choice("difference/number", {x + variant_ + gap, y, number_, side_}, format, kNumberTip, true))
        next.format =
            kNumberFormats[behind(kNumberFormats, format, [](const NumberFormatInfo& n) { return n.id; })].format;
}

}  // namespace texelscope::canvas
