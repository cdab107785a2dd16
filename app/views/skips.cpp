// Work that is not done: each skip with a switch, what it drops, what drawing takes without it, and that the picture is
// the same. Skips are those of core/fast/raster.h, as many as there are.
#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "app/state/lesson_cursor.h"
#include "app/ui/text.h"
#include "app/ui/widgets.h"
#include "app/views/race_table.h"
#include "app/views/terms.h"
#include "app/views/tuning.h"

namespace texelscope::skips_view {
namespace {

using ui::Area;
using ui::Face;
using ui::Role;

constexpr std::string_view kTitle = "Skips";
constexpr std::string_view kNone =
    "This scene has no random triangles. Lesson 21 has; in a scene file they are "
    "`\"random\": { \"triangles\": 1000, \"size\": 8, \"waste\": 90 }`, with `\"depth\": \"less\"`.";
constexpr std::string_view kWaste = "waste", kWasteText = "{} %",
                           kWasteTip = "How many of the triangles show nothing, for one reason or another";
constexpr std::string_view kCount = "triangles", kCountTip = "How many are sent to be drawn";
constexpr std::string_view kSize = "size [px]", kSizeTip = "The side of the square that holds a triangle [px]";
constexpr std::string_view kDropped = "triangles", kWithout = "without it", kAllRow = "no skip at all",
                           kDrawnRow = "drawn";
constexpr std::string_view kAllTip = "What all of them together save. Click: all off, or all on again";
constexpr std::string_view kSkipTip = "{} Click: {}";
constexpr std::string_view kTurnOff = "switch it off", kTurnOn = "switch it on";
constexpr std::string_view kSame = "The picture is the same: 0 of {} pixels differ.",
                           kDiffer = "{} of {} pixels differ: that would be a fault.";
constexpr std::string_view kRun = "Run", kStop = "Stop", kRunTip = "Times the scene here, with and without each skip",
                           kStopTip = "Stop timing";
constexpr std::string_view kNotYet = "Run times them here", kProgress = "{:.0f} %",
                           kTimes = "all on {} ms, as switched {} ms: {}";
constexpr std::string_view kTimesAs = "×{:.2f}", kSecret = "Your answer first: the numbers follow.";
constexpr std::array<double, 9> kCounts{20, 50, 100, 200, 500, 1000, 2000, 5000, kMostTriangles};
constexpr float kLeastTrack = 60, kBarShare = .9F;  ///< of a slider [px at 100 %]; of a bar's place
constexpr ui::SliderRange kWastes{0, kMaxWaste, 5}, kSizes{2, 64, 2};

class SkipsView {
public:
    SkipsView(const ViewContext& context, const Area& area, const RandomTriangles& random)
        : context_(context),
          ui_(context.ui),
          area_(area),
          random_(random),
          count_(context.derived.skip_count()),
          row_(row_height()),
          name_(widest_name()),
          number_(ui::text_width(context.ui.font(Face::code), "000,000") + context.ui.px(12)),
          secret_(is_secret(context.state)) {}

    void draw() {
        const float content = run({0, 0, area_.w, area_.h}, false);
        foresee(ui_, "skips/scroll", content);
        const Area inner = ui_.begin_scroll("skips/scroll", area_);
        ui_.end_scroll(run(inner, true));
    }

private:
    /// How many must be drawn is asked for, and the answer is still open.
    [[nodiscard]] static bool is_secret(const State& state) {
        const Prediction* const asked = prediction_of(state);
        if (asked == nullptr || !asked->answer.starts_with("needed")) return false;
        const auto& answers = state.work.answers;
        const auto own =
            std::find_if(answers.begin(), answers.end(), [&](const Answer& a) { return a.beat == state.cursor.beat; });
        return own == answers.end() || own->verdict == Answer::Verdict::open;
    }
    /// As high as the view has room for.
    [[nodiscard]] float row_height() const {
        const float least = std::max(pitch(ui_, 22, Face::code), ui::size::kLeastTarget), most = 1.5F * least;
        const float rows = static_cast<float>(kRasterSkips.size()) + 4, rest = 2 * tuning_height(ui_) + ui_.px(20);
        return std::clamp(std::floor((area_.h - rest) / rows), least, most);
    }
    [[nodiscard]] float widest_name() const {
        float widest = ui::text_width(ui_.font(Face::title), kAllRow);
        for (const RasterSkipInfo& info : kRasterSkips)
            widest = std::max(widest, ui::text_width(ui_.font(Face::title), info.id));
        return std::min(widest + ui_.px(40), area_.w * .4F);
    }

