// Run time against error of every method and number format, over the scene as it stands: measured here once a person
// asks, and again whenever the scene changes; a point is chosen, its numbers are read out, its faults marked on the
// canvas.
#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "app/state/front_key.h"
#include "app/ui/text.h"
#include "app/ui/widgets.h"
#include "app/views/front_place.h"
#include "app/views/front_plot.h"
#include "app/views/race_table.h"
#include "app/views/rung_marks.h"
#include "app/views/terms.h"
#include "app/views/tuning.h"

namespace texelscope::front_view {
namespace {

using ui::Area;
using ui::Face;
using ui::Role;

constexpr std::string_view kTitle = "Time against error";
constexpr std::string_view kNone =
    "This scene has no random triangles. Lesson 19 has; in a scene file they are "
    "`\"random\": { \"triangles\": 48, \"size\": 96 }`.";
constexpr std::string_view kSize = "size [px]", kSizeTip = "The side of the square that holds a triangle [px]";
constexpr std::string_view kDistance = "distance", kAtOrigin = "0", kPower = "2^{}",
                           kDistanceTip = "How far from the origin the whole picture lies [px], right and down";
constexpr std::array<std::string_view, 3> kKinds{"plain", "steep", "slivers"};
constexpr std::array<std::string_view, 3> kKindTitles{"Triangles", "Steep perspective", "Slivers"};
constexpr std::array<std::string_view, 3> kKindTips{
    "Triangles of all shapes", "Corners 1 to 16 times as far as the nearest", "Long triangles, 1/64 to 3 px wide"};
constexpr std::string_view kRun = "Run", kStop = "Stop",
                           kRunTip = "Measures here, and again whenever the scene changes", kStopTip = "Stop measuring";
constexpr std::string_view kEarlier = "measured earlier, elsewhere; Run does it here", kHere = "measured here",
                           kNotYet = "not measured yet: Run", kProgress = "{:.0f} %  {}";
constexpr std::string_view kPrevious = "faster", kNext = "slower", kPreviousTip = "The next faster one",
                           kNextTip = "The next slower one";
constexpr std::string_view kChoose = "Click a point: its name, and what it gets wrong.";
constexpr std::string_view kTime = "{} ns a pixel", kError = "error {}", kBound = "bound {}";
constexpr std::string_view kPointTip = "{}: {} ns a pixel, greatest error {} texels";
constexpr float kLeastPlot = 210, kLeastPlotLines = 15;  ///< height [px at 100 %], and in lines of text
constexpr float kWholePlotLines = 9;  ///< so high, a plot that is seen whole is better than one that must be scrolled
constexpr float kLeastTrack = 70;     ///< of a slider [px at 100 %]
constexpr ui::SliderRange kSizes{4, 120, 4}, kDistances{0, kMaxDistance, 1};

class FrontView {
public:
    FrontView(const ViewContext& context, const Area& area, const RandomTriangles& random)
        : context_(context), ui_(context.ui), area_(area), random_(random), place_(context.state) {
        const std::string key = front_key(context.derived.scene(), context.state.work);
        const Measure& measure = context.state.measure;
        here_ = measure.what == Measure::What::front && !measure.front.empty();
        for (const FrontPoint& point : here_ ? measure.front : context.state.document->front)
            if ((here_ || point.scene == key) && point.rung != place_.secret()) points_.push_back(point);
        for (FrontPoint& point : points_) point.scene = title();
    }

