#include "core/scene/triangles_file.h"

#include <array>
#include <bit>
#include <cstring>

#include <fmt/format.h>

#include "core/base/assert.h"
#include "core/geometry/polygon.h"
#include "core/image/image.h"

namespace texelscope {
namespace {

static_assert(std::endian::native == std::endian::little);

struct Header {
    std::array<char, 8> magic{'T', 'R', 'I', 'W', 'L', '0', '1', '\0'};
    std::uint32_t width = 0, height = 0, triangles = 0, flags = 0, texture_width = 0, texture_height = 0;
    std::uint32_t vertex_bytes = sizeof(Vertex), zero = 0;
    std::uint64_t seed = 0, covered = 0, last = 0;
};
static_assert(sizeof(Header) == 64 && sizeof(Vertex) == 24);
static_assert(offsetof(Vertex, z) == 8 && offsetof(Vertex, w) == 12 && offsetof(Vertex, u) == 16);

constexpr std::uint32_t kPerspective = 1, kDepth = 2, kCullBack = 4, kNoWrap = 8, kAllFlags = 15;

[[nodiscard]] std::string fault(const Header& h, std::size_t bytes) {
    const auto size = [](std::uint32_t n) { return n >= 1 && n <= static_cast<std::uint32_t>(kMaxSize); };
    if (h.magic != Header{}.magic) return "it does not begin with TRIWL01, expected triangles for measuring";
    if (!size(h.width) || !size(h.height))
        return fmt::format("the framebuffer is {} x {}, expected 1 to {}", h.width, h.height, kMaxSize);
    if (!size(h.texture_width) || !size(h.texture_height))
        return fmt::format("the texture is {} x {}, expected 1 to {}", h.texture_width, h.texture_height, kMaxSize);
    if ((h.flags & ~kAllFlags) != 0) return fmt::format("flags are {}, expected at most {}", h.flags, kAllFlags);
    if (h.vertex_bytes != sizeof(Vertex))
        return fmt::format("a vertex has {} bytes, expected {}", h.vertex_bytes, sizeof(Vertex));
    if (h.zero != 0 || h.last != 0) return "a number that is kept for later is not 0";
    if (h.triangles > kMaxFileTriangles)
        return fmt::format("there are {} triangles, expected at most {}", h.triangles, kMaxFileTriangles);
    const std::size_t expected = sizeof(Header) + std::size_t{h.triangles} * 3 * sizeof(Vertex);
    if (bytes != expected)
        return fmt::format("it has {} bytes, expected {} for {} triangles", bytes, expected, h.triangles);
    return {};
}

}  // namespace

Result<TrianglesFile> parse_triangles(std::string_view bytes, const std::string& name) {
    if (bytes.size() < sizeof(Header))
        return Error{name, fmt::format("it has {} bytes, expected a header of {}", bytes.size(), sizeof(Header))};
    Header h;
    std::memcpy(&h, bytes.data(), sizeof h);
    if (std::string what = fault(h, bytes.size()); !what.empty()) return Error{name, std::move(what)};
    TrianglesFile file{.width = static_cast<int>(h.width),
                       .height = static_cast<int>(h.height),
                       .perspective = (h.flags & kPerspective) != 0,
                       .depth = (h.flags & kDepth) != 0,
                       .cull_back = (h.flags & kCullBack) != 0,
                       .no_wrap = (h.flags & kNoWrap) != 0,
                       .texture_width = static_cast<int>(h.texture_width),
                       .texture_height = static_cast<int>(h.texture_height),
                       .seed = h.seed,
                       .covered = h.covered,
                       .vertices = std::vector<Vertex>(std::size_t{h.triangles} * 3)};
    if (!file.vertices.empty())
        std::memcpy(file.vertices.data(), bytes.data() + sizeof h, file.vertices.size() * sizeof(Vertex));
    for (std::size_t n = 0; n < file.vertices.size(); ++n) {
        const Vertex& vertex = file.vertices[n];
        if (!is_finite(vertex))
            return Error{name, fmt::format("corner {} of triangle {} has a number that is not finite", n % 3, n / 3)};
        if (file.perspective && !(vertex.w > 0))
            return Error{
                name, fmt::format("corner {} of triangle {} has w = {}, expected more than 0", n % 3, n / 3, vertex.w)};
    }
    return file;
}

std::string print_triangles(const TrianglesFile& file) {
    Header h;
    h.width = static_cast<std::uint32_t>(file.width), h.height = static_cast<std::uint32_t>(file.height);
    h.triangles = static_cast<std::uint32_t>(file.vertices.size() / 3);
    h.flags = (file.perspective ? kPerspective : 0) | (file.depth ? kDepth : 0) | (file.cull_back ? kCullBack : 0) |
              (file.no_wrap ? kNoWrap : 0);
    h.texture_width = static_cast<std::uint32_t>(file.texture_width);
    h.texture_height = static_cast<std::uint32_t>(file.texture_height);
    h.seed = file.seed, h.covered = file.covered;
    std::string bytes(sizeof h + file.vertices.size() * sizeof(Vertex), '\0');
    TEXELSCOPE_ASSERT(file.vertices.size() % 3 == 0 && fault(h, bytes.size()).empty());
    std::memcpy(bytes.data(), &h, sizeof h);
    if (!file.vertices.empty())
        std::memcpy(bytes.data() + sizeof h, file.vertices.data(), file.vertices.size() * sizeof(Vertex));
    return bytes;
}

}  // namespace texelscope
