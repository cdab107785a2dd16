// What is drawn: a framebuffer, textures, polygons, and meshes that polygons are made from (core/scene/place.h). The
// file format is `core/scene/json.h`'s.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/rect.h"
#include "core/geometry/mesh.h"
#include "core/geometry/vertex.h"
#include "core/image/texture.h"
#include "core/scene/random.h"

namespace texelscope {

enum class Depth : std::uint8_t { off, less };
enum class Cull : std::uint8_t { none, back };

struct Framebuffer {
    int width = 64, height = 48;     ///< [px], 1 to kMaxSize
    int origin_x = 0, origin_y = 0;  ///< the absolute pixel at the picture's top left
    Rgb clear{};

    [[nodiscard]] Rect rect() const { return {origin_x, origin_y, origin_x + width, origin_y + height}; }
    friend bool operator==(const Framebuffer&, const Framebuffer&) = default;
};

/// What a placed mesh is.
enum class Shape3d : std::uint8_t { cube, dodecahedron, icosahedron, torus, jelly_cubes, obj };

/// A mesh in the world, whose axes are those of core/geometry/mesh.h. A corner is scaled, turned, then moved.
struct MeshPlacement {
    Shape3d shape = Shape3d::cube;
    std::string file;                   ///< of an OBJ model, as the scene spells it; else empty
    std::shared_ptr<const Mesh> model;  ///< what that file holds; else null
    std::vector<int> textures{0};       ///< of the faces in turn; of jelly cubes the big one's, the small one's
    glm::vec3 rotate{0, 0, 0};          ///< [degrees], as core/geometry/camera.h's rotation takes them
    glm::vec3 rotate2{0, 0, 0};         ///< the same of the small one of jelly cubes; `rotate` is the big one's
    glm::vec3 move{0, 0, 0};
    float scale = 1;
    float ratio = 0.8F;          ///< of jelly cubes: the small one's size over the big one's
    std::optional<float> light;  ///< of all faces; else each has 0.5 + 0.49 |n_z|
    bool half = false;           ///< Polygon::half of all faces
    friend bool operator==(const MeshPlacement&, const MeshPlacement&) = default;
};

/// The eye is at the world's origin and looks along z.
struct Camera {
    float focal = 0;  ///< how far the screen is from the eye [px]; 0 = the framebuffer's width
    float near = 0;   ///< what lies nearer along z is cut away; 0 = the default of core/scene/place.h
    friend bool operator==(const Camera&, const Camera&) = default;
};

/// A texture that moves.
struct Animation {
    int texture = 0;                                     ///< index into Scene::textures, where one of `frames` is
    std::vector<std::shared_ptr<const Texture>> frames;  ///< one or more of one size, from a strip or a file each
};

struct Scene {
    Framebuffer framebuffer;
    Depth depth = Depth::off;
    Cull cull = Cull::none;
    std::vector<std::shared_ptr<const Texture>> textures;  ///< shared: a scene is copied on every edit
    std::vector<Animation> animations;
    std::vector<Polygon> polygons;  ///< the scene's own, then those made from `meshes`
    std::vector<MeshPlacement> meshes;
    bool size_twice = false;  ///< quirk of all jelly cubes (core/scene/jelly_quirk.h)
    Camera camera;
    std::optional<RandomTriangles> random;  ///< triangles of chance, after all other polygons
};

/// Puts frame `n` modulo their number into the place of each texture that moves.
void show_frame(Scene& scene, int n);

}  // namespace texelscope