    void draw() {
        const float controls = static_cast<float>(control_lines() + 1) * line_of_controls();
        const float line = ui_.font(Face::title).em;
        const float plot =
            std::max(kWholePlotLines * line, std::min(std::max(ui_.px(kLeastPlot), kLeastPlotLines * line), area_.h));
        const float content = std::max(area_.h, controls + readout_height() + plot);
        foresee(ui_, "front/scroll", content);
        const Area inner = ui_.begin_scroll("front/scroll", area_);
        // The plot comes first: where not all has room, it is what is to be seen.
        const float below = inner.y + content - controls;
        draw_plot({inner.x, inner.y, inner.w, content - controls - readout_height()});
        draw_readout({inner.x, below - readout_height(), inner.w, readout_height()});
        draw_run({inner.x, below, inner.w, tuning_height(ui_)});
        draw_controls({inner.x, below + line_of_controls(), inner.w, tuning_height(ui_)});
        ui_.end_scroll(content);
    }

private:
    [[nodiscard]] std::string title() const {
        const auto kind = kKindTitles[static_cast<std::size_t>(random_.kind)];
        return random_.distance == 0 ? std::string(kind)
                                     : fmt::format("{}, {} px away", kind, grouped(std::ldexp(1, random_.distance)));
    }
    [[nodiscard]] float line() const { return pitch(ui_, 20, Face::title); }
    [[nodiscard]] float readout_height() const { return 2 * std::max(line(), tuning_height(ui_)) + ui_.px(4); }

    // -- what is measured
    void act(const RandomTriangles& next) {
        if (!(next == random_))
            context_.act(action::SetRandom{next, ui_.memory().active != 0 ? ui_.memory().presses : 0});
    }
    [[nodiscard]] float line_of_controls() const { return tuning_height(ui_) + ui_.px(2); }
    [[nodiscard]] int control_lines() const { return (3 + beside() - 1) / beside(); }
    [[nodiscard]] int beside() const {
        const float least = ui::text_width(ui_.font(Face::prose), kDistance) +
                            ui::text_width(ui_.font(Face::code), "-180°") + ui_.px(kLeastTrack);
        return std::clamp(static_cast<int>(area_.w / least), 1, 3);
    }
    void draw_controls(const Area& row) {
        const float gap = ui_.px(12), count = static_cast<float>(beside());
        const float width = std::floor((row.w - (count - 1) * gap) / count);
        const auto place = [&](int n) {
            const int column = n % beside(), line = n / beside();
            return Area{row.x + static_cast<float>(column) * (width + gap),
                        row.y + static_cast<float>(line) * line_of_controls(), width, row.h};
        };
        RandomTriangles next = random_;
        if (const auto kind = ui::segments(ui_, "front/kind", place(0), kKinds, static_cast<int>(random_.kind),
                                           kKindTips, Face::note))
            next.kind = static_cast<RandomKind>(*kind);
        const std::string far = random_.distance == 0 ? std::string(kAtOrigin) : fmt::format(kPower, random_.distance);
        if (const auto to = draw_tuning(ui_, place(1), {"front/distance", kDistance, far, kDistanceTip},
                                        random_.distance, kDistances))
            next.distance = static_cast<int>(std::round(*to));
        if (const auto to =
                draw_tuning(ui_, place(2), {"front/size", kSize, fmt::format("{:g}", random_.size), kSizeTip},
                            double{random_.size}, kSizes))
            next.size = static_cast<float>(std::max(1.0, std::round(*to)));
        act(next);
    }
    [[nodiscard]] std::string hint() const {
        const Measure& measure = context_.state.measure;
        if (measure.what == Measure::What::front && measure.running)
            return fmt::format(kProgress, 100 * measure.share, measure.doing);
        return std::string(here_ ? kHere : points_.empty() ? kNotYet : kEarlier);
    }
    void draw_run(const Area& row) {
        const Measure& measure = context_.state.measure;
        const bool on = measure.what == Measure::What::front && measure.live;
        const float width = std::max(ui::button_width(ui_, kRun), ui::button_width(ui_, kStop));
        if (ui::toggle(ui_, "front/run", {row.x, row.y, width, row.h}, on ? kStop : kRun, on, on ? kStopTip : kRunTip)
                .clicked)
            context_.act(action::StartMeasure{Measure::What::front, !on});
        const float x = row.x + width + ui_.px(10);
        ui_.text_within(Face::title, {x, ui::baseline_at_middle(ui_.font(Face::title), row.centre().y)},
                        row.right() - x, Role::muted, hint());
    }

