#include "core/scene/json.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <system_error>
#include <unordered_map>
#include <utility>

#include "core/base/file.h"
#include "core/geometry/polygon.h"
#include "core/image/load.h"
#include "core/image/palette.h"
#include "core/scene/names.h"
#include "core/scene/scene_reader.h"

namespace texelscope {
namespace {

namespace fs = std::filesystem;

/// Whether `path`, which is canonical, lies in the tree of `folder`.
bool is_inside(const fs::path& path, const fs::path& folder) {
    if (folder.empty()) return false;
    std::error_code failed;
    const fs::path root = fs::canonical(folder, failed);
    return !failed && std::mismatch(root.begin(), root.end(), path.begin(), path.end()).first == root.end();
}

/// The file that a scene means by `name`, all links followed; the error lacks its place.
Result<fs::path> resolve(const std::string& name, const SceneFiles& files) {
    if (name.empty() || name.find('\0') != name.npos) return Error{"", "is not a file name"};
    if (files.folder.empty()) return Error{"", "cannot be read: this scene has no folder"};
    std::error_code failed;
    fs::path path = fs::weakly_canonical(files.folder / name, failed);
    if (failed) return Error{"", "cannot be read: " + failed.message()};
    if (!is_inside(path, files.folder) && !is_inside(path, files.assets))
        return Error{"", "lies outside the scene's folder and the assets"};
    if (!fs::exists(path, failed)) return Error{"", "does not exist"};
    return path;
}

/// Reads the parts of a scene in an order that suits, whatever their order in the text.
class SceneReader {
public:
    SceneReader(std::string_view name, const SceneFiles& files) : read_(name), files_(files) {}

    Result<LoadedScene> scene(const JsonValue& root) {
        check_version(root);
        read_root(root);
        if (read_.failed()) return *read_.error();
        return std::move(loaded_);
    }

private:
    struct TextureText {
        std::string name;
        int line = 0;
        Wrap wrap = Wrap::repeat;
        std::optional<std::string> file;
        std::optional<Pattern> pattern;
        std::optional<std::array<int, 2>> size;
        int palette = 0;
    };

    /// First of all: what a later version says may not be understood.
    void check_version(const JsonValue& root) {
        if (root.kind() != JsonKind::object) return;
        for (const JsonValue member : root)
            if (member.key() == "texelscope" && (member.kind() != JsonKind::number || member.number() != 1))
                return read_.wrong(member, "texelscope, the version of the format,", "1");
    }

    void read_root(const JsonValue& root) {
        std::optional<JsonValue> framebuffer, textures, polygons;
        Scene& scene = loaded_.scene;
        const auto later = [&](const JsonValue& member) {
            read_.fail(member.key_line(), fmt::format("'{}' needs a later version of Texelscope", member.key()));
        };
        read_.object(
            root, "a scene", required("texelscope", [](const JsonValue&) {}),
            optional("framebuffer", [&](const JsonValue& value) { framebuffer = value; }),
            optional(
                "depth",
                [&](const JsonValue& v) { scene.depth = static_cast<Depth>(read_.choice(v, "depth", kDepthNames)); }),
            optional("cull",
                     [&](const JsonValue& v) { scene.cull = static_cast<Cull>(read_.choice(v, "cull", kCullNames)); }),
            optional("textures", [&](const JsonValue& value) { textures = value; }),
            optional("polygons", [&](const JsonValue& value) { polygons = value; }), optional("meshes", later),
            optional("camera", later));
        if (framebuffer && !read_.failed()) read_framebuffer(*framebuffer);
        if (textures && !read_.failed()) read_textures(*textures);
        if (polygons && !read_.failed()) read_polygons(*polygons);
    }

    void read_framebuffer(const JsonValue& value) {
        Framebuffer& f = loaded_.scene.framebuffer;
        read_.object(value, "framebuffer",
                     required("width", [&](const JsonValue& v) { f.width = read_.whole(v, "width", 1, kMaxSize); }),
                     required("height", [&](const JsonValue& v) { f.height = read_.whole(v, "height", 1, kMaxSize); }),
                     optional("origin",
                              [&](const JsonValue& v) {
                                  const auto origin = read_.wholes<2>(v, "origin", -kMaxOrigin, kMaxOrigin);
                                  f.origin_x = origin[0], f.origin_y = origin[1];
                              }),
                     optional("clear", [&](const JsonValue& v) {
                         const auto c = read_.wholes<3>(v, "clear", 0, 255);
                         f.clear = {static_cast<std::uint8_t>(c[0]), static_cast<std::uint8_t>(c[1]),
                                    static_cast<std::uint8_t>(c[2])};
                     }));
    }

