// The weights of a sample: three areas over the whole, as bars, and the bar of their sum.
#include "app/views/weights.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "app/lesson/facts.h"
#include "app/ui/text.h"
#include "app/ui/widgets.h"
#include "app/views/canvas_values.h"
#include "app/views/terms.h"

namespace texelscope {
namespace {

using ui::Role;

constexpr std::string_view kWeightsTitle = "Weights";
constexpr std::string_view kNoPoint = "Point at a pixel, or step into one: its three weights show here.";
constexpr std::string_view kPixel = "pixel {}, {}", kNotComputed = "not computed", kSum = "sum", kOutside = "outside";
constexpr std::string_view kTip = "$e_{}$ is the area between the sample and the side across from corner {}, over all.";
constexpr float kRow = 40, kBar = 9, kSumBar = 18, kMark = 4.5F;

class WeightsView {
public:
    WeightsView(const ViewContext& context, const ui::Area& area, const WeightedPoint& point)
        : context_(context), ui_(context.ui), area_(area), point_(point) {}

    void draw() {
        const float text = pitch(ui_, 18, ui::Face::code);
        const float row = std::max(ui_.px(kRow), text + ui_.px(kBar) + ui_.px(10));
        const float low = text + ui_.px(kSumBar) + ui_.px(18), content = 3 * row + low;
        foresee(ui_, "weights/scroll", content);
        const ui::Area inner = ui_.begin_scroll("weights/scroll", area_);
        for (int n = 0; n < 3; ++n)
            draw_weight(n, {inner.x, std::round(inner.y + static_cast<float>(n) * row), inner.w, row}, text);
        draw_sum({inner.x, std::round(inner.y + 3 * row), inner.w, low}, text);
        ui_.end_scroll(content);
    }

private:
    [[nodiscard]] ui::Color color(int n) const { return ui_.theme()[ui::edge_role(side_across(n))]; }

    void hatch(int n, const ui::Area& bar) {
        if (bar.w < 1) return;
        ui::fill(ui_.list(), bar, ui::with_alpha(color(n), .35F));
        const std::array<glm::vec2, 4> corners{
            {{bar.x, bar.y}, {bar.right(), bar.y}, {bar.right(), bar.bottom()}, {bar.x, bar.bottom()}}};
        ui::draw_hatch(ui_.list(), corners, ui::section_degrees(side_across(n)), ui_.px(6), {area_.x, area_.y},
                       ui_.px(2), color(n));
    }

    void draw_weight(int n, const ui::Area& row, float text) {
        const std::string name = fmt::format("e_{}", n), tip = fmt::format(kTip, n, n);
        const ui::Control control =
            ui_.control({fmt::format("weights/{}", n), row.inset(0, 1), ui::Kind::link, name, tip});
        act_on_name(context_, control, name);
        draw_light(ui_, row.inset(-ui_.px(4), 1), control.hovered ? Light::hovered : light_of_name(context_, name));
        const float middle = row.y + text / 2 + ui_.px(2), mark = ui_.px(kMark);
        ui::edge_mark(ui_.list(), side_across(n), {row.x + mark, middle}, mark, color(n));
        const ui::MathBox label = ui::set_math(ui::symbol(name), {.fonts = &ui_.fonts(), .size = ui::MathSize::row});
        const float x = row.x + 2 * mark + ui_.px(8);
        ui_.formula(label, {x, std::round(middle + label.ascent / 2)});
        const float left = x + label.width + ui_.px(8);
        const auto& e = point_.e[static_cast<std::size_t>(n)];
        const ui::Font& font = ui_.font(e ? ui::Face::code : ui::Face::title);
        const std::string shown = e ? shown_weight(*e) : std::string(kNotComputed);
        ui_.text_right(e ? ui::Face::code : ui::Face::title, {row.right(), ui::baseline_at_middle(font, middle)},
                       e ? Role::text : Role::muted, ui::elided(font, shown, row.right() - left));
        const ui::Area bar{row.x, row.y + text + ui_.px(4), row.w, ui_.px(kBar)};
        ui::fill(ui_.list(), bar, ui_.theme().raise);
        if (e) hatch(n, {bar.x, bar.y, std::round(bar.w * static_cast<float>(std::clamp(*e, 0.0, 1.0))), bar.h});
        ui::frame(ui_.list(), bar, ui_.theme()[Role::faint]);
    }
    [[nodiscard]] static std::string shown_weight(double e) {
        const ui::Number number = ui::format_number(e);
        return number.exact ? number.text : fmt::format("≈ {}", number.text);
    }