    /// Goes through all parts, drawing them or only measuring. @return the height of all.
    [[nodiscard]] float run(const Area& inner, bool draws) {
        draws_ = draws;
        float y = draw_controls(inner, inner.y + ui_.px(2));
        if (secret_) return say_line(inner, y, Role::muted, std::string(kSecret)) - inner.y;
        y = draw_run(inner, y + ui_.px(2));
        y = draw_head(inner, y);
        for (const RasterSkipInfo& info : kRasterSkips) {
            const auto n = static_cast<std::size_t>(info.skip);
            draw_row({inner.x, y, inner.w, row_}, info.id, std::string(info.sentence), is_on(info.skip),
                     count_.counters.skipped[n], time_of(without(info.skip)));
            y += row_;
        }
        draw_all({inner.x, y, inner.w, row_});
        y += row_;
        draw_drawn({inner.x, y, inner.w, row_});
        y += row_ + ui_.px(2);
        const auto pixels = static_cast<double>(context_.derived.scene().framebuffer.width) *
                            context_.derived.scene().framebuffer.height;
        const bool same = count_.differs == 0;
        return say_line(inner, y, same ? Role::text : Role::error,
                        same ? fmt::format(kSame, grouped(pixels))
                             : fmt::format(kDiffer, grouped(static_cast<double>(count_.differs)), grouped(pixels))) -
               inner.y;
    }
    float say_line(const Area& inner, float y, Role role, const std::string& text) {
        if (draws_) say({inner.x, y, inner.w, row_}, Face::title, inner.x, inner.w, role, text);
        return y + row_;
    }
    void say(const Area& row, Face face, float x, float width, Role role, std::string_view text) {
        ui_.text_within(face, {x, ui::baseline_at_middle(ui_.font(face), row.centre().y)}, width, role, text);
    }
    void say_right(const Area& row, Face face, float right, Role role, std::string_view text) {
        ui_.text_right(face, {right, ui::baseline_at_middle(ui_.font(face), row.centre().y)}, role, text);
    }

    // -- what is drawn
    float draw_controls(const Area& inner, float y) {
        const float high = tuning_height(ui_), gap = ui_.px(16);
        const float least = ui::text_width(ui_.font(Face::prose), kCount) +
                            ui::text_width(ui_.font(Face::code), "10,000") + ui_.px(kLeastTrack);
        const int beside = std::clamp(static_cast<int>((inner.w + gap) / (least + gap)), 1, 3);
        const float width = std::floor((inner.w - gap * static_cast<float>(beside - 1)) / static_cast<float>(beside));
        const auto place = [&](int n) {
            const int column = n % beside, line = n / beside;
            return Area{inner.x + static_cast<float>(column) * (width + gap),
                        y + static_cast<float>(line) * (high + ui_.px(2)), width, high};
        };
        const int lines = (3 + beside - 1) / beside;
        if (!draws_) return y + static_cast<float>(lines) * (high + ui_.px(2));
        RandomTriangles next = random_;
        if (const auto to =
                draw_tuning(ui_, place(0), {"skips/waste", kWaste, fmt::format(kWasteText, random_.waste), kWasteTip},
                            random_.waste, kWastes))
            next.waste = static_cast<int>(std::round(*to));
        const auto* const at = std::lower_bound(kCounts.begin(), kCounts.end(), random_.count);
        if (const auto to = draw_tuning(ui_, place(1), {"skips/count", kCount, grouped(random_.count), kCountTip},
                                        static_cast<double>(at - kCounts.begin()), {0, kCounts.size() - 1, 1}))
            next.count = static_cast<int>(kCounts[static_cast<std::size_t>(std::round(*to))]);
        if (const auto to =
                draw_tuning(ui_, place(2), {"skips/size", kSize, fmt::format("{:g}", random_.size), kSizeTip},
                            double{random_.size}, kSizes))
            next.size = static_cast<float>(std::round(*to));
        if (!(next == random_))
            context_.act(action::SetRandom{next, ui_.memory().active != 0 ? ui_.memory().presses : 0});
        return y + static_cast<float>(lines) * (high + ui_.px(2));
    }

