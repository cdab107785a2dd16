#include "core/fast/decide.h"

#include <algorithm>
#include <cmath>

#include "core/base/assert.h"

namespace texelscope {
namespace {

__extension__ using Wide = __int128;
constexpr int kBits = 29;  ///< a coordinate of 2^-6 or more is a multiple of 2^-29

[[nodiscard]] std::int64_t in_units(float coordinate) {
    return static_cast<std::int64_t>(std::ldexp(static_cast<double>(coordinate), kBits));
}

}  // namespace

int first_pixel(const Vertex& a, const Vertex& b, int row) {
    const Vertex &top = a.y < b.y ? a : b, &bottom = a.y < b.y ? b : a;
    const Wide dx = in_units(bottom.x) - in_units(top.x), dy = in_units(bottom.y) - in_units(top.y);
    TEXELSCOPE_ASSERT(dy > 0);
    constexpr std::int64_t kHalf = std::int64_t{1} << (kBits - 1);
    const std::int64_t y = (std::int64_t{row} << kBits) + kHalf;
    // x - 1/2 = above / below; a shift by a whole pixel more than any negative x makes it positive.
    const Wide above = Wide(in_units(top.x) - kHalf) * dy + dx * (y - in_units(top.y)), below = dy << kBits;
    const Wide whole = above / below;
    return static_cast<int>(whole + (above > whole * below ? 1 : 0));
}

TexelDecider::TexelDecider(std::span<const Vertex, 3> corners, const RasterJob& job, const RasterTexture& texture,
                           RasterCounters& counters)
    : job_(&job), texture_(&texture), counters_(&counters) {
    std::copy(corners.begin(), corners.end(), corners_.begin());
    if (!job.perspective)
        for (Vertex& corner : corners_) corner.w = 1;
}

std::uint32_t TexelDecider::at(int x, int y) {
    ++counters_->in_double;
    ++counters_->in_whole;
    if (!exact_) exact_.emplace(corners_, job_->u_texels, job_->v_texels);
    const TexelIndex texel = exact_->texel(x, y);
    return static_cast<std::uint32_t>(wrap_index(texel.v, texture_->height, Wrap::repeat) * texture_->width +
                                      wrap_index(texel.u, texture_->width, Wrap::repeat));
}

}  // namespace texelscope