    // -- the plot
    void choose(const std::string& rung) {
        Look look = context_.state.look;
        look.rung = look.rung == rung ? std::string() : rung;
        context_.act(action::SetLook{look});
    }
    void draw_plot(const Area& place) {
        if (points_.empty()) return draw_empty(context_, place, hint());
        const FrontPoint* const under = draw_front_plot(ui_, place, points_, context_.state.look.rung);
        const std::string tip = under == nullptr ? std::string()
                                                 : fmt::format(kPointTip, under->label, brief(under->min_ns),
                                                               front_number(under->max_error));
        if (!place_.secret().empty()) return place_.draw(context_, place, points_);
        const ui::Control region = ui_.control({.name = "front/plot",
                                                .area = place,
                                                .kind = ui::Kind::region,
                                                .label = kTitle,
                                                .tip = tip,
                                                .focusable = false});
        if (region.clicked && under != nullptr) choose(under->rung);
    }

    // -- the chosen point
    [[nodiscard]] std::vector<const FrontPoint*> by_time() const {
        std::vector<const FrontPoint*> all;
        for (const FrontPoint& point : points_) all.push_back(&point);
        std::stable_sort(all.begin(), all.end(),
                         [](const FrontPoint* a, const FrontPoint* b) { return a->min_ns < b->min_ns; });
        return all;
    }
    /// @return how much of the row it took.
    float draw_arrows(const Area& row, const std::vector<const FrontPoint*>& all, int chosen) {
        const float side = tuning_height(ui_), gap = ui_.px(4);
        const auto count = static_cast<int>(all.size());
        for (const int way : {-1, 1}) {
            const Area place{row.x + (way > 0 ? side + gap : 0), row.y, side, side};
            const int to = chosen < 0 ? (way > 0 ? 0 : count - 1) : chosen + way;
            const bool more = to >= 0 && to < count;
            if (ui::icon_button(ui_, way < 0 ? "front/previous" : "front/next", place,
                                way < 0 ? ui::Icon::previous : ui::Icon::next, way < 0 ? kPrevious : kNext,
                                way < 0 ? kPreviousTip : kNextTip, {.enabled = more})
                    .clicked &&
                more)
                choose(all[static_cast<std::size_t>(to)]->rung);
        }
        return 2 * side + gap + ui_.px(10);
    }
    void draw_readout(const Area& place) {
        const std::vector<const FrontPoint*> all = by_time();
        const auto found = std::find_if(all.begin(), all.end(),
                                        [&](const FrontPoint* p) { return p->rung == context_.state.look.rung; });
        const int chosen = found == all.end() ? -1 : static_cast<int>(found - all.begin());
        const float high = std::max(line(), tuning_height(ui_));
        const Area first{place.x, place.y + ui_.px(4), place.w, high}, second{place.x, first.bottom(), place.w, high};
        float x = first.x + draw_arrows(first, all, chosen);
        const float baseline = ui::baseline_at_middle(ui_.font(Face::title), first.centre().y);
        if (chosen < 0)
            return void(ui_.text_within(Face::title, {x, baseline}, first.right() - x, Role::muted, kChoose));
        const FrontPoint& p = **found;
        const auto say = [&](Face face, Role role, const std::string& text) {
            x += ui_.text_within(face, {x, baseline}, std::max(0.0F, first.right() - x), role, text) + ui_.px(14);
        };
        say(Face::code_strong, Role::text, p.label);
        say(Face::code, Role::text, fmt::format(kError, front_number(p.max_error)));
        say(Face::code, Role::muted, fmt::format(kBound, front_number(p.bound)));
        say(Face::code, Role::muted, fmt::format(kTime, brief(p.min_ns)));
        if (const Rung* rung = find_rung(p.rung)) draw_rung_legend(context_, second, *rung);
    }

    const ViewContext& context_;
    ui::Ui& ui_;
    Area area_;
    const RandomTriangles& random_;
    FrontPlace place_;
    std::vector<FrontPoint> points_;
    bool here_ = false;  ///< the points were measured in this run of the program
};

void draw(const ViewContext& context, const Area& place) {
    const Area area = begin_view(context, "front", place, kTitle);
    const auto& random = context.derived.scene().random;
    if (random && context.state.document)
        FrontView(context, area, *random).draw();
    else
        draw_empty(context, area, kNone);
    context.ui.end_panel();
}

constexpr View kView{"front", kTitle, draw};
const RegisterView kRegistered(kView);

}  // namespace
}  // namespace texelscope::front_view