    void read_textures(const JsonValue& list) {
        if (list.kind() != JsonKind::array) return read_.wrong(list, "textures", "a list");
        for (const JsonValue value : list) {
            const TextureText text = texture_text(value);
            if (!read_.failed()) add_texture(text);
            if (read_.failed()) return;
        }
    }

    TextureText texture_text(const JsonValue& value) {
        TextureText t;
        t.line = value.line();
        read_.object(
            value, "a texture",
            required("name", [&](const JsonValue& v) { t.name = read_.text(v, "name of a texture"); }),
            optional("file",
                     [&](const JsonValue& v) { t.file = read_.text(v, "file of a texture"), t.line = v.line(); }),
            optional("pattern",
                     [&](const JsonValue& v) {
                         t.pattern = static_cast<Pattern>(read_.choice(v, "pattern", kPatternNames));
                     }),
            optional("size", [&](const JsonValue& v) { t.size = read_.wholes<2>(v, "size", 1, kMaxSize); }),
            optional("wrap",
                     [&](const JsonValue& v) { t.wrap = static_cast<Wrap>(read_.choice(v, "wrap", kWrapNames)); }),
            optional("palette", [&](const JsonValue& v) { t.palette = read_.whole(v, "palette", 2, 256); }));
        if (t.name.empty()) read_.fail(value.line(), "name of a texture is empty");
        if (t.file.has_value() == t.pattern.has_value())
            read_.fail(value.line(), "texture " + in_quotes(t.name) + ": expected either 'file' or 'pattern'");
        if (t.pattern.has_value() != t.size.has_value())
            read_.fail(value.line(), "texture " + in_quotes(t.name) +
                                         (t.pattern ? " has no 'size', which a pattern needs"
                                                    : ": 'size' is for patterns; a file has its own"));
        return t;
    }

    void add_texture(const TextureText& text) {
        auto& textures = loaded_.scene.textures;
        const int index = static_cast<int>(textures.size());
        const std::string title = "texture " + in_quotes(text.name);
        if (index >= kMaxTextures)
            return read_.fail(text.line, fmt::format("there are more than {} textures", kMaxTextures));
        if (!texture_index_.emplace(text.name, index).second)
            return read_.fail(text.line, title + " is there twice, expected different names");
        Texture texture;
        texture.name = text.name;
        texture.wrap = text.wrap;
        if (text.file) {
            texture.source.file = *text.file;
            texture.texels = image_of(text);
        } else if (allot(text, static_cast<std::size_t>((*text.size)[0]) * static_cast<std::size_t>((*text.size)[1]))) {
            texture.source.pattern = *text.pattern;
            texture.texels = make_pattern(*text.pattern, (*text.size)[0], (*text.size)[1], address_mark(index));
        }
        if (read_.failed()) return;
        if (text.palette != 0) texture = with_palette(std::move(texture), text.palette);
        const auto is_power_of_two = [](int size) { return (size & (size - 1)) == 0; };
        if (texture.wrap == Wrap::mask && !(is_power_of_two(texture.width()) && is_power_of_two(texture.height())))
            warn(text.line, fmt::format("{} is {} x {}, but wrap 'mask' is for powers of two and will skip texels",
                                        title, texture.width(), texture.height()));
        textures.push_back(std::make_shared<const Texture>(std::move(texture)));
    }

    Image image_of(const TextureText& text) {
        const auto fail = [&](const std::string& what) -> Image {
            read_.fail(text.line, "texture " + in_quotes(text.name) + ": file " + in_quotes(*text.file) + " " + what);
            return {};
        };
        const Result<fs::path> path = resolve(*text.file, files_);
        if (!path) return fail(path.error().what);
        Result<Image> image = load_image(*path);
        if (!image) return fail(image.error().what);
        if (!allot(text, image->size())) return {};
        return *std::move(image);
    }

    /// Whether the scene may have so many texels more.
    bool allot(const TextureText& text, std::size_t texels) {
        if (texels > kMaxSceneTexels - texels_)
            read_.fail(text.line, fmt::format("the textures have more than {} texels together", kMaxSceneTexels));
        else
            texels_ += texels;
        return !read_.failed();
    }

    void read_polygons(const JsonValue& list) {
        if (list.kind() != JsonKind::array) return read_.wrong(list, "polygons", "a list");
        auto& polygons = loaded_.scene.polygons;
        for (const JsonValue value : list) {
            Polygon polygon = read_polygon(value);
            if (read_.failed()) return;
            if (!is_drawable(polygon))
                warn(value.line(),
                     fmt::format("polygon {} draws nothing: {}", polygons.size(), polygon_fault(polygon)));
            else if (!is_convex(polygon.vertices))
                warn(value.line(), fmt::format("polygon {} is not convex, expected a convex one", polygons.size()));
            polygons.push_back(std::move(polygon));
        }
        if (!polygons.empty() && loaded_.scene.textures.empty()) {
            Texture grey;
            grey.name = "grey";
            grey.texels = make_pattern(Pattern::solid, 1, 1, 0);
            loaded_.scene.textures.push_back(std::make_shared<const Texture>(std::move(grey)));
        }
    }