    // -- time
    [[nodiscard]] const Measure& measure() const { return context_.state.measure; }
    [[nodiscard]] bool measures() const { return measure().what == Measure::What::skips; }
    /// With those skips [s]; 0 where it is not known.
    [[nodiscard]] double time_of(std::uint32_t skips) const {
        if (!measures()) return 0;
        for (const SkipTime& time : measure().skips)
            if (time.skips == skips) return time.seconds;
        return 0;
    }
    [[nodiscard]] std::string hint() const {
        const double all = time_of(kAllSkips), own = time_of(context_.state.look.skips);
        if (all > 0 && own > 0) return fmt::format(kTimes, ms(all), ms(own), fmt::format(kTimesAs, own / all));
        if (measures() && measure().running) return fmt::format(kProgress, 100 * measure().share);
        return std::string(kNotYet);
    }
    [[nodiscard]] static std::string ms(double seconds) { return brief(seconds * 1e3); }
    float draw_run(const Area& inner, float y) {
        const float high = tuning_height(ui_);
        if (draws_) {
            const Area row{inner.x, y, inner.w, high};
            const bool on = measures() && measure().live;
            const float width = std::max(ui::button_width(ui_, kRun), ui::button_width(ui_, kStop));
            if (ui::toggle(ui_, "skips/run", {row.x, row.y, width, row.h}, on ? kStop : kRun, on,
                           on ? kStopTip : kRunTip)
                    .clicked)
                context_.act(action::StartMeasure{Measure::What::skips, !on});
            const float x = row.x + width + ui_.px(10);
            say(row, Face::title, x, row.right() - x, Role::muted, hint());
        }
        return y + high + ui_.px(4);
    }

