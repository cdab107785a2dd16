// What limited numbers cost: errors that add up along a row, and large numbers that cancel far from the origin.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "tests/core/method/cases.h"

namespace texelscope::limited_numbers_test {
namespace {

struct Cost {
    int samples = 0, wrong = 0;  ///< drawn; of these with another texel than in exact numbers
    double most = 0;             ///< greatest error of u [texels]
    double last = 0;             ///< error of u at the greatest x of any row [texels]
};

[[nodiscard]] DrawSettings settings_with(std::string_view method, NumberFormat format,
                                         const std::vector<std::string_view>& quirks) {
    const Method& found = *find_method(method);
    QuirkSet set = 0;
    for (std::size_t n = 0; n < found.quirks.size(); ++n) {
        const bool on = std::find(quirks.begin(), quirks.end(), found.quirks[n].field) != quirks.end();
        set |= on ? QuirkSet{1} << n : 0;
    }
    return laws::settings_of(found, format, set);
}

[[nodiscard]] Cost cost(const Scene& scene, std::string_view method, NumberFormat format,
                        const std::vector<std::string_view>& quirks = {}) {
    const Window all{scene.framebuffer.rect(), 1};
    std::map<std::pair<Integer, Integer>, Sample> meant;
    for (const auto& [shape, s] :
         laws::all_samples(Drawing(scene, settings_with(method, NumberFormat::exact, quirks)), all))
        if (s.fate == Fate::written) meant[{s.x, s.y}] = s;
    Cost sum;
    Integer greatest = -1;
    for (const auto& [shape, s] : laws::all_samples(Drawing(scene, settings_with(method, format, quirks)), all)) {
        const auto m = meant.find({s.x, s.y});
        if (s.fate != Fate::written || m == meant.end()) continue;
        ++sum.samples;
        sum.wrong += s.column != m->second.column || s.row != m->second.row;
        sum.most = std::max(sum.most, std::abs(s.u - m->second.u));
        if (s.x > greatest) greatest = s.x, sum.last = s.u - m->second.u;
    }
    return sum;
}

[[nodiscard]] Vertex at(float x, float y, float u, float v) { return {.x = x, .y = y, .w = 1, .u = u, .v = v}; }

/// 64 texels over 640 pixels: u is 0 at the first sample and grows by a tenth. One row.
[[nodiscard]] Scene long_row() {
    Scene scene;
    scene.framebuffer = {.width = 640, .height = 1};
    scene.textures = {laws::texture_of(64, 64, Wrap::repeat)};
    Polygon quad;
    quad.vertices = {at(.5F, 0, 0, 0), at(.5F, 1, 0, 1), at(640.5F, 1, 64, 1), at(640.5F, 0, 64, 0)};
    scene.polygons = {quad};
    return scene;
}

/// 256 texels over 48 pixels, `far` pixels right of the origin.
[[nodiscard]] Scene steep_triangle(int far) {
    Scene scene;
    scene.framebuffer = {.width = 60, .height = 60, .origin_x = far};
    scene.textures = {laws::texture_of(256, 128, Wrap::repeat)};
    const auto x = static_cast<float>(far);
    Polygon triangle;
    triangle.vertices = {at(x + 4.25F, 3.5F, 0, 0), at(x + 52.25F, 5.5F, 256, 0), at(x + 10.5F, 42.3125F, 0, 128)};
    scene.polygons = {triangle};
    return scene;
}

TEST(LimitedNumbers, AdditionsIn88EndOneAndAHalfTexelsShort) {
    const Cost c = cost(long_row(), "backward-affine", NumberFormat::fx8_8);
    EXPECT_EQ(c.samples, 640);
    EXPECT_NEAR(c.last, -1.5, .01);
}

TEST(LimitedNumbers, AdditionsIn1616End6ThousandthsShort) {
    const Cost c = cost(long_row(), "backward-affine", NumberFormat::fx16_16);
    EXPECT_EQ(c.samples, 640);
    EXPECT_NEAR(c.last, -.006, .0002);
}

TEST(LimitedNumbers, AdditionsInFloatReadAnotherTexelAt33PixelsOf640) {
    const Cost c = cost(long_row(), "backward-affine", NumberFormat::f32);
    EXPECT_EQ(c.samples, 640);
    EXPECT_EQ(c.wrong, 33);
    EXPECT_NEAR(c.most, .0004, .00002);
}

/// On exact borders the least error decides, so more digits alone do not help.
TEST(LimitedNumbers, AdditionsInDoubleReadAnotherTexelToo) {
    const Cost c = cost(long_row(), "backward-affine", NumberFormat::f64);
    EXPECT_GT(c.wrong, 10);
    EXPECT_LT(c.most, 1e-11);
}

TEST(LimitedNumbers, MultipliedOutFloatReadsEveryTexelOfTheLongRow) {
    const Cost direct = cost(long_row(), "edge-equations", NumberFormat::f32);
    EXPECT_EQ(direct.samples, 640);
    EXPECT_EQ(direct.wrong, 0);
    EXPECT_LT(direct.most, 1e-5);
}

/// One triangle whose last row is 632 pixels long: what the lesson shows.
TEST(LimitedNumbers, AdditionsOfEdgeEquationsDriftAlike) {
    Scene scene = long_row();
    scene.framebuffer = {.width = 632, .height = 1, .origin_y = 47};
    scene.polygons[0].vertices = {at(.5F, 0, 0, 0), at(.5F, 48, 0, 16), at(640.5F, 48, 64, 16)};
    const Cost added = cost(scene, "edge-equations", NumberFormat::f32, {"additions", "based"});
    EXPECT_EQ(added.samples, 632);
    EXPECT_EQ(added.wrong, 33);
    EXPECT_EQ(cost(scene, "edge-equations", NumberFormat::f32, {"based"}).wrong, 0);
    EXPECT_NEAR(cost(scene, "edge-equations", NumberFormat::fx8_8, {"additions"}).last, -1.48, .01);
}

TEST(LimitedNumbers, FarFromTheOriginFloatCancels) {
    const Cost near = cost(steep_triangle(0), "edge-equations", NumberFormat::f32);
    const Cost far = cost(steep_triangle(50000), "edge-equations", NumberFormat::f32);
    const Cost farther = cost(steep_triangle(500000), "edge-equations", NumberFormat::f32);
    EXPECT_EQ(near.samples, 925);
    EXPECT_EQ(near.wrong, 0);
    EXPECT_EQ(far.samples, 925);
    EXPECT_EQ(far.wrong, 25);
    EXPECT_EQ(farther.wrong, 153);
    EXPECT_GT(farther.most, 5 * far.most);
}

TEST(LimitedNumbers, CountedFromACornerTheErrorStaysTheSame) {
    for (const int far : {0, 1000, 50000, 500000}) {
        const Cost c = cost(steep_triangle(far), "edge-equations", NumberFormat::f32, {"based"});
        EXPECT_EQ(c.wrong, 0) << far;
        EXPECT_LT(c.most, 2e-5) << far;
    }
}

/// The choices change no exact number.
TEST(LimitedNumbers, ExactlyAllWaysAreTheSame) {
    for (unsigned seed = 1; seed <= 21; ++seed) {
        const Scene scene = laws::random_scene(seed);
        const auto samples = [&](const std::vector<std::string_view>& quirks) {
            const Drawing drawing(scene, settings_with("edge-equations", NumberFormat::exact, quirks));
            return laws::all_samples(drawing, {scene.framebuffer.rect(), 1});
        };
        const auto plain = samples({});
        for (const std::vector<std::string_view>& quirks :
             {std::vector<std::string_view>{"based"}, {"additions"}, {"based", "additions"}}) {
            const auto other = samples(quirks);
            ASSERT_TRUE(std::equal(plain.begin(), plain.end(), other.begin(), other.end(),
                                   [](const auto& a, const auto& b) { return laws::same(a, b); }))
                << "random_scene(" << seed << "), " << quirks.back();
        }
    }
}

}  // namespace
}  // namespace texelscope::limited_numbers_test
