#include "core/scene/triangles_scene.h"

#include <gtest/gtest.h>

namespace texelscope::triangles_scene_test {
namespace {

TrianglesFile one_triangle() {
    return {.width = 5,
            .height = 7,
            .texture_width = 4,
            .texture_height = 8,
            .vertices = {{1, 2, 3, 4, .5F, .25F}, {5, 6, 7, 8, -2, 0}, {9, 10, 11, 12, 1, 1}}};
}

TEST(TrianglesScene, HasTexelsForRepeats) {
    TrianglesFile file = one_triangle();
    file.perspective = true;
    const Scene scene = scene_of(file, Image(16, 32));
    EXPECT_EQ(scene.framebuffer, (Framebuffer{.width = 5, .height = 7}));
    ASSERT_EQ(scene.polygons.size(), 1U);
    EXPECT_EQ(scene.polygons[0].vertices,
              (std::vector<Vertex>{{1, 2, 3, 4, 8, 8}, {5, 6, 7, 8, -32, 0}, {9, 10, 11, 12, 16, 32}}));
    ASSERT_EQ(scene.textures.size(), 1U);
    EXPECT_EQ(scene.textures[0]->texels, Image(16, 32));
    EXPECT_EQ(scene.textures[0]->wrap, Wrap::repeat);
}

TEST(TrianglesScene, IsAffineWhereTheFileIs) {
    const Scene scene = scene_of(one_triangle(), Image(1, 1));
    for (const Vertex& vertex : scene.polygons[0].vertices) EXPECT_EQ(vertex.w, 1);
}

TEST(TrianglesScene, TestsDepthAndCullsWhereTheFileDoes) {
    TrianglesFile file = one_triangle();
    EXPECT_EQ(scene_of(file, Image(1, 1)).depth, Depth::off);
    EXPECT_EQ(scene_of(file, Image(1, 1)).cull, Cull::none);
    file.depth = file.cull_back = true;
    EXPECT_EQ(scene_of(file, Image(1, 1)).depth, Depth::less);
    EXPECT_EQ(scene_of(file, Image(1, 1)).cull, Cull::back);
}

TEST(TrianglesScene, HasTexelsOfItsOwnThatSayWhereTheyLie) {
    TrianglesFile file = one_triangle();
    file.texture_width = 256, file.texture_height = 256;
    const Image texels = default_texels(file);
    EXPECT_EQ(texels.at(17, 200), (Rgb{17, 200, texels.at(0, 0).b}));
    EXPECT_EQ(texels.width(), 256);
    EXPECT_EQ(texels.height(), 256);
}

}  // namespace
}  // namespace texelscope::triangles_scene_test
