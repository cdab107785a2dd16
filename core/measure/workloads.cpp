#include "core/measure/workloads.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include <glm/glm.hpp>

#include "core/exact/triangle.h"
#include "core/geometry/snap.h"
#include "core/image/image.h"
#include "core/measure/dice.h"

namespace texelscope {
namespace {

constexpr int kSide = 1024, kTexture = 256;
constexpr float kScreen = kSide;
constexpr int kGridBits = 8;

/// Anywhere on the screen but for its margin.
[[nodiscard]] glm::vec2 on_screen(Dice& dice, float margin) {
    return dice.place(glm::vec2(margin), glm::vec2(kScreen - margin));
}

[[nodiscard]] TrianglesFile screen(std::uint64_t seed) {
    return {.width = kSide, .height = kSide, .texture_width = kTexture, .texture_height = kTexture, .seed = seed};
}

/// A texture laid over the screen: turned, about one texel for a pixel.
class Laid {
public:
    explicit Laid(Dice& dice) : along_(dice.direction() / float{kTexture}) {
        along_ *= dice.within(.7F, 1.4F);  // apart: compilers differ in which of two operands they throw first
        offset_ = on_screen(dice, 0) / float{kTexture};
    }
    [[nodiscard]] glm::vec2 at(glm::vec2 p) const {
        return offset_ + glm::vec2(along_.x * p.x - along_.y * p.y, along_.y * p.x + along_.x * p.y);
    }

private:
    glm::vec2 along_, offset_;
};

[[nodiscard]] Vertex corner(glm::vec2 p, glm::vec2 uv, float z = 0, float w = 1) {
    return {snap(p.x, kGridBits), snap(p.y, kGridBits), z, w, uv.x, uv.y};
}

/// Three corners round a middle, their front to us, about `area` px large; `thin` to 1 wide to high.
[[nodiscard]] std::array<glm::vec2, 3> around(Dice& dice, glm::vec2 middle, float area) {
    const glm::vec2 way = dice.direction(), across{-way.y, way.x};
    const float height = std::sqrt(area) * dice.within(1.1F, 1.7F), width = 2 * area / height;
    const float apex = dice.within(-.4F, .4F) * width;
    return {middle - way * (height / 3) - across * (width / 2), middle - way * (height / 3) + across * (width / 2),
            middle + way * (height * 2 / 3) + across * apex};
}

void add(TrianglesFile& file, Dice& dice, const std::array<glm::vec2, 3>& corners, float z = 0) {
    const Laid texture(dice);
    const bool turned = glm::determinant(glm::mat2(corners[1] - corners[0], corners[2] - corners[0])) < 0;
    for (const int n : {0, turned ? 2 : 1, turned ? 1 : 2}) {
        const glm::vec2 p = corners[static_cast<std::size_t>(n)];
        file.vertices.push_back(corner(p, texture.at(p), z));
    }
}

[[nodiscard]] TrianglesFile at_random(std::uint64_t seed, int count, float area) {
    Dice dice(seed);
    TrianglesFile file = screen(seed);
    for (int n = 0; n < count; ++n) add(file, dice, around(dice, on_screen(dice, std::sqrt(area)), area));
    return file;
}

/// Corners between one and four times as far from the eye as the nearest.
[[nodiscard]] TrianglesFile in_perspective(TrianglesFile file) {
    Dice dice(file.seed + 1);
    file.perspective = true;
    for (Vertex& vertex : file.vertices) vertex.w = dice.within(1, 4);
    return file;
}

[[nodiscard]] TrianglesFile big(std::uint64_t seed) { return at_random(seed, 400, 20'000); }
[[nodiscard]] TrianglesFile hundred(std::uint64_t seed) { return at_random(seed, 40'000, 100); }
[[nodiscard]] TrianglesFile four(std::uint64_t seed) { return at_random(seed, 200'000, 4); }
[[nodiscard]] TrianglesFile big_perspective(std::uint64_t seed) { return in_perspective(big(seed)); }
[[nodiscard]] TrianglesFile hundred_perspective(std::uint64_t seed) { return in_perspective(hundred(seed)); }

/// A surface as a scanner leaves it: a grid whose corners were shaken, two triangles a square, 4 px each.
[[nodiscard]] TrianglesFile mesh(std::uint64_t seed) {
    Dice dice(seed);
    TrianglesFile file = screen(seed);
    constexpr int kSquares = 360;
    constexpr float kStep = kScreen / kSquares;
    Grid<glm::vec2> at(kSquares + 1, kSquares + 1);
    for (int y = 0; y <= kSquares; ++y)
        for (int x = 0; x <= kSquares; ++x) {
            const float right = dice.within(-.3F, .3F), down = dice.within(-.3F, .3F);
            at.at(x, y) = glm::vec2(static_cast<float>(x) + right, static_cast<float>(y) + down) * kStep;
        }
    for (int y = 0; y < kSquares; ++y)
        for (int x = 0; x < kSquares; ++x)
            for (const glm::ivec2 p :
                 {glm::ivec2(x, y), {x + 1, y}, {x + 1, y + 1}, {x, y}, {x + 1, y + 1}, {x, y + 1}})
                file.vertices.push_back(corner(at.at(p.x, p.y), at.at(p.x, p.y) / float{kTexture}));
    return file;
}

/// Splinters of a long mesh, many of them across the whole screen and beyond it.
[[nodiscard]] TrianglesFile slivers(std::uint64_t seed) {
    Dice dice(seed);
    TrianglesFile file = screen(seed);
    for (int n = 0; n < 20'000; ++n) {
        const glm::vec2 way = dice.direction(), across{-way.y, way.x}, middle = on_screen(dice, 0);
        const float length = dice.within(600, dice.chance(.2F) ? 8000 : 1400), width = dice.within(.5F, 3);
        const float start = dice.within(-.7F, -.3F) * length;
        add(file, dice, {middle + way * start, middle + way * start + across * width, middle + way * (start + length)});
    }
    return file;
}

/// A million triangles as a careless program sends them: one in ten is seen.
[[nodiscard]] TrianglesFile waste(std::uint64_t seed) {
    Dice dice(seed);
    TrianglesFile file = screen(seed);
    file.depth = file.cull_back = true;
    constexpr int kWalls = 200, kAll = 1'000'000;
    const auto put = [&](glm::vec2 middle, float area, float low, float high) {
        const auto corners = around(dice, middle, area);
        add(file, dice, corners, dice.within(low, high));
    };
    for (int n = 0; n < kWalls; ++n) put(on_screen(dice, 0), 30'000, .3F, .4F);
    for (int n = kWalls; n < kAll; ++n) {
        const float kind = dice.within(0, 1);
        if (kind < .1F) {  // seen, in front of the walls
            put(on_screen(dice, 4), 10, .05F, .25F);
        } else if (kind < .35F) {  // behind them
            put(on_screen(dice, 8), 30, .5F, .9F);
        } else if (kind < .6F) {  // from the back
            put(on_screen(dice, 8), 30, .05F, .9F);
            std::swap(file.vertices.back(), file.vertices[file.vertices.size() - 2]);
        } else if (kind < .8F) {  // off the screen
            const glm::vec2 aside{dice.chance(.5F) ? kScreen + 20 : -kScreen - 20, 0};
            put(on_screen(dice, 0) + aside, 30, .05F, .9F);
        } else {  // no sample inside
            put(glm::floor(on_screen(dice, 4)), .05F, .05F, .9F);
        }
    }
    return file;
}

constexpr std::array<Workload, 8> kWorkloads{{
    {"big", "400 triangles of 20,000 px", big},
    {"hundred", "40,000 triangles of 100 px", hundred},
    {"four", "200,000 triangles of 4 px at random", four},
    {"mesh", "259,200 triangles of 4 px, side by side", mesh},
    {"big-perspective", "400 triangles of 20,000 px in perspective", big_perspective},
    {"hundred-perspective", "40,000 triangles of 100 px in perspective", hundred_perspective},
    {"waste", "a million triangles with depth, nine in ten of them for nothing", waste},
    {"slivers", "20,000 triangles, 600 to 8,000 px long and 0.5 to 3 px wide", slivers},
}};

}  // namespace

std::span<const Workload> workloads() { return kWorkloads; }

const Workload* find_workload(std::string_view name) {
    const auto at =
        std::find_if(kWorkloads.begin(), kWorkloads.end(), [=](const Workload& w) { return w.name == name; });
    return at == kWorkloads.end() ? nullptr : &*at;
}

void jitter(TrianglesFile& file, float most, std::uint64_t seed) {
    Dice dice(seed);
    std::map<std::pair<float, float>, glm::vec2> moved;
    for (Vertex& vertex : file.vertices) {
        const auto [at, added] = moved.try_emplace({vertex.x, vertex.y});
        if (added) {
            const float x = dice.within(-most, most);
            at->second = glm::vec2(vertex.x + x, vertex.y + dice.within(-most, most));
        }
        vertex.x = at->second.x, vertex.y = at->second.y;
    }
}

std::uint64_t covered_samples(const TrianglesFile& file) {
    std::uint64_t count = 0;
    Grid<float> nearest(file.depth ? file.width : 0, file.depth ? file.height : 0, 1.0F);
    for (std::size_t n = 0; n + 2 < file.vertices.size(); n += 3) {
        const std::span<const Vertex, 3> corners(&file.vertices[n], 3);
        const ExactTriangle triangle(corners);
        if (triangle.winding() == 0 || (file.cull_back && triangle.winding() < 0)) continue;
        const auto [low, high] = std::minmax({corners[0].y, corners[1].y, corners[2].y});
        const auto first = static_cast<int>(std::clamp(std::floor(low) - 1, 0.0F, static_cast<float>(file.height)));
        const auto last = static_cast<int>(std::clamp(std::ceil(high) + 1, 0.0F, static_cast<float>(file.height)));
        for (int y = first; y < last; ++y) {
            const PixelRange row = triangle.row(y, 0, file.width);
            if (row.empty()) continue;
            if (!file.depth) {
                count += static_cast<std::uint64_t>(row.x1 - row.x0);
                continue;
            }
            for (Integer x = row.x0; x < row.x1; ++x) {
                const float z = triangle.depth(x, y);
                float& before = nearest.at(static_cast<int>(x), y);
                if (z < before) before = z, ++count;
            }
        }
    }
    return count;
}

}  // namespace texelscope