    /// The three bars behind one another: they fill the whole.
    void draw_sum(const ui::Area& place, float text) {
        ui::hairline(ui_, {place.x, place.y}, place.w);
        const ui::Font& font = ui_.font(ui::Face::title);
        const float middle = place.y + ui_.px(4) + text / 2;
        const float used =
            ui_.text(ui::Face::title, {place.x, ui::baseline_at_middle(font, middle)}, Role::muted, kSum);
        const bool all = point_.e[0] && point_.e[1] && point_.e[2];
        const std::string shown = all ? shown_weight(point_.sum()) : std::string(kOutside);
        const ui::Face face = all ? ui::Face::code_strong : ui::Face::title;
        ui_.text_right(face, {place.right(), ui::baseline_at_middle(ui_.font(face), middle)}, Role::text,
                       ui::elided(ui_.font(face), shown, place.w - used - ui_.px(8)));
        const ui::Area bar{place.x, place.y + text + ui_.px(8), place.w, ui_.px(kSumBar)};
        ui::fill(ui_.list(), bar, ui_.theme().raise);
        if (point_.inside) {
            float x = bar.x;
            for (int n = 0; n < 3; ++n) {
                const float w = bar.w * static_cast<float>(*point_.e[static_cast<std::size_t>(n)]);
                const float right = n == 2 ? std::min(bar.right(), std::round(x + w)) : std::round(x + w);
                hatch(n, {x, bar.y, right - x, bar.h});
                x = right;
                if (n < 2) ui::fill(ui_.list(), {x - 1, bar.y, 2, bar.h}, ui_.theme().panel);
            }
        }
        ui::frame(ui_.list(), bar, ui_.theme()[Role::faint]);
    }

    const ViewContext& context_;
    ui::Ui& ui_;
    ui::Area area_;
    const WeightedPoint& point_;
};

void draw(const ViewContext& context, const ui::Area& place) {
    const auto point = weighted_point(context);
    const std::string note = point ? fmt::format(kPixel, point->pixel.x, point->pixel.y) : std::string();
    const ui::Area area = begin_view(context, "weights", place, kWeightsTitle, note);
    if (!point)
        draw_empty(context, area, kNoPoint);
    else
        WeightsView(context, area, *point).draw();
    context.ui.end_panel();
}

constexpr View kView{"weights", kWeightsTitle, draw};
const RegisterView kRegistered(kView);

}  // namespace

std::optional<WeightedPoint> weighted_point(const ViewContext& context) {
    const Derived& derived = context.derived;
    if (!canvas::is_triangle(derived)) return std::nullopt;
    std::optional<glm::ivec2> pixel = derived.pixel();
    if (!canvas::pointing(context.state, Prediction::Kind::pixel).asked) {
        for (const Selection* s : {&context.state.pinned, &context.state.hover})
            if (s->kind == Selection::Kind::pixel) pixel = s->at;
    }
    if (!pixel) return std::nullopt;
    const auto path = derived.steps().at_pixel(derived.shape(), pixel->x, pixel->y);
    if (!path) return std::nullopt;
    WeightedPoint point{.pixel = *pixel, .e = {}, .inside = true};
    const Visit& visit = derived.steps().at(*path);
    for (int n = 0; n < 3; ++n) {
        const auto value = value_named(visit, fmt::format("e_{}", n));
        if (value && !undefined(*value)) point.e[static_cast<std::size_t>(n)] = approximate(*value);
        point.inside = point.inside && point.e[static_cast<std::size_t>(n)].value_or(-1) >= 0;
    }
    return point.e[0] ? std::optional(point) : std::nullopt;
}

}  // namespace texelscope
