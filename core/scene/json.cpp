#include "core/scene/json.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <unordered_map>
#include <utility>

#include "core/base/file.h"
#include "core/geometry/polygon.h"
#include "core/image/frames.h"
#include "core/image/load.h"
#include "core/image/palette.h"
#include "core/scene/jelly_quirk.h"
#include "core/scene/mesh_reader.h"
#include "core/scene/names.h"
#include "core/scene/place.h"
#include "core/scene/scene_reader.h"

namespace texelscope {
namespace {

namespace fs = std::filesystem;

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
        std::vector<std::string> files;
        int frames = 0;
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
        std::optional<JsonValue> framebuffer, textures, polygons, meshes, quirks, camera, random;
        Scene& scene = loaded_.scene;
        read_.object(
            root, "a scene", required("texelscope", [](const JsonValue&) {}),
            optional("framebuffer", [&](const JsonValue& value) { framebuffer = value; }),
            optional(
                "depth",
                [&](const JsonValue& v) { scene.depth = static_cast<Depth>(read_.choice(v, "depth", kDepthNames)); }),
            optional("cull",
                     [&](const JsonValue& v) { scene.cull = static_cast<Cull>(read_.choice(v, "cull", kCullNames)); }),
            optional("textures", [&](const JsonValue& value) { textures = value; }),
            optional("polygons", [&](const JsonValue& value) { polygons = value; }),
            optional("meshes", [&](const JsonValue& value) { meshes = value; }),
            optional("quirks", [&](const JsonValue& value) { quirks = value; }),
            optional("camera", [&](const JsonValue& value) { camera = value; }),
            optional("random", [&](const JsonValue& value) { random = value; }));
        if (framebuffer && !read_.failed()) read_framebuffer(*framebuffer);
        if (textures && !read_.failed()) read_textures(*textures);
        if (polygons && !read_.failed()) read_polygons(*polygons);
        MeshReader mesh_reader(read_, files_,
                               [this](const JsonValue& v, std::string_view what) { return find_texture(v, what); });
        if (camera && !read_.failed()) scene.camera = mesh_reader.camera(*camera);
        if (meshes && !read_.failed()) scene.meshes = mesh_reader.meshes(*meshes);
        if (quirks && !read_.failed()) read_quirks(*quirks);
        if (random && !read_.failed()) scene.random = read_random(*random);
        if (read_.failed()) return;
        if (scene.textures.empty() && !(scene.polygons.empty() && scene.meshes.empty() && !scene.random)) add_grey();
        place_meshes(scene);
        place_random(scene);
    }

    /// Those of geometry; the methods' own are no part of a scene.
    void read_quirks(const JsonValue& list) {
        if (list.kind() != JsonKind::array) return read_.wrong(list, "quirks", "a list");
        constexpr std::array kFields{kJellyQuirk.field};
        for (const JsonValue value : list) {
            static_cast<void>(read_.choice(value, "a quirk of a scene", kFields));
            if (read_.failed()) return;
            loaded_.scene.size_twice = true;
        }
    }

