#include "app/views/front_place.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "app/lesson/questions.h"
#include "app/state/lesson_cursor.h"
#include "app/ui/widgets.h"
#include "app/views/front_axes.h"

namespace texelscope {
namespace {

using ui::Role;

constexpr std::array<std::string_view, 3> kBands{"less than both", "between", "more than both"};
constexpr std::string_view kTip = "Click: here is its error";

}  // namespace

FrontPlace::FrontPlace(const State& state) {
    const Prediction* const asked = prediction_of(state);
    const Method* const method = find_method(state.work.method);
    if (asked == nullptr || method == nullptr) return;
    const auto call = parse_question(asked->answer, *method);
    if (!call || call->question->name != kErrorPlace) return;
    const auto& answers = state.work.answers;
    const auto own =
        std::find_if(answers.begin(), answers.end(), [&](const Answer& a) { return a.beat == state.cursor.beat; });
    if (own != answers.end() && own->verdict != Answer::Verdict::open) return;
    secret_ = call->words[0], beside_ = {call->words[1], call->words[2]};
    if (own != answers.end() && !own->chosen.empty()) chosen_ = own->chosen.front();
}

void FrontPlace::draw(const ViewContext& context, const ui::Area& area, std::span<const FrontPoint> points) const {
    if (secret_.empty()) return;
    ui::Ui& ui = context.ui;
    std::vector<const FrontPoint*> timed;
    for (const FrontPoint& point : points)
        if (point.min_ns > 0) timed.push_back(&point);
    const front::Axes axes(ui, area, timed);
    std::array<float, 2> heights{};
    for (std::size_t n = 0; n < 2; ++n) {
        const auto found =
            std::find_if(timed.begin(), timed.end(), [&](const FrontPoint* p) { return p->rung == beside_[n]; });
        if (found == timed.end()) return;
        heights[n] = axes.height_of((*found)->max_error);
    }
    const auto [high, low] = std::minmax(heights[0], heights[1]);  // more error stands higher
    const ui::Area& plot = axes.plot();
    const std::array<ui::Area, 3> bands{{{plot.x, low, plot.w, plot.bottom() - low},
                                         {plot.x, high, plot.w, low - high},
                                         {plot.x, plot.y, plot.w, high - plot.y}}};
    for (std::size_t n = 0; n < 3; ++n) {
        const bool chosen = chosen_ == static_cast<int>(n);
        const ui::Control control = ui.control({.name = kBands[n],
                                                .area = bands[n],
                                                .kind = ui::Kind::region,
                                                .label = kBands[n],
                                                .tip = kTip,
                                                .focusable = false});
        if (control.clicked) context.act(action::Choose{static_cast<int>(n)});
        const ui::Color color = ui.theme()[Role::now];
        if (chosen || control.hovered)
            ui::fill(ui.list(), bands[n], ui::with_alpha(color, chosen ? ui::alpha::kMark : ui::alpha::kRowBand));
        if (chosen) ui::frame(ui.list(), bands[n], color, 2);
        ui::line(ui.list(), {plot.x, std::round(bands[n].y)}, {plot.right(), std::round(bands[n].y)}, 1, color);
    }
}

}  // namespace texelscope
