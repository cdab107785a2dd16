// Closed meshes draw each sample exactly once, in every number type, and ownership is the top-left rule's.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "core/geometry/polygon.h"
#include "tests/core/method/cases.h"

namespace texelscope::watertight_test {
namespace {

using Counts = std::map<std::pair<Integer, Integer>, int>;

const Rect kFrame{-3, -2, 21, 17};

Scene scene_of(std::vector<std::vector<Vertex>> polygons) {
    Scene scene;
    scene.framebuffer = {
        .width = kFrame.width(), .height = kFrame.height(), .origin_x = kFrame.x0, .origin_y = kFrame.y0};
    scene.textures = {laws::texture_of(16, 16, Wrap::repeat)};
    for (auto& corners : polygons) {
        Polygon polygon;
        polygon.vertices = std::move(corners);
        scene.polygons.push_back(std::move(polygon));
    }
    return scene;
}

Counts written(const Drawing& drawing) {
    Counts counts;
    each_sample(drawing, 0, drawing.shape_count(), {kFrame, 1}, [&](int, const Sample& s) {
        if (s.fate == Fate::written) ++counts[{s.x, s.y}];
    });
    return counts;
}

void for_every_number(const std::function<void(const DrawSettings&)>& check) {
    for (const Method* method : methods()) {
        if (method->scatters) continue;  // the texture drives it, so holes are in its nature
        for (const NumberFormatInfo& format : kNumberFormats) {
            SCOPED_TRACE(std::string(method->id) + " " + std::string(format.id));
            check(laws::settings_of(*method, format.format, 0));
        }
    }
}

float snapped_if(bool snap, float a) { return snap ? std::round(a * 4) / 4 : a; }

Vertex at(float x, float y) {
    Vertex v;
    v.x = x, v.y = y, v.u = x, v.v = y;
    return v;
}

/// A jittered grid over more than the frame, each cell cut along one of its diagonals, some of them turned round.
std::vector<std::vector<Vertex>> grid(laws::Dice& dice, bool snap, bool cut) {
    constexpr int kCells = 5;
    std::array<std::array<Vertex, kCells + 1>, kCells + 1> nodes;
    for (int n = 0; n <= kCells; ++n) {
        for (int m = 0; m <= kCells; ++m) {
            const float x = -6 + 6.1F * static_cast<float>(m) + dice.within(-1, 1),
                        y = -5 + 5.3F * static_cast<float>(n) + dice.within(-1, 1);
            nodes[n][m] = at(snapped_if(snap, x), snapped_if(snap, y));
        }
    }
    std::vector<std::vector<Vertex>> mesh;
    for (int n = 0; n < kCells; ++n) {
        for (int m = 0; m < kCells; ++m) {
            const std::array quad{nodes[n][m], nodes[n][m + 1], nodes[n + 1][m + 1], nodes[n + 1][m]};
            if (!cut) {
                mesh.emplace_back(quad.begin(), quad.end());
            } else if (dice.often(0.5)) {
                mesh.push_back({quad[0], quad[1], quad[2]}), mesh.push_back({quad[0], quad[2], quad[3]});
            } else {
                mesh.push_back({quad[1], quad[2], quad[3]}), mesh.push_back({quad[1], quad[3], quad[0]});
            }
        }
    }
    for (auto& polygon : mesh) {
        if (dice.often(0.5)) std::reverse(polygon.begin(), polygon.end());
        std::rotate(polygon.begin(), polygon.begin() + dice.whole(0, static_cast<int>(polygon.size()) - 1),
                    polygon.end());
    }
    return mesh;
}

/// Triangles round a point, out to a ring beyond the frame.
std::vector<std::vector<Vertex>> fan(laws::Dice& dice, bool snap) {
    const Vertex middle = at(snapped_if(snap, dice.within(2, 15)), snapped_if(snap, dice.within(2, 12)));
    const int corners = dice.whole(5, 14);
    std::vector<Vertex> ring;
    for (int n = 0; n < corners; ++n) {
        const double angle = 6.2831853 * (n + double{dice.within(0, 0.5)}) / corners;
        ring.push_back(at(snapped_if(snap, static_cast<float>(9 + 60 * std::cos(angle))),
                          snapped_if(snap, static_cast<float>(8 + 60 * std::sin(angle)))));
    }
    std::vector<std::vector<Vertex>> mesh;
    for (std::size_t n = 0; n < ring.size(); ++n) mesh.push_back({middle, ring[n], ring[(n + 1) % ring.size()]});
    return mesh;
}

void expect_once_each(const DrawSettings& settings, const Scene& scene) {
    const Counts counts = written(Drawing(scene, settings));
    int bad = 0;
    std::string example;
    for (int y = kFrame.y0; y < kFrame.y1; ++y) {
        for (int x = kFrame.x0; x < kFrame.x1; ++x) {
            const auto found = counts.find({x, y});
            const int count = found == counts.end() ? 0 : found->second;
            if (count != 1 && bad++ == 0)
                example =
                    std::to_string(x) + ", " + std::to_string(y) + " is drawn " + std::to_string(count) + " times";
        }
    }
    EXPECT_EQ(bad, 0) << example;
}

TEST(Watertight, GridsOfTrianglesDrawEachSampleOnce) {
    for_every_number([](const DrawSettings& settings) {
        for (unsigned seed = 1; seed <= 30; ++seed) {
            SCOPED_TRACE("seed " + std::to_string(seed));
            laws::Dice dice(seed);
            expect_once_each(settings, scene_of(grid(dice, seed % 3 != 0, true)));
        }
    });
}

TEST(Watertight, GridsOfQuadsDrawEachSampleOnce) {
    for_every_number([](const DrawSettings& settings) {
        for (unsigned seed = 1; seed <= 20; ++seed) {
            SCOPED_TRACE("seed " + std::to_string(seed));
            laws::Dice dice(seed);
            expect_once_each(settings, scene_of(grid(dice, seed % 3 != 0, false)));
        }
    });
}

TEST(Watertight, ClosedFansDrawEachSampleOnce) {
    for_every_number([](const DrawSettings& settings) {
        for (unsigned seed = 1; seed <= 30; ++seed) {
            SCOPED_TRACE("seed " + std::to_string(seed));
            laws::Dice dice(seed);
            expect_once_each(settings, scene_of(fan(dice, seed % 3 != 0)));
        }
    });
}

/// Of the two halves of a quad, at most one has a sample, and each one that passes the four outer sides is drawn:
/// whatever the rounding, since both halves compute the diagonal's side alike.
TEST(Watertight, ASampleIsOnOneSideOfADiagonalInEveryNumberType) {
    const Method* method = find_method("edge-equations");
    ASSERT_NE(method, nullptr);
    for (const NumberFormatInfo& format : kNumberFormats) {
        for (unsigned seed = 1; seed <= 150; ++seed) {
            laws::Dice dice(seed);
            const auto ring = laws::random_corners(dice, laws::Family::any, kFrame, 4);
            if (std::abs(ring[0].x - ring[2].x) + std::abs(ring[0].y - ring[2].y) < 1) continue;
            const Scene scene = scene_of({{ring[0], ring[1], ring[2]}, {ring[2], ring[3], ring[0]}});
            const Drawing drawing(scene, laws::settings_of(*method, format.format, 0));
            std::map<std::pair<Integer, Integer>, std::array<Fate, 2>> fates;
            each_sample(drawing, 0, 2, {kFrame, 1}, [&](int shape, const Sample& s) {
                auto& both =
                    fates.try_emplace({s.x, s.y}, std::array{Fate::outside_box, Fate::outside_box}).first->second;
                both[static_cast<std::size_t>(shape)] = s.fate;
            });
            // Corners are in the order a, b, c and c, d, a: the diagonal is side C of both.
            for (const auto& [place, fate] : fates) {
                const auto inside = [&fate = fate](std::size_t n) { return fate[n] == Fate::written; };
                ASSERT_FALSE(inside(0) && inside(1))
                    << format.id << ", seed " << seed << ": " << place.first << ", " << place.second << " twice";
                ASSERT_FALSE(fate[0] == Fate::outside_edge_c && fate[1] == Fate::outside_edge_c)
                    << format.id << ", seed " << seed << ": " << place.first << ", " << place.second
                    << " on neither side";
            }
        }
    }
}

/// The top-left rule in whole numbers: quarter pixels, so that sample (i, j) is at (4 i + 2, 4 j + 2).
bool owned(const std::vector<Vertex>& ring, int i, int j) {
    const auto quarter = [](float a) { return static_cast<Integer>(std::lround(a * 4)); };
    Integer area = 0;
    for (std::size_t n = 2; n < ring.size(); ++n) {
        area += (quarter(ring[n - 1].x) - quarter(ring[0].x)) * (quarter(ring[n].y) - quarter(ring[0].y)) -
                (quarter(ring[n].x) - quarter(ring[0].x)) * (quarter(ring[n - 1].y) - quarter(ring[0].y));
    }
    if (area == 0) return false;
    for (std::size_t n = 0; n < ring.size(); ++n) {
        const Vertex& p = area > 0 ? ring[n] : ring[(n + 1) % ring.size()];
        const Vertex& q = area > 0 ? ring[(n + 1) % ring.size()] : ring[n];
        const Integer dx = quarter(q.x) - quarter(p.x), dy = quarter(q.y) - quarter(p.y);
        const Integer cross = dx * (4 * j + 2 - quarter(p.y)) - dy * (4 * i + 2 - quarter(p.x));
        const bool left = dy < 0, top = dy == 0 && dx > 0;
        if (cross < 0 || (cross == 0 && !left && !top)) return dx == 0 && dy == 0;
    }
    return true;
}

void expect_ownership(const DrawSettings& settings, laws::Family family, int corners) {
    for (unsigned seed = 1; seed <= 120; ++seed) {
        laws::Dice dice(seed);
        std::vector<Vertex> ring = laws::random_corners(dice, family, kFrame, corners);
        if (corners > 3 && !is_convex(ring)) continue;
        const Scene scene = scene_of({ring});
        const Counts counts = written(Drawing(scene, settings));
        for (int y = kFrame.y0; y < kFrame.y1; ++y) {
            for (int x = kFrame.x0; x < kFrame.x1; ++x) {
                ASSERT_EQ(counts.count({x, y}), owned(ring, x, y) ? 1U : 0U)
                    << "seed " << seed << ": sample " << x << ", " << y;
            }
        }
    }
}

TEST(Watertight, OwnershipIsTheTopLeftRule) {
    for_every_number([](const DrawSettings& settings) {
        // Edge equations of quarter pixels are exact in every format; what divides, or adds up, only in exact numbers.
        if (settings.format != NumberFormat::exact && settings.method->id != "edge-equations") return;
        expect_ownership(settings, laws::Family::quarter_pixels, 3);
        expect_ownership(settings, laws::Family::whole_pixels, 3);
        if (!settings.method->triangles) expect_ownership(settings, laws::Family::quarter_pixels, 5);
    });
}

TEST(Watertight, BothWindingsGiveTheSamePicture) {
    for_every_number([](const DrawSettings& settings) {
        for (unsigned seed = 1; seed <= 42; ++seed) {
            laws::Dice dice(seed);
            std::vector<Vertex> ring =
                laws::random_corners(dice, static_cast<laws::Family>(seed % laws::kFamilies), kFrame, 3);
            const Scene scene = scene_of({ring});
            std::swap(ring[1], ring[2]);
            const Scene turned = scene_of({ring});
            ASSERT_EQ(render(Drawing(scene, settings)), render(Drawing(turned, settings))) << "seed " << seed;
        }
    });
}

TEST(Watertight, AnExactPictureDoesNotDependOnTheFirstCorner) {
    for (const Method* method : methods()) {
        if (method->plane) continue;  // three corners say how the texture lies, so another first one may say otherwise
        const DrawSettings settings = laws::settings_of(*method, NumberFormat::exact, 0);
        for (unsigned seed = 1; seed <= 42; ++seed) {
            laws::Dice dice(seed);
            const auto family = static_cast<laws::Family>(seed % laws::kFamilies);
            std::vector<Vertex> ring = laws::random_corners(dice, family, kFrame, method->triangles ? 3 : 5);
            const Image picture = render(Drawing(scene_of({ring}), settings));
            for (std::size_t n = 1; n < ring.size(); ++n) {
                std::rotate(ring.begin(), ring.begin() + 1, ring.end());
                ASSERT_EQ(render(Drawing(scene_of({ring}), settings)), picture) << method->id << ", seed " << seed;
            }
        }
    }
}

}  // namespace
}  // namespace texelscope::watertight_test
