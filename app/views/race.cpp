// Random triangles as a race: what each method computes for them, counted; how long it takes here, once a person asks;
// and what the same pixels cost in 1995.
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

namespace texelscope::race_view {
namespace {

using ui::Area;
using ui::Face;
using ui::Role;

constexpr std::string_view kTitle = "Race";
constexpr std::string_view kNone =
    "This scene has no random triangles. Lesson 17 has; in a scene file they are "
    "`\"random\": { \"triangles\": 200, \"size\": 60 }`.";
constexpr std::string_view kCount = "triangles", kCountTip = "How many random triangles are drawn";
constexpr std::string_view kSize = "size [px]",
                           kSizeTip = "The side of the square that holds a triangle [px]; it covers 11/144 of it";
constexpr std::string_view kSeed = "seed", kSeedTip = "Another number is another throw of the dice";
constexpr std::string_view kScene = "{} triangles write {} pixels: {} each",
                           kPart = "{} triangles, about {} pixels: {} each; {} counted";
constexpr std::string_view kCounted = "Operations, counted", kShare = "set-up", kTriangle = "a triangle",
                           kPixel = "a pixel";
constexpr std::string_view kCountedTip =
    "{}: {} for a triangle's set-up; {} for its rows; {} for its pixels; rejected samples are counted with these. "
    "Click: draw with it";
constexpr std::string_view kMeasured = "Time, measured here", kRun = "Run", kStop = "Stop",
                           kRunTip = "Times all methods on this machine, one after the other", kStopTip = "Stop timing";
constexpr std::string_view kProgress = "{} of {}", kNotYet = "Run times them: about {:.0f} s";
constexpr std::string_view kFrame = "ms", kPixels = "Mpx/s", kTriangles = "tri/s";
constexpr std::string_view kMeasuredTip =
    "{}: {} ms for a frame, of these {} ms for set-up; {} million pixels and {} triangles a second. The fastest round";
constexpr std::string_view k1995 = "1995, 100 ns a pixel";
constexpr std::string_view k1995Tip =
    "A Pentium of 100 MHz at 10 cycles a pixel, for these {} pixels; set-up is not in it";
constexpr std::string_view kSecret = "Your answer first: the numbers follow.";
constexpr std::array<std::string_view, 3> kGivenAway{"operations-order", "set-up-share", "frames-1995"};
constexpr float kLeastTrack = 76;     ///< of a slider [px at 100 %]
constexpr double kSecondsALap = 0.3;  ///< about, for the hint

constexpr std::array<double, 13> kCounts{1, 2, 5, 10, 20, 50, 100, 200, 500, 1000, 2000, 5000, kMostTriangles};
constexpr std::array<double, 16> kSizes{2, 3, 4, 6, 8, 12, 16, 24, 32, 48, 64, 96, 128, 192, 256, 384};

/// Where a value lies on a scale of round numbers, and what stands at a place of it.
template <std::size_t N>
[[nodiscard]] double place_on(const std::array<double, N>& scale, double value) {
    const auto after = std::upper_bound(scale.begin(), scale.end(), value);
    if (after == scale.begin()) return 0;
    if (after == scale.end()) return N - 1;
    const double low = *(after - 1);
    return static_cast<double>(after - scale.begin() - 1) + (value - low) / (*after - low);
}
template <std::size_t N>
[[nodiscard]] double value_at(const std::array<double, N>& scale, double place) {
    return scale[static_cast<std::size_t>(std::clamp(std::round(place), 0.0, static_cast<double>(N - 1)))];
}

/// The numbers are asked for, and the answer is still open.
[[nodiscard]] bool is_secret(const State& state) {
    const Prediction* asked = prediction_of(state);
    if (asked == nullptr) return false;
    const std::string_view question = std::string_view(asked->answer).substr(0, asked->answer.find(' '));
    if (std::find(kGivenAway.begin(), kGivenAway.end(), question) == kGivenAway.end()) return false;
    const auto& answers = state.work.answers;
    const auto own =
        std::find_if(answers.begin(), answers.end(), [&](const Answer& a) { return a.beat == state.cursor.beat; });
    return own == answers.end() || own->verdict == Answer::Verdict::open;
}

class RaceView {
public:
    RaceView(const ViewContext& context, const Area& area, const RandomTriangles& random)
        : context_(context),
          ui_(context.ui),
          area_(area),
          random_(random),
          bills_(context.derived.bills()),
          laps_(context.state.race.laps),
          table_(context.ui, area.w, widest_name(context.ui, bills_), kTriangle),
          row_(table_.row_height()),
          secret_(is_secret(context.state)) {}

