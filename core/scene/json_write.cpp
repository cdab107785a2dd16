#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <string>
#include <vector>

#include "core/scene/jelly_quirk.h"
#include "core/scene/json.h"
#include "core/scene/names.h"

namespace texelscope {
namespace {

using Out = std::back_insert_iterator<std::string>;

std::string json_text(std::string_view text) {
    std::string out = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\')
            (out += '\\') += c;
        else if (static_cast<unsigned char>(c) < 0x20)
            fmt::format_to(Out(out), "\\u{:04x}", static_cast<int>(c));
        else
            out += c;
    }
    return out += '"';
}

/// The shortest decimal that reads back as the same float32.
std::string json_number(float value) {
    if (std::isnan(value)) return "\"nan\"";
    if (std::isinf(value)) return value > 0 ? "\"inf\"" : "\"-inf\"";
    if (value == 0 && std::signbit(value)) return "-0.0";  // "-0" would be read as a whole number, which has no sign
    return fmt::format("{}", value);
}

/// @param animation  of which the texture is a frame; null for one that does not move.
std::string texture_json(const Texture& texture, const Animation* animation) {
    std::string out = "{ \"name\": " + json_text(texture.name);
    const TextureSource& source = texture.source;
    if (animation != nullptr && source.frames == 0) {
        out += ", \"files\": [";
        const char* before = "";
        for (const auto& frame : animation->frames) {
            out += before + json_text(frame->source.file);
            before = ", ";
        }
        out += "]";
    } else if (!source.file.empty()) {
        out += ", \"file\": " + json_text(source.file);
        if (source.frames != 0) fmt::format_to(Out(out), ", \"frames\": {}", source.frames);
    } else {
        fmt::format_to(Out(out), ", \"pattern\": \"{}\", \"size\": [{}, {}]",
                       kPatternNames[static_cast<std::size_t>(source.pattern)], texture.width(), texture.height());
    }
    fmt::format_to(Out(out), ", \"wrap\": \"{}\"", kWrapNames[static_cast<std::size_t>(texture.wrap)]);
    if (source.palette != 0) fmt::format_to(Out(out), ", \"palette\": {}", source.palette);
    return out + " }";
}

void write_polygon(const Polygon& polygon, const Scene& scene, std::string& out) {
    out += "{ ";
    if (polygon.texture >= 0 && polygon.texture < static_cast<int>(scene.textures.size()))
        out += "\"texture\": " + json_text(scene.textures[static_cast<std::size_t>(polygon.texture)]->name) + ", ";
    if (polygon.half) out += "\"blend\": \"half\", ";
    fmt::format_to(Out(out), "\"light\": {}, \"vertices\": [", json_number(polygon.light));
    const char* before = "\n      ";
    for (const Vertex& v : polygon.vertices) {
        fmt::format_to(Out(out), R"({}{{ "x": {}, "y": {}, "z": {}, "w": {}, "u": {}, "v": {} }})", before,
                       json_number(v.x), json_number(v.y), json_number(v.z), json_number(v.w), json_number(v.u),
                       json_number(v.v));
        before = ",\n      ";
    }
    out += " ] }";
}

std::string json_vector(const glm::vec3& v) {
    return fmt::format("[{}, {}, {}]", json_number(v.x), json_number(v.y), json_number(v.z));
}

void write_mesh(const MeshPlacement& mesh, const Scene& scene, std::string& out) {
    if (mesh.shape == Shape3d::obj)
        out += "{ \"obj\": " + json_text(mesh.file);
    else
        fmt::format_to(Out(out), "{{ \"solid\": \"{}\"", kSolidNames[static_cast<std::size_t>(mesh.shape)]);
    std::string names;
    for (const int texture : mesh.textures)
        if (texture >= 0 && texture < static_cast<int>(scene.textures.size()))
            names += (names.empty() ? "" : ", ") + json_text(scene.textures[static_cast<std::size_t>(texture)]->name);
    if (!names.empty()) out += ", \"texture\": [" + names + "]";
    fmt::format_to(Out(out), ", \"rotate\": {}, \"move\": {}, \"scale\": {}", json_vector(mesh.rotate),
                   json_vector(mesh.move), json_number(mesh.scale));
    if (mesh.shape == Shape3d::jelly_cubes)
        fmt::format_to(Out(out), ", \"ratio\": {}, \"rotate2\": {}", json_number(mesh.ratio),
                       json_vector(mesh.rotate2));
    if (mesh.half) out += ", \"blend\": \"half\"";
    if (mesh.light) out += ", \"light\": " + json_number(*mesh.light);
    out += " }";
}

void write_camera(const Camera& camera, std::string& out) {
    std::string members;
    if (camera.focal > 0) members += " \"focal\": " + json_number(camera.focal);
    if (camera.near > 0) members += (members.empty() ? " \"near\": " : ", \"near\": ") + json_number(camera.near);
    if (!members.empty()) out += ",\n  \"camera\": {" + members + " }";
}

void write_random(const RandomTriangles& r, std::string& out) {
    fmt::format_to(Out(out), ",\n  \"random\": {{ \"triangles\": {}, \"size\": {}, \"seed\": {}", r.count,
                   json_number(r.size), r.seed);
    if (r.kind != RandomKind::plain) out += ", \"kind\": " + json_text(kRandomKinds[static_cast<std::size_t>(r.kind)]);
    if (r.waste > 0) fmt::format_to(Out(out), ", \"waste\": {}", r.waste);
    out += " }";
}

}  // namespace

std::string scene_to_json(const Scene& scene) {
    const Framebuffer& f = scene.framebuffer;
    std::string out = "{ \"texelscope\": 1,\n";
    fmt::format_to(
        Out(out),
        "  \"framebuffer\": {{ \"width\": {}, \"height\": {}, \"origin\": [{}, {}], \"clear\": [{}, {}, {}] }},\n",
        f.width, f.height, f.origin_x, f.origin_y, f.clear.r, f.clear.g, f.clear.b);
    fmt::format_to(Out(out), "  \"depth\": \"{}\", \"cull\": \"{}\",\n",
                   kDepthNames[static_cast<std::size_t>(scene.depth)],
                   kCullNames[static_cast<std::size_t>(scene.cull)]);
    out += "  \"textures\": [";
    const char* before = "\n    ";
    std::vector<const Animation*> moves(scene.textures.size());
    for (const Animation& animation : scene.animations)
        if (!animation.frames.empty()) moves[static_cast<std::size_t>(animation.texture)] = &animation;
    for (std::size_t n = 0; n < scene.textures.size(); ++n) {
        out += before + texture_json(*scene.textures[n], moves[n]);
        before = ",\n    ";
    }
    out += " ],\n  \"polygons\": [";
    before = "\n    ";
    for (const Polygon& polygon : scene.polygons) {
        if (polygon.mesh >= 0 || polygon.random) continue;
        out += before;
        write_polygon(polygon, scene, out);
        before = ",\n    ";
    }
    out += " ]";
    if (!scene.meshes.empty()) out += ",\n  \"meshes\": [";
    before = "\n    ";
    for (const MeshPlacement& mesh : scene.meshes) {
        out += before;
        write_mesh(mesh, scene, out);
        before = ",\n    ";
    }
    if (!scene.meshes.empty()) out += " ]";
    if (scene.size_twice) out += ",\n  \"quirks\": [" + json_text(kJellyQuirk.field) + "]";
    write_camera(scene.camera, out);
    if (scene.random) write_random(*scene.random, out);
    return out + " }\n";
}

}  // namespace texelscope
