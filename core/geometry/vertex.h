// The inputs of every method: vertices and convex polygons, unsnapped float32.
#pragma once

#include <glm/vec2.hpp>
#include <vector>

namespace texelscope {

/// One corner as a scene gives it (core/conventions.h says where the axes point).
struct Vertex {
    float x = 0, y = 0;  ///< on the screen [px]
    float z = 0;         ///< for the depth test [0 near, 1 far], affine over the screen
    float w = 1;         ///< clip-space w, the depth along the view axis; 1 = affine
    float u = 0, v = 0;  ///< [texels of its texture]

    friend bool operator==(const Vertex&, const Vertex&) = default;
};

/// What float32 loses of a polygon that was made from a mesh: for the variant as published, whose set-up is in double.
struct Unrounded {
    std::vector<glm::dvec2> corners;  ///< x and y on the screen [px], one for each vertex; empty: nothing was lost
    double light = 1;
    friend bool operator==(const Unrounded&, const Unrounded&) = default;
};

/// A convex polygon, three or more corners in order, either winding.
struct Polygon {
    std::vector<Vertex> vertices;
    int texture = 0;      ///< index into Scene::textures
    float light = 1;      ///< each channel becomes min(255, trunc(channel * light))
    int mesh = -1;        ///< index into Scene::meshes of the mesh it was made from; -1: the scene's own
    int face = -1;        ///< which face of that mesh; for jelly cubes which piece; -1: the scene's own
    bool random = false;  ///< made by Scene::random
    bool half = false;    ///< half-transparent: each channel becomes (old >> 1) + (new >> 1)
    Unrounded unrounded;

    friend bool operator==(const Polygon&, const Polygon&) = default;
};

}  // namespace texelscope