    void draw() {
        const float content = run({0, 0, area_.w, area_.h}, false);
        foresee(ui_, "race/scroll", content);
        if (context_.state.race.running || !laps_.empty())  // what was measured last is to be seen
            follow(ui_, "race/scroll", area_.h, content, measured_, content, static_cast<float>(laps_.size() + 1));
        const Area inner = ui_.begin_scroll("race/scroll", area_);
        ui_.end_scroll(run(inner, true));
    }

private:
    [[nodiscard]] static float widest_name(const ui::Ui& ui, const std::vector<Bill>& bills) {
        float widest = ui::text_width(ui.font(Face::title), k1995);
        for (const Bill& bill : bills)
            widest = std::max(widest, ui::text_width(ui.font(Face::title), bill.method->title));
        return widest;
    }
    /// Goes through all parts, drawing them or only measuring. @return the height of all.
    [[nodiscard]] float run(const Area& inner, bool draws) {
        draws_ = draws;
        float y = draw_controls(inner, inner.y + ui_.px(2));
        if (bills_.empty()) return y - inner.y;
        y = draw_line(inner, y + ui_.px(4), scene_text());
        if (secret_) return draw_line(inner, y, kSecret) - inner.y;
        y = draw_counted(inner, y + ui_.px(6));
        measured_ = y - inner.y;
        y = draw_measured(inner, y + ui_.px(8));
        return y - inner.y;
    }
    /// One line of text in the middle of `row`. @return its width.
    float say(const Area& row, float x, float width, Role role, std::string_view text) {
        return ui_.text_within(Face::title, {x, table_.baseline(Face::title, row)}, width, role, text);
    }
    /// A line of text. @return where the next begins.
    float draw_line(const Area& inner, float y, std::string_view text) {
        if (draws_) say({inner.x, y, inner.w, row_}, inner.x, inner.w, Role::muted, text);
        return y + row_;
    }
    [[nodiscard]] std::string scene_text() const {
        const Bill& bill = bills_.front();
        const double pixels = bill.scene_pixels(),
                     each = bill.shapes > 0 ? pixels / static_cast<double>(bill.shapes) : 0;
        const auto shapes = static_cast<double>(bill.shapes);
        if (bill.counted == bill.shapes) return fmt::format(kScene, grouped(shapes), grouped(pixels), brief(each));
        return fmt::format(kPart, grouped(shapes), grouped(pixels), brief(each), bill.counted);
    }

    // -- controls
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
        if (draws_) {
            RandomTriangles next = random_;
            if (const auto to = draw_tuning(ui_, place(0), {"race/count", kCount, grouped(random_.count), kCountTip},
                                            place_on(kCounts, random_.count), {0, kCounts.size() - 1, 1}))
                next.count = static_cast<int>(value_at(kCounts, *to));
            if (const auto to =
                    draw_tuning(ui_, place(1), {"race/size", kSize, fmt::format("{:g}", random_.size), kSizeTip},
                                place_on(kSizes, double{random_.size}), {0, kSizes.size() - 1, 1}))
                next.size = static_cast<float>(value_at(kSizes, *to));
            if (const auto to =
                    draw_tuning(ui_, place(2), {"race/seed", kSeed, fmt::format("{}", random_.seed), kSeedTip},
                                random_.seed, {0, 99, 1}))
                next.seed = static_cast<std::uint32_t>(std::round(*to));
            if (!(next == random_))
                context_.act(action::SetRandom{next, ui_.memory().active != 0 ? ui_.memory().presses : 0});
        }
        return y + static_cast<float>(lines) * (high + ui_.px(2));
    }