    // -- the bill
    [[nodiscard]] bool is_on(RasterSkip skip) const {
        return (context_.state.look.skips >> static_cast<unsigned>(skip) & 1U) != 0;
    }
    void set(std::uint32_t skips) {
        Look look = context_.state.look;
        look.skips = skips;
        context_.act(action::SetLook{look});
    }
    float draw_head(const Area& inner, float y) {
        if (draws_) {
            const Area row{inner.x, y, inner.w, row_};
            say_right(row, Face::title, row.right() - number_ - ui_.px(4), Role::muted, kDropped);
            say_right(row, Face::title, row.right() - ui_.px(4), Role::muted, kWithout);
            ui::hairline(ui_, {inner.x, row.bottom()}, inner.w);
        }
        return y + row_ + ui_.px(2);
    }
    [[nodiscard]] Area bar_place(const Area& row) const {
        const float x = row.x + name_, right = row.right() - 2 * number_;
        return {x, row.y + std::round(row.h * .2F), std::max(0.0F, right - x) * kBarShare, std::round(row.h * .6F)};
    }
    [[nodiscard]] float length(const Area& place, double triangles) const {
        const auto all = static_cast<double>(std::max<std::uint64_t>(1, count_.counters.triangles));
        return std::round(place.w * static_cast<float>(std::min(1.0, triangles / all)));
    }
    void draw_box(const Area& row, bool on) {
        const float side = std::round(ui_.font(Face::title).em * .95F);
        const Area box{row.x + ui_.px(6), std::round(row.centre().y - side / 2), side, side};
        ui::frame(ui_.list(), box, ui_.theme()[on ? Role::now : Role::muted], 1.5F, 2);
        if (on) ui::draw_icon(ui_.list(), ui::Icon::tick, box, ui_.theme()[Role::now]);
    }
    /// One skip: its switch and name, a bar of what it drops, the count, the time without it against that with all.
    void draw_row(const Area& row, std::string_view id, const std::string& sentence, bool on, std::uint64_t dropped,
                  double seconds) {
        if (!draws_) return;
        const std::string name = fmt::format("skips/{}", id);
        const ui::Control control = ui_.control({.name = name,
                                                 .area = row,
                                                 .kind = ui::Kind::button,
                                                 .label = id,
                                                 .tip = fmt::format(kSkipTip, sentence, on ? kTurnOff : kTurnOn)});
        if (control.clicked)
            for (const RasterSkipInfo& info : kRasterSkips)
                if (info.id == id) set(context_.state.look.skips ^ (1U << static_cast<unsigned>(info.skip)));
        if (control.hovered) ui::frame(ui_.list(), row, ui_.theme()[Role::now], 1, ui::size::kRadius);
        draw_box(row, on);
        const float x = row.x + ui_.px(28);
        say(row, Face::title, x, row.x + name_ - x - ui_.px(4), on ? Role::text : Role::muted, id);
        const Area place = bar_place(row);
        ui::fill(ui_.list(), {place.x, place.y, length(place, static_cast<double>(dropped)), place.h},
                 ui_.theme()[Role::section_1]);
        say_right(row, Face::code, row.right() - number_ - ui_.px(4), on ? Role::text : Role::muted,
                  on ? grouped(static_cast<double>(dropped)) : "off");
        draw_ratio(row, seconds);
    }
    void draw_ratio(const Area& row, double seconds) {
        const double all = time_of(kAllSkips);
        if (seconds > 0 && all > 0)
            say_right(row, Face::code, row.right() - ui_.px(4), Role::text, fmt::format(kTimesAs, seconds / all));
    }
    void draw_all(const Area& row) {
        if (!draws_) return;
        const bool none = (context_.state.look.skips & kAllSkips) == 0;
        const ui::Control control = ui_.control({"skips/all", row, ui::Kind::button, kAllRow, kAllTip});
        if (control.clicked) set(none ? kAllSkips : 0);
        if (control.hovered) ui::frame(ui_.list(), row, ui_.theme()[Role::now], 1, ui::size::kRadius);
        draw_box(row, none);
        const float x = row.x + ui_.px(28);
        say(row, Face::title, x, row.x + name_ - x - ui_.px(4), Role::text, kAllRow);
        draw_ratio(row, time_of(0));
    }
    void draw_drawn(const Area& row) {
        if (!draws_) return;
        ui::hairline(ui_, {row.x, row.y}, row.w);
        say(row, Face::title, row.x + ui_.px(28), name_ - ui_.px(32), Role::text, kDrawnRow);
        const Area place = bar_place(row);
        const auto drawn = static_cast<double>(count_.counters.drawn);
        ui::fill(ui_.list(), {place.x, place.y, length(place, drawn), place.h}, ui_.theme()[Role::covered]);
        say_right(row, Face::code_strong, row.right() - number_ - ui_.px(4), Role::text, grouped(drawn));
    }

    const ViewContext& context_;
    ui::Ui& ui_;
    Area area_;
    const RandomTriangles& random_;
    const SkipCount& count_;
    float row_, name_, number_;
    bool secret_, draws_ = false;
};

void draw(const ViewContext& context, const Area& place) {
    const Area area = begin_view(context, "skips", place, kTitle);
    const auto& random = context.derived.scene().random;
    if (random)
        SkipsView(context, area, *random).draw();
    else
        draw_empty(context, area, kNone);
    context.ui.end_panel();
}

constexpr View kView{"skips", kTitle, draw};
const RegisterView kRegistered(kView);

}  // namespace
}  // namespace texelscope::skips_view
