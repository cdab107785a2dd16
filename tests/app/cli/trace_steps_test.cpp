#include "app/cli/trace_steps.h"

#include <gtest/gtest.h>

#include <set>

namespace texelscope {
namespace {

/// Two triangles and a polygon that share pixels, one that is elsewhere.
Scene scene() {
    Scene s;
    s.framebuffer.width = 12, s.framebuffer.height = 10;
    auto texture = std::make_shared<Texture>();
    texture->texels = Image(8, 8, {10, 20, 30});
    s.textures.push_back(texture);
    s.polygons.push_back({{{1, 1, 0, 1, 0, 0}, {11, 2, 0, 1, 8, 0}, {10, 9, 0, 1, 8, 8}, {2, 8, 0, 1, 0, 8}}});
    s.polygons.push_back({{{6, 5, 0, 1, 0, 0}, {8, 5, 0, 1, 8, 0}, {6, 9, 0, 1, 0, 8}}});
    s.polygons.push_back({{{0, 0, 0, 1, 0, 0}, {2, 0, 0, 1, 8, 0}, {0, 2, 0, 1, 0, 8}}});
    return s;
}

/// Every method, as printed and corrected, with every form of its loops.
std::vector<DrawSettings> all_settings() {
    std::vector<DrawSettings> all;
    for (const Method* method : methods()) {
        for (const VariantInfo& variant : method->variants) {
            all.push_back({.method = method, .quirks = variant.quirks});
            for (std::size_t n = 0; n < method->quirks.size(); ++n) {
                if (method->quirks[n].kind == QuirkKind::form)
                    all.push_back({.method = method, .quirks = variant.quirks | QuirkSet{1} << n});
            }
        }
    }
    return all;
}

std::vector<std::string> texts_at(Steps& steps, Level level, Place place) {
    std::vector<std::string> texts;
    each_step_at(steps, level, place, [&](const Path& path) { return texts.push_back(path.text()), true; });
    return texts;
}

/// Runs `law` for each drawing and each of some pixels.
void for_each_pixel(const std::function<void(Steps&, Place)>& law) {
    const Scene s = scene();
    for (const DrawSettings& settings : all_settings()) {
        SCOPED_TRACE(std::string(settings.method->id) + " quirks " + std::to_string(settings.quirks));
        const Drawing drawing(s, settings);
        Steps steps(drawing);
        for (Integer y = 0; y < 10; y += 3) {
            for (Integer x = 0; x < 12; x += 2) law(steps, {x, y});
        }
    }
}

TEST(TraceSteps, APixelsStepsAreAmongAllStepsInTheSameOrder) {
    for (const Level level : {Level::triangle, Level::stage, Level::scanline, Level::pixel, Level::expression}) {
        const Scene s = scene();
        for (const DrawSettings& settings : all_settings()) {
            const Drawing drawing(s, settings);
            Steps steps(drawing);
            std::vector<std::string> all;
            each_step(steps, level, [&](const Path& path) { return all.push_back(path.text()), true; });
            auto from = all.begin();
            for (const std::string& text : texts_at(steps, level, {7, 6})) {
                from = std::find(from, all.end(), text);
                ASSERT_NE(from, all.end()) << settings.method->id << ' ' << settings.quirks << ' ' << text;
            }
        }
    }
}

TEST(TraceSteps, APixelsUnitsAreThoseThatVisitIt) {
    for_each_pixel([](Steps& steps, Place place) {
        std::set<std::string> visits, listed;
        each_step(steps, Level::pixel, [&](const Path& path) {
            const Visit& visit = steps.at(path);
            if (path.depth() > 2 && !visit.unit().loop && place_of(visit) == place) visits.insert(path.text());
            return true;
        });
        for (const std::string& text : texts_at(steps, Level::pixel, place)) {
            if (parse_path(text)->depth() > 2) listed.insert(text);
        }
        EXPECT_EQ(listed, visits) << place.x << ',' << place.y;
    });
}

TEST(TraceSteps, EverySampleOfAPixelHasItsStep) {
    for_each_pixel([](Steps& steps, Place place) {
        std::set<int> drawn, listed;
        const Drawing& drawing = steps.drawing();
        each_sample(drawing, 0, drawing.shape_count(), {drawing.scene().framebuffer.rect(), 1},
                    [&](int shape, const Sample& sample) {
                        if (Place{sample.x, sample.y} == place) drawn.insert(shape);
                    });
        for (const std::string& text : texts_at(steps, Level::triangle, place))
            listed.insert(int(parse_path(text)->parts[0].index));
        EXPECT_EQ(listed, drawn) << place.x << ',' << place.y;
    });
}

TEST(TraceSteps, StopsWhenTold) {
    const Scene s = scene();
    const Drawing drawing(s, all_settings()[0]);
    Steps steps(drawing);
    int count = 0;
    each_step(steps, Level::expression, [&](const Path&) { return ++count < 5; });
    EXPECT_EQ(count, 5);
    count = 0;
    each_step_at(steps, Level::expression, {7, 6}, [&](const Path&) { return ++count < 5; });
    EXPECT_EQ(count, 5);
}

}  // namespace
}  // namespace texelscope