    RandomTriangles read_random(const JsonValue& value) {
        RandomTriangles r;
        read_.object(
            value, "random",
            required("triangles",
                     [&](const JsonValue& v) { r.count = read_.whole(v, "triangles", 1, kMaxRandomTriangles); }),
            optional("size",
                     [&](const JsonValue& v) {
                         r.size = read_.number(v, "size");
                         if (!(r.size > 0) || r.size > kMaxSize)
                             read_.wrong(v, "size", fmt::format("a number above 0, at most {}", kMaxSize));
                     }),
            optional("seed",
                     [&](const JsonValue& v) {
                         r.seed =
                             static_cast<std::uint32_t>(read_.whole(v, "seed", 0, std::numeric_limits<int>::max()));
                     }),
            optional(
                "kind",
                [&](const JsonValue& v) { r.kind = static_cast<RandomKind>(read_.choice(v, "kind", kRandomKinds)); }),
            optional("waste", [&](const JsonValue& v) { r.waste = read_.whole(v, "waste", 0, kMaxWaste); }));
        return r;
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
            optional("files", [&](const JsonValue& v) { t.files = file_list(v), t.line = v.line(); }),
            optional("frames", [&](const JsonValue& v) { t.frames = read_.whole(v, "frames", 1, kMaxFrames); }),
            optional("pattern",
                     [&](const JsonValue& v) {
                         t.pattern = static_cast<Pattern>(read_.choice(v, "pattern", kPatternNames));
                     }),
            optional("size", [&](const JsonValue& v) { t.size = read_.wholes<2>(v, "size", 1, kMaxSize); }),
            optional("wrap",
                     [&](const JsonValue& v) { t.wrap = static_cast<Wrap>(read_.choice(v, "wrap", kWrapNames)); }),
            optional("palette", [&](const JsonValue& v) { t.palette = read_.whole(v, "palette", 2, 256); }));
        if (t.name.empty()) read_.fail(value.line(), "name of a texture is empty");
        if (int{t.file.has_value()} + int{t.pattern.has_value()} + int{!t.files.empty()} != 1)
            read_.fail(value.line(), "texture " + in_quotes(t.name) + ": expected either 'file', 'files' or 'pattern'");
        if (t.frames != 0 && !t.file)
            read_.fail(value.line(), "texture " + in_quotes(t.name) + ": 'frames' is for a 'file'");
        if (t.pattern.has_value() != t.size.has_value())
            read_.fail(value.line(), "texture " + in_quotes(t.name) +
                                         (t.pattern ? " has no 'size', which a pattern needs"
                                                    : ": 'size' is for patterns; a file has its own"));
        return t;
    }

    std::vector<std::string> file_list(const JsonValue& list) {
        std::vector<std::string> files;
        const std::size_t count = list.kind() == JsonKind::array ? list.size() : 0;
        if (count < 1 || count > static_cast<std::size_t>(kMaxFrames)) {
            read_.wrong(list, "files of a texture", fmt::format("a list of 1 to {} names", kMaxFrames));
            return files;
        }
        for (const JsonValue file : list) files.emplace_back(read_.text(file, "file of a texture"));
        return files;
    }

    void add_texture(const TextureText& text) {
        auto& textures = loaded_.scene.textures;
        const int index = static_cast<int>(textures.size());
        const std::string title = "texture " + in_quotes(text.name);
        if (index >= kMaxTextures)
            return read_.fail(text.line, fmt::format("there are more than {} textures", kMaxTextures));
        if (!texture_index_.emplace(text.name, index).second)
            return read_.fail(text.line, title + " is there twice, expected different names");
        Texture like;  // all but the texels
        like.name = text.name;
        like.wrap = text.wrap;
        like.source = {text.file.value_or(""), text.frames, text.pattern.value_or(Pattern::solid), 0};
        std::vector<std::shared_ptr<const Texture>> frames;
        for (Image& image : images_of(text, index)) {
            Texture texture = like;
            texture.texels = std::move(image);
            if (!text.files.empty()) texture.source.file = text.files[frames.size()];
            if (text.palette != 0) texture = with_palette(std::move(texture), text.palette);
            frames.push_back(std::make_shared<const Texture>(std::move(texture)));
        }
        if (read_.failed()) return;
        const Texture& first = *frames[0];
        const auto is_power_of_two = [](int size) { return (size & (size - 1)) == 0; };
        if (first.wrap == Wrap::mask && !(is_power_of_two(first.width()) && is_power_of_two(first.height())))
            warn(text.line, fmt::format("{} is {} x {}, but wrap 'mask' is for powers of two and will skip texels",
                                        title, first.width(), first.height()));
        textures.push_back(frames[0]);
        if (!text.pattern && !(text.file && text.frames == 0))
            loaded_.scene.animations.push_back({index, std::move(frames)});
    }

    /// The texture's image; of one that moves, all its frames. None after an error.
    std::vector<Image> images_of(const TextureText& text, int index) {
        std::vector<Image> images;
        if (text.pattern) {
            const auto [width, height] = *text.size;
            if (allot(text, static_cast<std::size_t>(width) * static_cast<std::size_t>(height)))
                images.push_back(make_pattern(*text.pattern, width, height, address_mark(index)));
            return images;
        }
        if (text.files.empty()) {
            Image image = image_of(text, *text.file);
            if (read_.failed()) return images;
            if (text.frames == 0) {
                images.push_back(std::move(image));
                return images;
            }
            Result<std::vector<Image>> frames = cut_frames(image, text.frames);
            if (frames) return *std::move(frames);
            fail_file(text, *text.file, frames.error().what);
        }
        for (const std::string& file : text.files) {
            Image image = image_of(text, file);
            if (read_.failed()) break;
            images.push_back(std::move(image));
            if (images.back().width() != images[0].width() || images.back().height() != images[0].height())
                fail_file(text, file,
                          fmt::format("is {} x {}, expected {} x {} as of the first", images.back().width(),
                                      images.back().height(), images[0].width(), images[0].height()));
        }
        return images;
    }

    void fail_file(const TextureText& text, const std::string& file, const std::string& what) {
        read_.fail(text.line, "texture " + in_quotes(text.name) + ": file " + in_quotes(file) + " " + what);
    }

    Image image_of(const TextureText& text, const std::string& file) {
        const auto fail = [&](const std::string& what) -> Image {
            fail_file(text, file, what);
            return {};
        };
        const Result<fs::path> path = resolve_scene_file(file, files_);
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
    }

    void add_grey() {
        Texture grey;
        grey.name = "grey";
        grey.texels = make_pattern(Pattern::solid, 1, 1, 0);
        loaded_.scene.textures.push_back(std::make_shared<const Texture>(std::move(grey)));
    }

    int find_texture(const JsonValue& name, std::string_view what) {
        const auto found = texture_index_.find(std::string(read_.text(name, what)));
        if (found != texture_index_.end()) return found->second;
        read_.wrong(name, what, "the name of one of the scene's textures");
        return 0;
    }

    Polygon read_polygon(const JsonValue& value) {
        Polygon polygon;
        read_.object(
            value, "a polygon",
            optional("texture", [&](const JsonValue& v) { polygon.texture = find_texture(v, "texture of a polygon"); }),
            optional("blend", [&](const JsonValue& v) { polygon.half = read_.choice(v, "blend", kBlendNames) == 1; }),
            optional("light",
                     [&](const JsonValue& v) {
                         polygon.light = read_.number(v, "light");
                         if (polygon.light < 0 && std::isfinite(polygon.light)) read_.wrong(v, "light", "0 or more");
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
