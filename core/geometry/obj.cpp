#include "core/geometry/obj.h"

#define TINYOBJLOADER_IMPLEMENTATION
#define TINYOBJLOADER_USE_DOUBLE
#include <fmt/format.h>
#include <tiny_obj_loader.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <optional>
#include <span>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "core/geometry/solids.h"

namespace texelscope {
namespace {

constexpr std::size_t kMaxNumberLength = 64;
constexpr std::size_t kMaxIndexDigits = 9;

std::size_t digits_of(std::string_view& text) {
    std::size_t count = 0;
    while (!text.empty() && text.front() >= '0' && text.front() <= '9') text.remove_prefix(1), ++count;
    return count;
}

bool skip_any(std::string_view& text, std::string_view characters) {
    if (text.empty() || characters.find(text.front()) == characters.npos) return false;
    text.remove_prefix(1);
    return true;
}

/// A decimal number that the loader reads as what it says; others it would take for 0.
bool is_number(std::string_view text) {
    if (text.size() > kMaxNumberLength) return false;
    skip_any(text, "+-");
    std::size_t digits = digits_of(text);
    if (skip_any(text, ".")) digits += digits_of(text);
    if (digits == 0) return false;
    if (!skip_any(text, "eE")) return text.empty();
    skip_any(text, "+-");
    const std::size_t exponent = digits_of(text);
    return exponent >= 1 && exponent <= 4 && text.empty();
}

/// "1", "1/2", "1//3" or "1/2/3"; each may be negative.
bool is_corner(std::string_view text) {
    for (int part = 0; part < 3; ++part) {
        const bool minus = skip_any(text, "-");
        const std::size_t digits = digits_of(text);
        if (digits > kMaxIndexDigits || (digits == 0 && (part != 1 || minus))) return false;
        if (text.empty()) return digits != 0;
        if (!skip_any(text, "/")) return false;
    }
    return false;
}

/// The words of a line; views into it.
std::vector<std::string_view> words_of(std::string_view line) {
    std::vector<std::string_view> words;
    while (true) {
        const std::size_t first = line.find_first_not_of(" \t");
        if (first == line.npos) return words;
        line.remove_prefix(first);
        const std::size_t length = std::min(line.find_first_of(" \t"), line.size());
        words.push_back(line.substr(0, length));
        line.remove_prefix(length);
    }
}

/// The text's lines, so that what the loader would misread without a word is found, and a face has a line.
class Lines {
public:
    explicit Lines(std::string_view name) : name_(name) {}

    [[nodiscard]] std::optional<Error> check(std::string_view text) {
        while (!text.empty() && !error_) {
            const std::size_t length = std::min(text.find_first_of("\r\n"), text.size());
            ++line_;
            check_line(text.substr(0, length));
            const bool two = text.substr(length, 2) == "\r\n";
            text.remove_prefix(std::min(length + (two ? 2 : 1), text.size()));
        }
        return error_;
    }
    [[nodiscard]] Error face_error(std::size_t face, const std::string& what) const {
        return {fmt::format("{}:{}", name_, face_lines_[face]), what};
    }

private:
    struct Statement {
        std::string_view word;
        std::size_t fewest, most;
        int limit;
        std::string_view many;
    };
    static constexpr std::array<Statement, 4> kStatements{{{"v", 3, 7, kMaxMeshVertices, "vertices"},
                                                           {"vt", 1, 3, kMaxMeshCorners, "texture corners"},
                                                           {"vn", 3, 3, kMaxMeshCorners, "normals"},
                                                           {"f", 3, kMaxMeshCorners, kMaxMeshFaces, "faces"}}};

    void check_line(std::string_view line) {
        const std::vector<std::string_view> words = words_of(line);
        if (words.empty()) return;
        if (line.find('\0') != line.npos) return fail("has a character of no text");
        for (std::size_t n = 0; n < kStatements.size(); ++n)
            if (kStatements[n].word == words[0]) check_statement(n, std::span(words).subspan(1));
    }

    void check_statement(std::size_t n, std::span<const std::string_view> values) {
        const Statement& statement = kStatements[n];
        const bool is_face = statement.word == "f";
        if (++counts_[n] > statement.limit)
            return fail(fmt::format("there are more than {} {}", statement.limit, statement.many));
        if (values.size() < statement.fewest)
            return fail(fmt::format("'{}' has {} values, expected {} or more", statement.word, values.size(),
                                    statement.fewest));
        if (values.size() > statement.most)
            return fail(
                fmt::format("'{}' has {} values, expected at most {}", statement.word, values.size(), statement.most));
        for (const std::string_view value : values)
            if (!(is_face ? is_corner(value) : is_number(value)))
                return fail(fmt::format("'{}' has a value that is not {}", statement.word,
                                        is_face ? "an index such as 1, 1/2, 1//3 or 1/2/3" : "a finite number"));
        if (!is_face) return;
        corners_ += values.size();
        if (corners_ > static_cast<std::size_t>(kMaxMeshCorners))
            return fail(fmt::format("the faces have more than {} corners", kMaxMeshCorners));
        face_lines_.push_back(line_);
    }

    void fail(const std::string& what) { error_ = Error{fmt::format("{}:{}", name_, line_), what}; }

