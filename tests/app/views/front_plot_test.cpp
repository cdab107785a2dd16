#include "app/views/front_plot.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "app/views/front_labels.h"
#include "app/views/front_marks.h"
#include "tests/app/views/view_stage.h"

namespace texelscope {
namespace {

/// Every rung, with times and errors as a front may have them.
[[nodiscard]] std::vector<FrontPoint> some_points(std::initializer_list<const char*> scenes, std::uint64_t seed) {
    std::mt19937_64 engine(seed);
    const auto chance = [&] { return static_cast<double>(engine() >> 11U) * 0x1p-53; };
    std::vector<FrontPoint> points;
    for (const char* scene : scenes)
        for (const Rung& rung : rungs()) {
            FrontPoint p;
            p.scene = scene, p.rung = rung.id, p.label = rung.label, p.kind = id_of(rung.kind);
            p.numbers = id_of(rung.format);
            p.median_ns = p.min_ns = 2 * std::pow(10, 2 * chance()), p.pixels = 1000;
            p.max_error = rung.format == NumberFormat::exact ? 0 : std::pow(10, 16 * chance() - 14);
            if (rung.bound != nullptr) p.bound = p.max_error * 10;
            points.push_back(std::move(p));
        }
    mark_dominated(points);
    return points;
}

struct Drawn {
    ui::FrameReport report;
    const FrontPoint* hovered = nullptr;
};
[[nodiscard]] Drawn drawn(const std::vector<FrontPoint>& points, glm::vec2 size, ui::ThemeName theme, float scale = 1,
                          glm::vec2 mouse = glm::vec2(-1e9F)) {
    const ui::Fonts& fonts = stage_fonts({.scale = scale});
    const ui::Theme colours = ui::make_theme(theme);
    SoftwarePlatform platform;
    platform.set_fonts(fonts.atlas());
    ui::UiMemory memory;
    ui::Input input;
    input.size = size, input.mouse = mouse;
    Drawn result;
    platform.frame(input, [&] {
        ui::Ui ui(memory, input, fonts, colours, *ImGui::GetBackgroundDrawList());
        ui.set_ground(colours.panel);
        result.hovered = draw_front_plot(ui, {0, 0, size.x, size.y}, points);
        ui.end();
        result.report = ui.report();
    });
    return result;
}

TEST(FrontPlot, NoTextLiesOverAnotherOrLeavesThePicture) {
    for (const std::uint64_t seed : {1, 2, 3}) {
        const auto points = some_points({"near", "far", "steep", "slivers"}, seed);
        const Drawn d = drawn(points, {1600, 1000}, ui::ThemeName::dark, 1.25F);
        ASSERT_GT(d.report.texts.size(), 100U);
        for (std::size_t n = 0; n < d.report.texts.size(); ++n) {
            const ui::TextRecord& a = d.report.texts[n];
            EXPECT_TRUE(ui::Area({0, 0, 1600, 1000}).covers(a.area, 1)) << a.text;
            for (std::size_t m = 0; m < n; ++m) {
                const ui::TextRecord& b = d.report.texts[m];
                // An exponent stands close to its ten, and a record is as high as the tallest letters are.
                if (a.area.h < 14 || b.area.h < 14) continue;
                EXPECT_TRUE(ui::intersection(a.area.inset(2, 4), b.area.inset(2, 4)).empty())
                    << a.text << " over " << b.text << ", seed " << seed;
            }
        }
    }
}

TEST(FrontPlot, EveryPointIsNamed) {
    const auto points = some_points({"near", "far", "steep", "slivers"}, 4);
    const Drawn d = drawn(points, {1600, 1000}, ui::ThemeName::dark, 1.25F);
    for (const FrontPoint& p : points) {
        const std::string name = front::leads(p) || front::is_large(p) ? p.label : front_mark(p);
        const auto times =
            std::count_if(d.report.texts.begin(), d.report.texts.end(), [&](const auto& t) { return t.text == name; });
        EXPECT_GE(times, 1) << name;
    }
}

TEST(FrontPlot, LettersTellAllMethodsApart) {
    std::vector<std::string> letters;
    for (const Method* method : methods()) letters.push_back(front::letters_of(method->id));
    std::sort(letters.begin(), letters.end());
    EXPECT_EQ(std::adjacent_find(letters.begin(), letters.end()), letters.end());
}

TEST(FrontPlot, TextIsReadableInEveryTheme) {
    const auto points = some_points({"near"}, 5);
    for (const auto theme : {ui::ThemeName::dark, ui::ThemeName::light, ui::ThemeName::presenting}) {
        const Drawn d = drawn(points, {900, 600}, theme);
        const auto faint = ui::faint_texts(d.report, ui::make_theme(theme).text_contrast());
        EXPECT_TRUE(faint.empty()) << faint.front().text;
    }
}

TEST(FrontPlot, ThePointUnderTheMouseIsFound) {
    auto points = some_points({"near"}, 6);
    points.resize(1);
    bool found = false;
    for (float y = 0; y < 400; y += 8)
        for (float x = 0; x < 500; x += 8)
            found = found || drawn(points, {500, 400}, ui::ThemeName::dark, 1, {x, y}).hovered == &points[0];
    EXPECT_TRUE(found);
    EXPECT_EQ(drawn(points, {500, 400}, ui::ThemeName::dark, 1, {2, 2}).hovered, nullptr);
}

TEST(FrontPlot, DrawsNothingMeasuredAndEndlessErrorsToo) {
    EXPECT_EQ(drawn({}, {800, 600}, ui::ThemeName::dark).report.texts.size(), 0U);
    auto points = some_points({"near"}, 7);
    for (FrontPoint& p : points) p.max_error = p.bound = INFINITY;
    EXPECT_GT(drawn(points, {800, 600}, ui::ThemeName::dark).report.texts.size(), 10U);
    for (FrontPoint& p : points) p.median_ns = 0;  // errors are known, times are not yet
    EXPECT_GT(drawn(points, {800, 600}, ui::ThemeName::dark).report.texts.size(), 10U);
}

TEST(FrontPlot, ErrorsAreWrittenWithAsFewDigitsAsTellThemApart) {
    EXPECT_EQ(front_number(0), "0");
    EXPECT_EQ(front_number(.0147321), "0.0147");
    EXPECT_EQ(front_number(2.8912e-8), "2.9e-08");
    EXPECT_EQ(front_number(1.0 / 0.0), "∞");
    EXPECT_EQ(front_number(std::nan("")), "–");
}

TEST(FrontLabels, PlacesThatReachEachOtherAreOneSet) {
    const std::vector<glm::vec2> places{{0, 0}, {100, 0}, {10, 3}, {20, -3}, {20, 40}};
    const std::vector<int> sets = front::grouped_places(places, {12, 7});
    EXPECT_EQ(sets, (std::vector<int>{0, 1, 0, 0, 2}));
}

}  // namespace
}  // namespace texelscope
