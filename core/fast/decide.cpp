#include "core/fast/decide.h"

#include <algorithm>
#include <cmath>

#include "core/base/assert.h"
#include "core/fast/watch.h"
#include "core/number/float_bits.h"

namespace texelscope {
namespace {

__extension__ using Wide = __int128;

}  // namespace

int first_pixel(const Vertex& a, const Vertex& b, int row) {
    const Vertex &top = a.y < b.y ? a : b, &bottom = a.y < b.y ? b : a;
    int bits = 1;  // half a pixel is a whole number of units of 2^-bits
    for (const float c : {a.x, a.y, b.x, b.y})
        if (c != 0) bits = std::max(bits, -lowest_exponent(c));
    const auto in_units = [bits](float c) {
        return static_cast<std::int64_t>(std::ldexp(static_cast<double>(c), bits));
    };
    const Wide dx = in_units(bottom.x) - in_units(top.x), dy = in_units(bottom.y) - in_units(top.y);
    TEXELSCOPE_ASSERT(dy > 0);
    const std::int64_t half = std::int64_t{1} << (bits - 1), y = std::int64_t{row} * 2 * half + half;
    // x - 1/2 = above / below, rounded up.
    const Wide above = Wide(in_units(top.x) - half) * dy + dx * (y - in_units(top.y)), below = dy << bits;
    const Wide whole = above / below;
    return static_cast<int>(whole + (above > whole * below ? 1 : 0));
}

std::uint32_t place_of(const RasterTexture& texture, const TexelIndex& texel) {
    return static_cast<std::uint32_t>(wrap_index(texel.v, texture.height, texture.wrap)) *
               static_cast<std::uint32_t>(texture.pitch) +
           static_cast<std::uint32_t>(wrap_index(texel.u, texture.width, texture.wrap));
}

std::array<Vertex, 3> Decider::corners() const {
    const Vertex* const p = canvas_->corners(triangle_);
    std::array<Vertex, 3> corners{p[0], p[1], p[2]};
    if (!canvas_->job->perspective)
        for (Vertex& corner : corners) corner.w = 1;
    return corners;
}

const ExactTriangle& Decider::exact() {
    if (!exact_) exact_.emplace(corners(), canvas_->job->u_texels, canvas_->job->v_texels);
    return *exact_;
}

const std::optional<WideTriangle>& Decider::wide() {
    const RasterJob& job = *canvas_->job;
    if (!looked_)
        wide_ = WideTriangle::make(corners(), job.u_texels, job.v_texels, canvas_->target.x0, canvas_->target.y0);
    looked_ = true;
    return wide_;
}

WideTriangle::Gaps Decider::gaps() { return wide() ? wide_->gaps() : WideTriangle::Gaps{}; }

std::uint32_t Decider::texel(int x, int y) {
    ++canvas_->counters->in_whole;
    watch(*canvas_, x, y, wide() ? DecidedBy::wide : DecidedBy::exact);
    const TexelIndex texel =
        wide() ? wide_->texel(x, y) : exact().texel(x + canvas_->target.x0, y + canvas_->target.y0);
    return place_of(canvas_->texture, texel);
}

float Decider::depth(int x, int y) {
    ++canvas_->counters->in_whole;
    return exact().depth(x + canvas_->target.x0, y + canvas_->target.y0);
}

}  // namespace texelscope