    std::string name_;
    int line_ = 0;
    std::array<int, kStatements.size()> counts_{};
    std::size_t corners_ = 0;
    std::vector<int> face_lines_;
    std::optional<Error> error_;
};

/// What the loader hands over, in the axes of the file; indices from 0, -1 where there is none.
struct Loaded {
    struct Corner {
        std::int64_t vertex = -1, uv = -1;
    };
    std::vector<glm::dvec3> vertices;
    std::vector<glm::dvec2> uvs;
    std::vector<std::vector<Corner>> faces;
};

/// An index of the file: from 1, or from the latest backwards; -1 for 0 and for what comes before the first.
std::int64_t resolved(int index, std::size_t count) {
    const std::int64_t at = index > 0 ? std::int64_t{index} - 1 : static_cast<std::int64_t>(count) + index;
    return index == 0 ? -1 : std::max<std::int64_t>(at, -1);
}

Loaded load(std::string_view text) {
    tinyobj::callback_t calls;
    calls.vertex_cb = [](void* data, double x, double y, double z, double) {
        static_cast<Loaded*>(data)->vertices.emplace_back(x, y, z);
    };
    calls.texcoord_cb = [](void* data, double u, double v, double) {
        static_cast<Loaded*>(data)->uvs.emplace_back(u, v);
    };
    calls.index_cb = [](void* data, tinyobj::index_t* indices, int count) {
        auto& loaded = *static_cast<Loaded*>(data);
        std::vector<Loaded::Corner> face;
        for (const tinyobj::index_t& index : std::span(indices, static_cast<std::size_t>(count))) {
            const bool has_uv = index.texcoord_index != 0;
            face.push_back({resolved(index.vertex_index, loaded.vertices.size()),
                            has_uv ? resolved(index.texcoord_index, loaded.uvs.size()) : -1});
            if (has_uv && face.back().uv < 0) face.back().uv = INT64_MAX;  // before the first: refers to nothing
        }
        loaded.faces.push_back(std::move(face));
    };
    Loaded loaded;
    std::istringstream stream{std::string(text)};
    tinyobj::LoadObjWithCallback(stream, calls, &loaded, nullptr, nullptr, nullptr);
    return loaded;
}

/// Why the face cannot be drawn, or an empty text.
std::string fault(const Mesh& mesh, const MeshFace& face) {
    const auto at = [&](std::size_t i) {
        return mesh.vertices[static_cast<std::size_t>(face[i % face.size()].vertex)];
    };
    const glm::dvec3 area = area_vector(mesh.vertices, face);
    double longest = 0;
    for (std::size_t i = 0; i < face.size(); ++i) {
        const double length = glm::length(at(i + 1) - at(i));
        if (length == 0) return "two corners of the face that follow each other are at one place";
        longest = std::max(longest, length);
    }
    constexpr double kThinnest = 1e-12;  // area over the square of the longest side
    if (!(glm::length(area) > kThinnest * longest * longest)) return "the face has no area";
    const glm::dvec3 normal = glm::normalize(area);
    const auto side = [&](std::size_t i) {
        const glm::dvec3 d = at(i + 1) - at(i);
        return d - normal * glm::dot(normal, d);
    };
    constexpr double kStraight = 1e-6;  // [radians]
    double round = 0;
    for (std::size_t i = 0; i < face.size(); ++i) {
        const glm::dvec3 a = side(i), b = side(i + 1);
        const double turn = std::atan2(glm::dot(glm::cross(a, b), normal), glm::dot(a, b));
        if (!(turn >= -kStraight)) return "the face is not convex";
        round += turn;
    }
    return round > 1.5 * glm::two_pi<double>() ? "the face is not convex" : "";
}

}  // namespace

Result<Mesh> parse_obj(std::string_view text, std::string_view name) {
    if (text.size() > kMaxObjBytes)
        return Error{std::string(name), fmt::format("is longer than {} bytes, the most that is read", kMaxObjBytes)};
    Lines lines(name);
    if (const std::optional<Error> error = lines.check(text)) return *error;
    const Loaded loaded = load(text);
    if (loaded.faces.empty()) return Error{std::string(name), "has no face, expected lines such as 'f 1 2 3'"};
    Mesh mesh;
    for (std::size_t i = 0; i < loaded.vertices.size(); ++i) {
        const glm::dvec3& vertex = loaded.vertices[i];
        for (int axis = 0; axis < 3; ++axis)
            if (!(std::fabs(vertex[axis]) <= kMaxCoordinate))
                return Error{std::string(name),
                             fmt::format("vertex {} is beyond {:g}, the largest coordinate", i + 1, kMaxCoordinate)};
        mesh.vertices.emplace_back(vertex.x, vertex.y, -vertex.z);
    }
    for (std::size_t n = 0; n < loaded.faces.size(); ++n) {
        const auto& ring = loaded.faces[n];
        MeshFace face;
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Loaded::Corner& corner = ring[i];
            if (corner.vertex < 0 || corner.vertex >= static_cast<std::int64_t>(loaded.vertices.size()))
                return lines.face_error(n, fmt::format("corner {} of the face refers to no vertex", i + 1));
            if (corner.uv >= static_cast<std::int64_t>(loaded.uvs.size()))
                return lines.face_error(n, fmt::format("corner {} of the face refers to no texture corner", i + 1));
            glm::dvec2 uv = polygon_uv(static_cast<int>(i), static_cast<int>(ring.size()));
            if (corner.uv >= 0)
                uv = {loaded.uvs[static_cast<std::size_t>(corner.uv)].x,
                      1 - loaded.uvs[static_cast<std::size_t>(corner.uv)].y};
            if (!(std::fabs(uv.x) <= kMaxCoordinate && std::fabs(uv.y) <= kMaxCoordinate))
                return lines.face_error(
                    n, fmt::format("corner {} of the face is beyond {:g} textures", i + 1, kMaxCoordinate));
            face.push_back({static_cast<int>(corner.vertex), uv});
        }
        std::reverse(face.begin(), face.end());  // z was turned round, so the ring must be, too
        const std::string why = fault(mesh, face);
        if (!why.empty()) return lines.face_error(n, why);
        mesh.faces.push_back(std::move(face));
    }
    return mesh;
}

}  // namespace texelscope