    /// A method's name, as a control that draws with it.
    void draw_name(const Area& row, const Method& method, const std::string& name, const std::string& tip) {
        const bool current = &method == &context_.derived.method();
        const ui::Control control = ui_.control({name, row, ui::Kind::link, method.title, tip});
        if (control.clicked) context_.act(action::SetMethod{std::string(method.id)});
        if (current) ui::current_row(ui_, row);
        if (control.hovered) ui::frame(ui_.list(), row, ui_.theme()[Role::now], 1, ui::size::kRadius);
        say(row, row.x + ui_.px(8), table_.name_width() - ui_.px(12), current ? Role::text : Role::muted, method.title);
    }
    float draw_counted(const Area& inner, float y) {
        const float title = ui::text_width(ui_.font(Face::title), kCounted) + ui_.px(12);
        const float right = table_.bar_place({inner.x, y, inner.w, row_}).right();
        if (title + table_.legend_width() > right - inner.x) {  // a line of its own
            if (draws_) table_.legend({inner.x, y, inner.w, row_}, inner.x + table_.legend_width());
            y += row_;
        } else if (draws_) {
            table_.legend({inner.x, y, inner.w, row_}, right);
        }
        if (draws_) {
            const Area head{inner.x, y, inner.w, row_};
            say(head, head.x, table_.name_width(), Role::text, kCounted);
            table_.heading(head, 2, kTriangle), table_.heading(head, 1, kShare), table_.heading(head, 0, kPixel);
        }
        y += row_;
        if (draws_) ui::hairline(ui_, {inner.x, y}, inner.w);
        y += ui_.px(2);
        Integer most = 1;
        for (const Bill& bill : bills_) most = std::max(most, bill.whole().all());
        for (const Bill& bill : bills_) {
            if (draws_) draw_bill({inner.x, y, inner.w, row_}, bill, static_cast<double>(most));
            y += row_;
        }
        return y;
    }
    void draw_bill(const Area& row, const Bill& bill, double most) {
        const auto all = [](const OperationCount& n) { return static_cast<double>(n.all()); };
        const auto of = [](double n, Integer parts) { return parts > 0 ? n / static_cast<double>(parts) : 0; };
        const double set_up = of(all(bill.set_up), bill.counted), rows = of(all(bill.in_rows), bill.counted),
                     samples = of(all(bill.in_pixels), bill.counted);
        draw_name(row, *bill.method, fmt::format("race/{}", bill.method->id),
                  fmt::format(kCountedTip, bill.method->title, brief(set_up), brief(rows), brief(samples)));
        table_.bar(row, most, {all(bill.set_up), all(bill.in_rows), all(bill.in_pixels)});
        const bool current = bill.method == &context_.derived.method();
        table_.number(row, 1, percent(bill.set_up_share()), current);
        table_.number(row, 2, brief(set_up + rows + samples), current);
        table_.number(row, 0, brief(of(all(bill.whole()), bill.pixels)), current);
    }

