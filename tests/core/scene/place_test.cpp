#include "core/scene/place.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <map>
#include <random>
#include <set>

#include "core/geometry/polygon.h"
#include "core/geometry/solids.h"
#include "tests/core/method/cases.h"

namespace texelscope::place_test {
namespace {

constexpr std::array kSolids{Shape3d::cube, Shape3d::dodecahedron, Shape3d::icosahedron, Shape3d::torus};

/// One mesh in the middle of a frame of 64 x 48, wholly on it.
Scene scene_with(Shape3d shape, const glm::vec3& rotate, Cull cull = Cull::back) {
    Scene scene;
    scene.framebuffer = {.width = 64, .height = 48};
    scene.cull = cull;
    scene.textures = {laws::texture_of(16, 8, Wrap::repeat), laws::texture_of(4, 4, Wrap::repeat)};
    MeshPlacement mesh;
    mesh.shape = shape, mesh.rotate = rotate, mesh.move = {0.1F, -0.2F, 8};
    mesh.scale = shape == Shape3d::torus || shape == Shape3d::cube ? 1.0F : 2.0F;
    mesh.textures = {0, 1};
    scene.meshes = {mesh};
    return scene;
}

glm::vec3 any_angles(laws::Dice& dice) { return {dice.within(0, 360), dice.within(0, 360), dice.within(0, 360)}; }

TEST(Place, TurningThereAndBackKeepsTheAnglesToAHundredth) {
    laws::Dice dice(7);
    for (int n = 0; n < 500; ++n) {
        const glm::vec3 start = any_angles(dice);
        const int axis = dice.whole(0, 2);
        const double by = double{dice.within(-180, 180)};
        const glm::vec3 there = turned_angles(start, axis, by);
        for (int a = 0; a < 3; ++a) EXPECT_NEAR(there[a], std::round(there[a] * 100) / 100, 1e-4);
        const glm::dmat3 expected = turned(rotation(start), axis, by), got = rotation(there);
        const glm::dmat3 back = rotation(turned_angles(there, axis, -by)), first = rotation(start);
        for (int c = 0; c < 3; ++c) {
            EXPECT_LT(glm::length(got[c] - expected[c]), 4e-4);
            EXPECT_LT(glm::length(back[c] - first[c]), 8e-4);
        }
    }
}

TEST(Place, MakesPolygonsOfFrontFacesOnlyWhereBackFacesAreCulled) {
    laws::Dice dice(1);
    for (const Shape3d shape : kSolids) {
        const glm::vec3 angles = any_angles(dice);
        Scene all = scene_with(shape, angles, Cull::none), front = scene_with(shape, angles, Cull::back);
        const auto faces = place_meshes(all);
        const auto culled = place_meshes(front);
        EXPECT_EQ(all.polygons.size(), faces.size());
        ASSERT_EQ(culled.size(), faces.size());
        std::size_t fronts = 0;
        for (std::size_t n = 0; n < faces.size(); ++n) {
            EXPECT_EQ(culled[n].doubled_area, faces[n].doubled_area);
            EXPECT_EQ(culled[n].polygon >= 0, culled[n].doubled_area > 0);
            EXPECT_EQ(culled[n].face, static_cast<int>(n));
            fronts += culled[n].polygon >= 0 ? 1 : 0;
        }
        EXPECT_EQ(front.polygons.size(), fronts);
    }
}

/// A face is a front face on the screen exactly where the eye is outside its plane.
TEST(Place, FacingOnTheScreenIsFacingInTheWorld) {
    laws::Dice dice(2);
    for (int i = 0; i < 200; ++i) {
        const Shape3d shape = kSolids[static_cast<std::size_t>(i) % kSolids.size()];
        Scene scene = scene_with(shape, any_angles(dice));
        const Mesh mesh = shape == Shape3d::cube           ? cube()
                          : shape == Shape3d::dodecahedron ? dodecahedron()
                          : shape == Shape3d::icosahedron  ? icosahedron()
                                                           : torus();
        const glm::dmat3 turn = rotation(scene.meshes[0].rotate);
        for (const PlacedFace& placed : place_meshes(scene)) {
            const MeshFace& face = mesh.faces[static_cast<std::size_t>(placed.face)];
            const glm::dvec3 normal = turn * glm::normalize(area_vector(mesh.vertices, face));
            const glm::dvec3 centre =
                turn * (middle(mesh.vertices, face) * double{scene.meshes[0].scale}) + glm::dvec3(scene.meshes[0].move);
            EXPECT_NEAR(placed.n_z, normal.z, 1e-12);
            const glm::dvec3 first =
                turn * (mesh.vertices[static_cast<std::size_t>(face[0].vertex)] * double{scene.meshes[0].scale}) +
                glm::dvec3(scene.meshes[0].move);
            EXPECT_NEAR(placed.depth, shape == Shape3d::torus ? first.z : centre.z, 1e-12);
            EXPECT_NEAR(placed.light, 0.5 + 0.49 * std::fabs(normal.z), 1e-6);
            const double seen = -glm::dot(normal, centre);
            if (std::fabs(seen) > 1e-4) {
                EXPECT_EQ(placed.doubled_area > 0, seen > 0);
            }
        }
    }
}

TEST(Place, WhatFloat32LosesIsKeptBesideIt) {
    laws::Dice dice(9);
    for (const Shape3d shape : kSolids) {
        Scene scene = scene_with(shape, any_angles(dice));
        place_meshes(scene);
        int lost = 0;
        for (const Polygon& polygon : scene.polygons) {
            const Unrounded& kept = polygon.unrounded;
            ASSERT_EQ(kept.corners.size(), polygon.vertices.size());
            EXPECT_EQ(static_cast<float>(kept.light), polygon.light);
            for (std::size_t n = 0; n < kept.corners.size(); ++n) {
                EXPECT_EQ(static_cast<float>(kept.corners[n].x), polygon.vertices[n].x);
                EXPECT_EQ(static_cast<float>(kept.corners[n].y), polygon.vertices[n].y);
                lost += kept.corners[n].x != double{polygon.vertices[n].x} ? 1 : 0;
            }
        }
        EXPECT_GT(lost, 0);
    }
}

TEST(Place, CornersAreThePublishedProjection) {
    Scene scene = scene_with(Shape3d::torus, {10, 20, 30}, Cull::none);
    scene.camera.focal = 50;
    const auto faces = place_meshes(scene);
    const Mesh mesh = torus();
    const glm::dmat3 turn = rotation({10, 20, 30});
    for (const PlacedFace& placed : faces) {
        const Polygon& polygon = scene.polygons[static_cast<std::size_t>(placed.polygon)];
        EXPECT_EQ(polygon.face, placed.face);
        EXPECT_EQ(polygon.texture, placed.face % 2);
        const MeshFace& face = mesh.faces[static_cast<std::size_t>(placed.face)];
        const Texture& texture = *scene.textures[static_cast<std::size_t>(polygon.texture)];
        for (std::size_t i = 0; i < face.size(); ++i) {
            const glm::dvec3 p =
                turn * mesh.vertices[static_cast<std::size_t>(face[i].vertex)] + glm::dvec3(scene.meshes[0].move);
            const Vertex& v = polygon.vertices[i];
            EXPECT_NEAR(v.x, 32 + p.x * 50 / p.z, 1e-5);
            EXPECT_NEAR(v.y, 24 - p.y * 50 / p.z, 1e-5);
            EXPECT_EQ(v.w, static_cast<float>(p.z));
            EXPECT_NEAR(v.z, 1 - 0.5 / p.z, 1e-6);
            EXPECT_EQ(v.u, static_cast<float>(face[i].uv.x * texture.width()));
            EXPECT_EQ(v.v, static_cast<float>(face[i].uv.y * texture.height()));
        }
    }
}

TEST(Place, FarFacesComeFirstWithoutADepthTest) {
    Scene scene = scene_with(Shape3d::torus, {10, 20, 30}, Cull::none);
    scene.meshes.push_back(scene.meshes[0]);
    scene.meshes[1].move.z = 8.5;
    const auto depth_of = [](const Polygon& p, const std::vector<PlacedFace>& faces) {
        for (const PlacedFace& face : faces)
            if (face.mesh == p.mesh && face.face == p.face) return face.depth;
        return 0.0;
    };
    const auto faces = place_meshes(scene);
    for (std::size_t i = 1; i < scene.polygons.size(); ++i)
        EXPECT_GE(depth_of(scene.polygons[i - 1], faces), depth_of(scene.polygons[i], faces));
    scene.depth = Depth::less;
    const auto in_order = place_meshes(scene);
    for (std::size_t i = 0; i < in_order.size(); ++i) EXPECT_EQ(in_order[i].polygon, static_cast<int>(i));
}

TEST(Place, AgainReplacesWhatItMadeAndKeepsTheRest) {
    Scene scene = scene_with(Shape3d::cube, {10, 20, 30});
    const Polygon own{.vertices = {{.x = 1}, {.x = 9}, {.y = 9}}};
    scene.polygons = {own};
    place_meshes(scene);
    const auto first = scene.polygons;
    EXPECT_EQ(first.size(), 4u);
    place_meshes(scene);
    EXPECT_EQ(scene.polygons, first);
    EXPECT_EQ(scene.polygons[0], own);
    scene.meshes.clear();
    place_meshes(scene);
    EXPECT_EQ(scene.polygons, std::vector{own});
}

TEST(Place, LightAndBlendOfAMeshAreItsFaces) {
    Scene scene = scene_with(Shape3d::cube, {10, 20, 30});
    scene.meshes[0].light = 0.25F, scene.meshes[0].half = true;
    place_meshes(scene);
    for (const Polygon& polygon : scene.polygons) EXPECT_TRUE(polygon.light == 0.25F && polygon.half);
}

TEST(Place, DefaultsFollowTheScene) {
    Scene scene = scene_with(Shape3d::cube, {0, 0, 0});
    EXPECT_EQ(view_of(scene).focal, 64);
    EXPECT_EQ(view_of(scene).near, 0.5);
    scene.meshes[0].move.z = 400;
    EXPECT_EQ(view_of(scene).near, 25);
    scene.meshes[0].move.z = -1;
    EXPECT_EQ(view_of(scene).near, 1 / 16.0);
    scene.camera = {.focal = 300, .near = 0.25F};
    EXPECT_EQ(view_of(scene).focal, 300);
    EXPECT_EQ(view_of(scene).near, 0.25);
}

/// The eye inside, behind, and on a face of the solid.
TEST(Place, WhatIsBehindTheEyeIsCutAway) {
    laws::Dice dice(3);
    for (int i = 0; i < 400; ++i) {
        Scene scene = scene_with(kSolids[static_cast<std::size_t>(i) % kSolids.size()], any_angles(dice), Cull::none);
        scene.meshes[0].move = {0, 0, static_cast<float>(i % 7 - 3)};
        place_meshes(scene);
        for (const Polygon& polygon : scene.polygons) {
            EXPECT_TRUE(is_drawable(polygon)) << polygon_fault(polygon);
            for (const Vertex& v : polygon.vertices) {
                EXPECT_GE(v.w, 1 / 16.0F);
            }
        }
    }
}

TEST(Place, WhatIsNotANumberDrawsNothing) {
    for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
        for (int field = 0; field < 6; ++field) {
            for (const Shape3d shape : {Shape3d::cube, Shape3d::torus, Shape3d::jelly_cubes}) {
                Scene scene = scene_with(shape, {10, 20, 30}, Cull::none);
                MeshPlacement& mesh = scene.meshes[0];
                float* const numbers[] = {&mesh.rotate.x, &mesh.move.z,    &mesh.scale,
                                          &mesh.move.y,   &mesh.rotate2.y, &mesh.ratio};
                *numbers[field] = bad;
                place_meshes(scene);
                EXPECT_TRUE(scene.polygons.empty()) << field;
            }
        }
    }
    Scene scene = scene_with(Shape3d::cube, {0, 0, 0}, Cull::none);
    scene.meshes[0].textures = {7};
    place_meshes(scene);
    EXPECT_TRUE(scene.polygons.empty());
}

using Counts = std::map<std::pair<Integer, Integer>, int>;

/// For each sample the sum over the polygons that cover it.
Counts covered(const Scene& scene, const DrawSettings& settings, const std::function<int(const Polygon&)>& weight) {
    Counts counts;
    const Drawing drawing(scene, settings);
    each_sample(drawing, 0, drawing.shape_count(), {scene.framebuffer.rect(), 1}, [&](int shape, const Sample& s) {
        if (s.fate != Fate::written) return;
        counts[{s.x, s.y}] += weight(scene.polygons[static_cast<std::size_t>(drawing.polygon_of(shape))]);
    });
    return counts;
}

std::vector<DrawSettings> exact_methods() {
    std::vector<DrawSettings> settings;
    for (const char* id : {"edge-equations", "sections"})
        settings.push_back(laws::settings_of(*find_method(id), NumberFormat::exact, 0));
    return settings;
}

/// The outline of what the front faces of a convex solid cover: their sides that no two of them share.
Polygon outline(const Scene& scene) {
    using Point = std::pair<float, float>;
    std::set<std::pair<Point, Point>> sides;
    for (const Polygon& polygon : scene.polygons) {
        for (std::size_t i = 0; i < polygon.vertices.size(); ++i) {
            const Vertex &a = polygon.vertices[i], &b = polygon.vertices[(i + 1) % polygon.vertices.size()];
            const Point p(a.x, a.y), q(b.x, b.y);
            if (sides.erase({q, p}) == 0) sides.insert({p, q});
        }
    }
    Polygon ring;
    const std::map<Point, Point> next(sides.begin(), sides.end());
    EXPECT_EQ(next.size(), sides.size());
    Point at = next.begin()->first;
    do {
        ring.vertices.push_back({.x = at.first, .y = at.second});
        at = next.at(at);
    } while (at != next.begin()->first && ring.vertices.size() <= next.size());
    EXPECT_EQ(ring.vertices.size(), next.size());
    return ring;
}

TEST(Place, ConvexSolidsCoverTheirOutlineOnce) {
    for (const DrawSettings& settings : exact_methods()) {
        laws::Dice dice(4);
        for (int i = 0; i < 24; ++i) {
            Scene scene = scene_with(kSolids[static_cast<std::size_t>(i) % 3], any_angles(dice));
            place_meshes(scene);
            const Counts counts = covered(scene, settings, [](const Polygon&) { return 1; });
            Scene whole = scene;
            whole.polygons = {outline(scene)};
            ASSERT_TRUE(is_convex(whole.polygons[0].vertices));
            EXPECT_EQ(counts, covered(whole, settings, [](const Polygon&) { return 1; })) << settings.method->id << i;
            EXPECT_GT(counts.size(), 100u);
        }
    }
}

/// Front faces count +1 and back faces -1: nothing is left over a closed solid, convex or not.
TEST(Place, ClosedSolidsAreEnteredAsOftenAsTheyAreLeft) {
    for (const DrawSettings& settings : exact_methods()) {
        laws::Dice dice(5);
        for (int i = 0; i < 16; ++i) {
            Scene scene = scene_with(kSolids[static_cast<std::size_t>(i) % 4], any_angles(dice), Cull::none);
            place_meshes(scene);
            for (const auto& [place, sum] : covered(scene, settings, [](const Polygon& polygon) {
                     return doubled_area(polygon.vertices) > 0 ? 1 : -1;
                 }))
                ASSERT_EQ(sum, 0) << settings.method->id << " " << i << ": " << place.first << ", " << place.second;
        }
    }
}

TEST(Place, JellyCubesInsideEachOtherAreEnteredAsOftenAsTheyAreLeft) {
    for (const DrawSettings& settings : exact_methods()) {
        laws::Dice dice(6);
        for (int i = 0; i < 12; ++i) {
            Scene scene = scene_with(Shape3d::jelly_cubes, any_angles(dice), Cull::none);
            scene.meshes[0].rotate2 = any_angles(dice), scene.meshes[0].ratio = dice.within(0.5, 1.5);
            place_meshes(scene);
            const JellyCubes cubes = jelly_cubes_of(scene.meshes[0], false);
            for (const auto& [place, sum] : covered(scene, settings, [&](const Polygon& polygon) {
                     if (!cubes.pieces[static_cast<std::size_t>(polygon.face)].inside) return 0;
                     return doubled_area(polygon.vertices) > 0 ? 1 : -1;
                 }))
                ASSERT_EQ(sum, 0) << settings.method->id << " " << i << ": " << place.first << ", " << place.second;
        }
    }
}

TEST(Place, PiecesOfJellyCubesHaveTheirCubesTexture) {
    Scene scene = scene_with(Shape3d::jelly_cubes, {10, 20, 30}, Cull::none);
    place_meshes(scene);
    const JellyCubes cubes = jelly_cubes_of(scene.meshes[0], false);
    ASSERT_EQ(scene.polygons.size(), cubes.pieces.size());
    for (const Polygon& polygon : scene.polygons)
        EXPECT_EQ(polygon.texture, cubes.pieces[static_cast<std::size_t>(polygon.face)].cube);
}

TEST(Place, ScaledTwiceJellyCubesAreCutOtherwise) {
    Scene scene = scene_with(Shape3d::jelly_cubes, {10, 20, 30}, Cull::none);
    scene.meshes[0].rotate2 = {40, 5, 60}, scene.meshes[0].ratio = 0.8F;
    place_meshes(scene);
    const std::vector<Polygon> right = scene.polygons;
    scene.size_twice = true;
    place_meshes(scene);
    EXPECT_NE(scene.polygons, right);
    EXPECT_EQ(scene.polygons.size(), jelly_cubes_of(scene.meshes[0], true).pieces.size());
    scene.size_twice = false;
    place_meshes(scene);
    EXPECT_EQ(scene.polygons, right);
}

TEST(ShowFrame, GoesRoundBothWays) {
    Scene scene;
    scene.textures = {laws::texture_of(2, 2, Wrap::repeat), laws::texture_of(3, 3, Wrap::repeat)};
    Animation animation{.texture = 1};
    for (int n = 0; n < 3; ++n) animation.frames.push_back(laws::texture_of(4, 4, Wrap::repeat));
    scene.animations = {animation};
    for (const int n : {0, 1, 2, 3, -1, -3, std::numeric_limits<int>::min(), std::numeric_limits<int>::max()}) {
        show_frame(scene, n);
        EXPECT_EQ(scene.textures[1], animation.frames[static_cast<std::size_t>(((n % 3) + 3) % 3)]) << n;
        EXPECT_EQ(scene.textures[0]->width(), 2);
    }
}

}  // namespace
}  // namespace texelscope::place_test
