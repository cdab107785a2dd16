// A texture's texels as the fast rasterizer reads them best: what a graphics card would call uploading a texture.
#pragma once

#include <cstdint>
#include <vector>

#include "core/fast/raster.h"
#include "core/image/image.h"

namespace texelscope {

/// Texels with an apron (RasterTexture::apron), and rows that are no power of two apart.
class RasterTexels {
public:
    RasterTexels() = default;
    /// @param light  changes their colours as RasterJob::light says; null: they stay.
    explicit RasterTexels(const RasterTexture& texture, const ChannelTable* light = nullptr);
    /// @param wrap  mask: both sizes are powers of two
    RasterTexels(const Image& texels, Wrap wrap);

    [[nodiscard]] RasterTexture texture() const {
        RasterTexture texture = texture_;
        texture.texels = texels_.data();
        return texture;
    }

private:
    template <class Texel>
    void fill(Texel&& texel);

    RasterTexture texture_;  ///< without its texels
    std::vector<std::uint32_t> texels_;
};

}  // namespace texelscope
