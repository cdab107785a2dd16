#include "core/geometry/obj.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <random>
#include <string>

#include "core/geometry/solids.h"

namespace texelscope::obj_test {
namespace {

Mesh read(const std::string& text) {
    const Result<Mesh> mesh = parse_obj(text, "m.obj");
    EXPECT_TRUE(mesh) << mesh.error().text();
    return mesh ? *mesh : Mesh();
}

std::string error_of(const std::string& text) {
    const Result<Mesh> mesh = parse_obj(text, "m.obj");
    return mesh ? "none" : mesh.error().text();
}

const std::string kCorners = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

TEST(Obj, PolygonsStayPolygons) {
    const Mesh mesh = read("# a comment\nmtllib never-opened.mtl\no one\ng two\nusemtl red\ns off\n" + kCorners +
                           "v 0.5 1.5 0\r\nf 1 2 3 5 4\rf 1 2 3\n");
    EXPECT_EQ(mesh.vertices.size(), 5u);
    ASSERT_EQ(mesh.faces.size(), 2u);
    EXPECT_EQ(mesh.faces[0].size(), 5u);
    EXPECT_EQ(mesh.faces[1].size(), 3u);
}

/// The file's z points to the viewer and its faces run counter-clockwise: seen by the viewer it is a front face there,
/// and so it is here.
TEST(Obj, TurnsItsAxesIntoTheWorlds) {
    const Mesh mesh = read("v 0 0 5\nv 1 0 5\nv 0 1 5\nvt 0 0\nvt 1 0\nvt 0 1\nf 1/1 2/2 3/3\n");
    EXPECT_EQ(mesh.vertices[1], glm::dvec3(1, 0, -5));
    EXPECT_LT(area_vector(mesh.vertices, mesh.faces[0]).z, 0);
    for (const FaceCorner& corner : mesh.faces[0])
        EXPECT_EQ(corner.uv, corner.vertex == 0   ? glm::dvec2(0, 1)
                             : corner.vertex == 1 ? glm::dvec2(1, 1)
                                                  : glm::dvec2(0, 0));
}

TEST(Obj, ReadsEveryFormOfAnIndex) {
    const std::string text = kCorners + "vt 0.25 0.5\nvt 0 0\nvt 1 0.5 0\nvn 0 0 1\n";
    const Mesh plain = read(text + "f 1 2 3");
    for (const char* face : {"f -4 -3 -2", "f 1//1 2//1 3//1", "f  1//-1\t2//1 3//1 ", "  f 1 2 3"})
        EXPECT_EQ(read(text + face), plain) << face;
    const Mesh with_uv = read(text + "f 1/1 2/2 3/3");
    EXPECT_EQ(read(text + "f 1/1/1 2/2/1 3/3/1"), with_uv);
    EXPECT_EQ(read(text + "f -4/-3 -3/-2 -2/-1"), with_uv);
    EXPECT_EQ(with_uv.faces[0][2].uv, glm::dvec2(0.25, 0.5));
    EXPECT_NE(with_uv, plain);
    EXPECT_EQ(read("f 1 2 3\n" + kCorners).faces, plain.faces);  // vertices may follow
}

TEST(Obj, FacesWithoutTextureCornersHaveARegularPolygons) {
    const Mesh mesh = read(kCorners + "f 1 2 3 4");
    for (const FaceCorner& corner : mesh.faces[0]) EXPECT_EQ(corner.uv, polygon_uv(corner.vertex, 4));
}

TEST(Obj, EveryFaultIsNamedWithItsLine) {
    const std::vector<std::pair<std::string, std::string>> cases{
        {"", "m.obj: has no face, expected lines such as 'f 1 2 3'"},
        {kCorners, "m.obj: has no face, expected lines such as 'f 1 2 3'"},
        {"v 1 2\nf 1 2 3", "m.obj:1: 'v' has 2 values, expected 3 or more"},
        {"v 1 2 nan", "m.obj:1: 'v' has a value that is not a finite number"},
        {"v 1 2 inf", "m.obj:1: 'v' has a value that is not a finite number"},
        {"v 1 2 0x1", "m.obj:1: 'v' has a value that is not a finite number"},
        {"\n\rv 1 2 1e99999", "m.obj:3: 'v' has a value that is not a finite number"},
        {"\r\nv 1 2 1e999\nf 1 1 1", "m.obj: vertex 1 is beyond 1e+09, the largest coordinate"},
        {kCorners + "f 1 2", "m.obj:5: 'f' has 2 values, expected 3 or more"},
        {kCorners + "f 1 2 x", "m.obj:5: 'f' has a value that is not an index such as 1, 1/2, 1//3 or 1/2/3"},
        {kCorners + "f 1/ 2 3", "m.obj:5: 'f' has a value that is not an index such as 1, 1/2, 1//3 or 1/2/3"},
        {kCorners + "f 1 2 99999999999", "m.obj:5: 'f' has a value that is not an index such as 1, 1/2, 1//3 or 1/2/3"},
        {kCorners + "f 1 2 5", "m.obj:5: corner 3 of the face refers to no vertex"},
        {kCorners + "f 1 0 3", "m.obj:5: corner 2 of the face refers to no vertex"},
        {kCorners + "f 1 -9 3", "m.obj:5: corner 2 of the face refers to no vertex"},
        {kCorners + "f 1/1 2 3", "m.obj:5: corner 1 of the face refers to no texture corner"},
        {kCorners + "f 1/-1 2 3", "m.obj:5: corner 1 of the face refers to no texture corner"},
        {kCorners + "vt 1e99 0\nf 1/1 2 3", "m.obj:6: corner 1 of the face is beyond 1e+09 textures"},
        {kCorners + "f 1 2 3\n\nf 1 2 2", "m.obj:7: two corners of the face that follow each other are at one place"},
        {kCorners + "v 2 0 0\nf 1 2 5", "m.obj:6: the face has no area"},
        {kCorners + "v 0.6 0.5 0\nf 1 2 5 3 4", "m.obj:6: the face is not convex"},
        {kCorners + "f 1 3 2 4", "m.obj:5: the face has no area"},
        {kCorners + "v 0.5 2 0\nf 1 3 4 2 5", "m.obj:6: the face is not convex"},
        {std::string("f 1 2 \0", 7), "m.obj:1: has a character of no text"},
    };
    for (const auto& [text, error] : cases) EXPECT_EQ(error_of(text), error);
}

TEST(Obj, TwiceRoundIsNotConvex) {
    std::string text = "v 1 0 0\nv 0.309 0.951 0\nv -0.809 0.588 0\nv -0.809 -0.588 0\nv 0.309 -0.951 0\n";
    EXPECT_EQ(read(text + "f 1 2 3 4 5").faces.size(), 1u);
    EXPECT_EQ(error_of(text + "f 1 3 5 2 4"), "m.obj:6: the face is not convex");
}

TEST(Obj, StraightCornersAndBentQuadsAreFine) {
    EXPECT_EQ(read(kCorners + "v 0.5 0 0\nf 1 5 2 3 4").faces[0].size(), 5u);
    EXPECT_EQ(read("v 0 0 0\nv 1 0 0.2\nv 1 1 0\nv 0 1 0.2\nf 1 2 3 4").faces[0].size(), 4u);
}

TEST(Obj, DamagedTextIsAMeshOrAnErrorOfOneLine) {
    std::mt19937 random(9);
    const std::string text = kCorners + "vt 0 1\nvt 1 1\nvn 0 0 1\nf 1/1 2/2 3/1\nf 1//1 2//1 3//1 4//1\n";
    for (int i = 0; i < 20000; ++i) {
        std::string damaged = text;
        for (int k = 0; k < 3; ++k) damaged[random() % damaged.size()] = "vtnf /-+.e019\n\r\t#\\"[random() % 19];
        const Result<Mesh> mesh = parse_obj(damaged, "m.obj");
        if (mesh) continue;
        ASSERT_EQ(mesh.error().where.rfind("m.obj", 0), 0u);
        ASSERT_EQ(mesh.error().text().find('\n'), std::string::npos);
    }
}

TEST(Obj, CountsAreBounded) {
    std::string faces = kCorners;
    for (int i = 0; i <= kMaxMeshFaces; ++i) faces += "f 1 2 3\n";
    EXPECT_EQ(error_of(faces), "m.obj:1000005: there are more than 1000000 faces");
    std::string vertices;
    for (int i = 0; i <= kMaxMeshVertices; ++i) vertices += "v 1 2 3\n";
    EXPECT_EQ(error_of(vertices), "m.obj:1000001: there are more than 1000000 vertices");
    EXPECT_EQ(error_of(std::string(kMaxObjBytes + 1, ' ')),
              "m.obj: is longer than 67108864 bytes, the most that is read");
}

}  // namespace
}  // namespace texelscope::obj_test