    Polygon read_polygon(const JsonValue& value) {
        Polygon polygon;
        read_.object(value, "a polygon",
                     optional("texture",
                              [&](const JsonValue& v) {
                                  const auto found =
                                      texture_index_.find(std::string(read_.text(v, "texture of a polygon")));
                                  if (found != texture_index_.end())
                                      polygon.texture = found->second;
                                  else
                                      read_.wrong(v, "texture of a polygon", "the name of one of the scene's textures");
                              }),
                     optional("light",
                              [&](const JsonValue& v) {
                                  polygon.light = read_.number(v, "light");
                                  if (polygon.light < 0 && std::isfinite(polygon.light))
                                      read_.wrong(v, "light", "0 or more");
                              }),
                     required("vertices", [&](const JsonValue& v) { read_vertices(v, polygon); }));
        return polygon;
    }

    void read_vertices(const JsonValue& list, Polygon& polygon) {
        const std::size_t count = list.kind() == JsonKind::array ? list.size() : 0;
        if (count < 3) return read_.wrong(list, "vertices", "a list of three or more vertices");
        polygon.vertices.reserve(count);
        for (const JsonValue value : list) {
            Vertex c;
            read_.object(value, "a vertex",  //
                         required("x", [&](const JsonValue& v) { c.x = read_.number(v, "x of a vertex"); }),
                         required("y", [&](const JsonValue& v) { c.y = read_.number(v, "y of a vertex"); }),
                         optional("z", [&](const JsonValue& v) { c.z = read_.number(v, "z of a vertex"); }),
                         optional("w", [&](const JsonValue& v) { c.w = read_.number(v, "w of a vertex"); }),
                         required("u", [&](const JsonValue& v) { c.u = read_.number(v, "u of a vertex"); }),
                         required("v", [&](const JsonValue& v) { c.v = read_.number(v, "v of a vertex"); }));
            if (read_.failed()) return;
            polygon.vertices.push_back(c);
        }
    }

    void warn(int line, const std::string& what) { loaded_.warnings.push_back(read_.place(line) + ": " + what); }

    ValueReader read_;
    const SceneFiles& files_;
    LoadedScene loaded_;
    std::unordered_map<std::string, int> texture_index_;
    std::size_t texels_ = 0;  // of the textures read so far
};

constexpr std::string_view kBlank = " \t\r";

/// Whether the line is an object that also ends on it.
bool is_whole_object(std::string_view line) {
    if (line.empty() || line.front() != '{') return false;
    int depth = 0;
    bool in_text = false;
    for (std::size_t i = 0; i < line.size(); ++i) {
        if (in_text && line[i] == '\\')
            ++i;
        else if (line[i] == '"')
            in_text = !in_text;
        else if (!in_text && (line[i] == '{' || line[i] == '['))
            ++depth;
        else if (!in_text && (line[i] == '}' || line[i] == ']') && --depth == 0)
            return i + 1 == line.size();
    }
    return false;
}

}  // namespace

Result<LoadedScene> parse_scene(std::string_view text, std::string_view name, const SceneFiles& files, int first_line) {
    if (text.size() > kMaxSceneBytes)
        return Error{std::string(name), fmt::format("is longer than {} bytes, the most that is read", kMaxSceneBytes)};
    const Result<JsonTree> tree = JsonTree::parse(text, name, first_line);
    if (!tree) return tree.error();
    return SceneReader(name, files).scene(tree->root());
}

Result<LoadedScene> load_scene(const fs::path& path, const fs::path& assets) {
    const Result<std::string> text = read_file(path, kMaxSceneBytes);
    if (!text) return text.error();
    const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
    return parse_scene(*text, path.string(), {folder, assets});
}

std::vector<SceneLine> parse_scene_lines(std::string_view text) {
    std::vector<SceneLine> lines;
    for (int number = 0; !text.empty(); ++number) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        std::string_view line = text.substr(0, end);
        text.remove_prefix(std::min(end + 1, text.size()));
        while (!line.empty() && kBlank.find(line.front()) != kBlank.npos) line.remove_prefix(1);
        while (!line.empty() && kBlank.find(line.back()) != kBlank.npos) line.remove_suffix(1);
        if (!line.empty()) lines.push_back({number, line});
    }
    return lines;
}

bool is_scene_lines(std::string_view text) {
    const std::vector<SceneLine> lines = parse_scene_lines(text);
    return lines.size() > 1 && is_whole_object(lines[0].text) && lines[1].text.front() == '{';
}

}  // namespace texelscope
