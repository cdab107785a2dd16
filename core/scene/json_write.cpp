#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <string>

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

std::string texture_json(const Texture& texture) {
    std::string out = "{ \"name\": " + json_text(texture.name);
    if (!texture.source.file.empty())
        out += ", \"file\": " + json_text(texture.source.file);
    else
        fmt::format_to(Out(out), ", \"pattern\": \"{}\", \"size\": [{}, {}]",
                       kPatternNames[static_cast<std::size_t>(texture.source.pattern)], texture.width(),
                       texture.height());
    fmt::format_to(Out(out), ", \"wrap\": \"{}\"", kWrapNames[static_cast<std::size_t>(texture.wrap)]);
    if (texture.source.palette != 0) fmt::format_to(Out(out), ", \"palette\": {}", texture.source.palette);
    return out + " }";
}

void write_polygon(const Polygon& polygon, const Scene& scene, std::string& out) {
    out += "{ ";
    if (polygon.texture >= 0 && polygon.texture < static_cast<int>(scene.textures.size()))
        out += "\"texture\": " + json_text(scene.textures[static_cast<std::size_t>(polygon.texture)]->name) + ", ";
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
    for (const auto& texture : scene.textures) {
        out += before + texture_json(*texture);
        before = ",\n    ";
    }
    out += " ],\n  \"polygons\": [";
    before = "\n    ";
    for (const Polygon& polygon : scene.polygons) {
        out += before;
        write_polygon(polygon, scene, out);
        before = ",\n    ";
    }
    return out + " ] }\n";
}

}  // namespace texelscope