    // -- time
    [[nodiscard]] std::string hint() const {
        if (context_.state.race.running) return fmt::format(kProgress, laps_.size() + 1, bills_.size());
        return laps_.empty() ? fmt::format(kNotYet, std::ceil(kSecondsALap * static_cast<double>(bills_.size())))
                             : std::string();
    }
    float draw_measured(const Area& inner, float y) {
        const float high = std::max(ui_.px(24), std::ceil(ui_.font(Face::title).em * 1.6F));
        const bool on = context_.state.race.running;
        if (draws_) {
            const Area head{inner.x, y, inner.w, high};
            say(head, head.x, table_.name_width(), Role::text, kMeasured);
            const float width = std::max(ui::button_width(ui_, kRun), ui::button_width(ui_, kStop));
            if (ui::toggle(ui_, "race/run", {inner.x + table_.name_width(), y, width, high}, on ? kStop : kRun, on,
                           on ? kStopTip : kRunTip)
                    .clicked)
                context_.act(action::StartRace{!on});
            const float x = inner.x + table_.name_width() + width + ui_.px(10);
            say(head, x, std::max(0.0F, inner.right() - table_.numbers_width() - x), Role::muted, hint());
            table_.heading(head, 2, kTriangles), table_.heading(head, 1, kFrame), table_.heading(head, 0, kPixels);
        }
        y += high + ui_.px(2);
        if (draws_) ui::hairline(ui_, {inner.x, y}, inner.w);
        y += ui_.px(2);
        const double pixels = bills_.front().scene_pixels(), then = pixels * kPixelSeconds1995;
        double most = then;
        for (const Lap& lap : laps_) most = std::max(most, lap.seconds);
        if (draws_) draw_1995({inner.x, y, inner.w, row_}, then, most, pixels);
        y += row_;
        for (const Lap& lap : laps_) {
            if (draws_) draw_lap({inner.x, y, inner.w, row_}, lap, most);
            y += row_;
        }
        return y;
    }
    void draw_1995(const Area& row, double seconds, double most, double pixels) {
        const ui::Control control =
            ui_.control({"race/1995", row, ui::Kind::link, k1995, fmt::format(k1995Tip, grouped(pixels))});
        if (control.hovered) ui::frame(ui_.list(), row, ui_.theme()[Role::now], 1, ui::size::kRadius);
        say(row, row.x + ui_.px(8), table_.name_width() - ui_.px(12), Role::text, k1995);
        Area bar = table_.bar_place(row);
        if (most > 0) bar.w = std::round(bar.w * static_cast<float>(seconds / most));
        ui::fill(ui_.list(), bar, ui_.theme()[Role::covered]);
        table_.number(row, 1, brief(seconds * 1e3), true);
        table_.number(row, 0, brief(1e-6 / kPixelSeconds1995), true);
        const auto triangles = static_cast<double>(bills_.front().shapes);
        table_.number(row, 2, seconds > 0 ? brief(triangles / seconds) : std::string(), true);
    }
    void draw_lap(const Area& row, const Lap& lap, double most) {
        const double seconds = std::max(lap.seconds, 1e-9);
        const std::string ms = brief(seconds * 1e3), pixels = brief(static_cast<double>(lap.pixels) / seconds / 1e6),
                          triangles = brief(static_cast<double>(lap.triangles) / seconds);
        draw_name(row, *lap.method, fmt::format("race/lap/{}", lap.method->id),
                  fmt::format(kMeasuredTip, lap.method->title, ms, brief(lap.set_up * 1e3), pixels, triangles));
        table_.bar(row, most, {lap.set_up, 0, lap.seconds - lap.set_up});
        const bool current = lap.method == &context_.derived.method();
        table_.number(row, 1, ms, current), table_.number(row, 0, pixels, current);
        table_.number(row, 2, triangles, current);
    }

    const ViewContext& context_;
    ui::Ui& ui_;
    Area area_;
    const RandomTriangles& random_;
    const std::vector<Bill>& bills_;
    const std::vector<Lap>& laps_;
    RaceTable table_;
    float row_, measured_ = 0;  ///< where the measured times begin
    bool secret_, draws_ = false;
};

void draw(const ViewContext& context, const Area& place) {
    const Area area = begin_view(context, "race", place, kTitle);
    const auto& random = context.derived.scene().random;
    if (random)
        RaceView(context, area, *random).draw();
    else
        draw_empty(context, area, kNone);
    context.ui.end_panel();
}

constexpr View kView{"race", kTitle, draw};
const RegisterView kRegistered(kView);

}  // namespace
}  // namespace texelscope::race_view
