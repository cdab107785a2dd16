#include "core/scene/mesh_reader.h"

#include <fmt/format.h>

#include <array>
#include <optional>
#include <utility>

#include "core/base/file.h"
#include "core/geometry/obj.h"
#include "core/scene/names.h"
#include "core/scene/place.h"

namespace texelscope {
namespace {

constexpr std::size_t kMostJellyPieces = 84;  // of each of 12 faces: 6 outside, one inside

}  // namespace

std::vector<MeshPlacement> MeshReader::meshes(const JsonValue& list) {
    std::vector<MeshPlacement> meshes;
    if (list.kind() != JsonKind::array) {
        read_.wrong(list, "meshes", "a list");
        return meshes;
    }
    for (const JsonValue value : list) {
        if (meshes.size() == kMaxMeshes)
            read_.fail(value.line(), fmt::format("there are more than {} meshes", kMaxMeshes));
        if (read_.failed()) break;
        meshes.push_back(mesh(value));
        if (!read_.failed()) allot(value, meshes.back());
    }
    return meshes;
}

MeshPlacement MeshReader::mesh(const JsonValue& value) {
    MeshPlacement m;
    bool has_solid = false, has_file = false;
    std::optional<JsonValue> of_jelly;
    const auto jelly_only = [&](const JsonValue& v) {
        if (!of_jelly) of_jelly = v;
    };
    read_.object(
        value, "a mesh",
        optional("solid",
                 [&](const JsonValue& v) {
                     m.shape = static_cast<Shape3d>(read_.choice(v, "solid", kSolidNames)), has_solid = true;
                 }),
        optional("obj",
                 [&](const JsonValue& v) {
                     m.file = read_.text(v, "obj of a mesh"), has_file = true;
                     if (!read_.failed()) m.model = model(v);
                 }),
        optional("texture", [&](const JsonValue& v) { m.textures = textures(v); }),
        optional("rotate", [&](const JsonValue& v) { m.rotate = vector(v, "rotate", kMaxDegrees); }),
        optional("move", [&](const JsonValue& v) { m.move = vector(v, "move", kMaxMove); }),
        optional("scale", [&](const JsonValue& v) { m.scale = read_.number_within(v, "scale", kMinScale, kMaxScale); }),
        optional("blend", [&](const JsonValue& v) { m.half = read_.choice(v, "blend", kBlendNames) == 1; }),
        optional("light", [&](const JsonValue& v) { m.light = read_.number_within(v, "light", 0, kMaxLight); }),
        optional("ratio",
                 [&](const JsonValue& v) {
                     m.ratio = read_.number_within(v, "ratio", kMinRatio, kMaxRatio), jelly_only(v);
                 }),
        optional("rotate2", [&](const JsonValue& v) { m.rotate2 = vector(v, "rotate2", kMaxDegrees), jelly_only(v); }));
    if (has_solid == has_file) read_.fail(value.line(), "a mesh: expected either 'solid' or 'obj'");
    if (has_file) m.shape = Shape3d::obj;
    if (of_jelly && m.shape != Shape3d::jelly_cubes)
        read_.fail(of_jelly->key_line(), fmt::format("'{}' is for jelly-cubes", of_jelly->key()));
    return m;
}

glm::vec3 MeshReader::vector(const JsonValue& value, std::string_view what, float most) {
    const auto v = read_.numbers_within<3>(value, what, -most, most);
    return {v[0], v[1], v[2]};
}

std::vector<int> MeshReader::textures(const JsonValue& value) {
    constexpr std::string_view kWhat = "texture of a mesh";
    if (value.kind() != JsonKind::array) return {find_texture_(value, kWhat)};
    std::vector<int> found;
    for (const JsonValue name : value) {
        found.push_back(find_texture_(name, kWhat));
        if (read_.failed()) break;
    }
    if (found.empty()) read_.wrong(value, kWhat, "a name, or a list of one or more");
    return found;
}

std::shared_ptr<const Mesh> MeshReader::model(const JsonValue& file) {
    const std::string title = "a mesh: file " + in_quotes(file.text());
    const auto fail = [&](const std::string& what) {
        read_.fail(file.line(), what);
        return nullptr;
    };
    const Result<std::filesystem::path> path = resolve_scene_file(std::string(file.text()), files_);
    if (!path) return fail(title + " " + path.error().what);
    std::shared_ptr<const Mesh>& known = models_[path->string()];
    if (known) return known;
    const Result<std::string> text = read_file(*path, kMaxObjBytes);
    if (!text) return fail(title + " " + text.error().what);
    Result<Mesh> mesh = parse_obj(*text, title);
    if (!mesh) return fail(mesh.error().text());
    known = std::make_shared<const Mesh>(*std::move(mesh));
    return known;
}

void MeshReader::allot(const JsonValue& value, const MeshPlacement& mesh) {
    const bool is_obj = mesh.shape == Shape3d::obj;
    faces_ += is_obj ? mesh.model->faces.size() : kMostJellyPieces;
    corners_ += is_obj ? mesh.model->vertices.size() : kMostJellyPieces;
    if (is_obj)
        for (const MeshFace& face : mesh.model->faces) corners_ += face.size();
    if (faces_ > kMaxMeshPolygons)
        read_.fail(value.line(), fmt::format("the meshes have more than {} faces together", kMaxMeshPolygons));
    if (corners_ > static_cast<std::size_t>(kMaxMeshVertices) + static_cast<std::size_t>(kMaxMeshCorners))
        read_.fail(value.line(), "the meshes have more vertices and corners together than one may have");
}

Camera MeshReader::camera(const JsonValue& value) {
    Camera camera;
    read_.object(
        value, "camera",
        optional("focal",
                 [&](const JsonValue& v) { camera.focal = read_.number_within(v, "focal", kMinFocal, kMaxFocal); }),
        optional("near",
                 [&](const JsonValue& v) { camera.near = read_.number_within(v, "near", kMinNear, kMaxNear); }));
    return camera;
}

}  // namespace texelscope
