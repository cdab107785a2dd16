#include "core/fast/raster_texels.h"

#include <algorithm>

#include "core/image/packed.h"

namespace texelscope {
namespace {

constexpr int kGap = 16;  ///< behind each row [texels]
static_assert(kGap >= kTexelApron);

}  // namespace

/// @param texel  (u, v) to its colour, within the texture
template <class Texel>
void RasterTexels::fill(Texel&& texel) {
    const int width = texture_.width, height = texture_.height;
    texture_.pitch = width + kGap, texture_.apron = kTexelApron;
    const auto pitch = static_cast<std::size_t>(texture_.pitch);
    texels_.resize(pitch * static_cast<std::size_t>(height + kTexelApron));
    const auto index = [&](int i, int size) { return texture_.wrap == Wrap::clamp ? std::min(i, size - 1) : i % size; };
    for (int v = 0; v < height; ++v) {
        std::uint32_t* const row = &texels_[static_cast<std::size_t>(v) * pitch];
        for (int u = 0; u < width; ++u) row[u] = texel(u, v);
        for (int u = width; u < width + kGap; ++u) row[u] = row[index(u, width)];
    }
    for (int v = height; v < height + kTexelApron; ++v)
        std::copy_n(&texels_[static_cast<std::size_t>(index(v, height)) * pitch], pitch,
                    &texels_[static_cast<std::size_t>(v) * pitch]);
}

RasterTexels::RasterTexels(const RasterTexture& texture, const ChannelTable* light) : texture_(texture) {
    const std::ptrdiff_t pitch = texture.pitch == 0 ? texture.width : texture.pitch;
    fill([&](int u, int v) {
        const std::uint32_t t = texture.texels[v * pitch + u];
        if (light == nullptr) return t;
        const ChannelTable& lit = *light;
        return lit[t & 255] | lit[t >> 8 & 255] << 8 | lit[t >> 16 & 255] << 16 | (t & 0xFF000000U);
    });
    texture_.texels = nullptr;
}

RasterTexels::RasterTexels(const Image& texels, Wrap wrap)
    : texture_{.width = texels.width(), .height = texels.height(), .wrap = wrap} {
    fill([&](int u, int v) { return packed(texels.at(u, v)); });
}

}  // namespace texelscope
