// Image files in and out.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/image/image.h"

namespace texelscope {

inline constexpr std::size_t kMaxImageBytes = std::size_t{256} << 20;  ///< the longest image file that is read
inline constexpr std::size_t kMaxImageTexels = std::size_t{1} << 26;   ///< the most texels of an image file

/// Decodes what stb_image reads (PNG, JPEG, BMP, TGA, GIF, PSD, HDR, PIC, PNM) to 8 bits a channel; alpha is dropped.
/// Fails before it allocates for the picture if a side exceeds kMaxSize, or the file is too short to be of its size.
/// @param name  the `where` of the error.
Result<Image> decode_image(std::span<const std::uint8_t> bytes, std::string_view name);

/// The image in a regular file.
Result<Image> load_image(const std::filesystem::path& path);

/// A PNG of 8 bits a channel. Fails for an empty image.
Result<std::vector<std::uint8_t>> encode_png(const Image& image);

}  // namespace texelscope
