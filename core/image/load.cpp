#include "core/image/load.h"

#include <stb/stb_image.h>
#include <stb/stb_image_write.h>

#include <array>
#include <climits>
#include <cstring>
#include <memory>
#include <string>
#include <system_error>

#include "core/base/file.h"

namespace texelscope {
namespace {

// No format packs more into a byte: a PNG of one bit a texel, deflated at best, comes to 8256.
constexpr std::size_t kMostTexelsPerByte = 16384;

// Deflate yields at most 1032 bytes from one.
constexpr std::size_t kMostInflated = 1032;

struct StbFree {
    void operator()(void* memory) const { stbi_image_free(memory); }
};

std::string size_text(int width, int height) { return std::to_string(width) + " x " + std::to_string(height); }

std::uint32_t big_endian(std::span<const std::uint8_t> bytes) {
    return std::uint32_t{bytes[0]} << 24 | std::uint32_t{bytes[1]} << 16 | std::uint32_t{bytes[2]} << 8 | bytes[3];
}

/// The compressed pixels of a PNG; nothing for another format.
std::vector<std::uint8_t> png_data(std::span<const std::uint8_t> file) {
    constexpr std::array<std::uint8_t, 8> kSignature{0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
    std::vector<std::uint8_t> data;
    if (file.size() < kSignature.size() || std::memcmp(file.data(), kSignature.data(), kSignature.size()) != 0)
        return data;
    file = file.subspan(kSignature.size());
    constexpr std::size_t kAround = 12;  // length and type before a chunk's data, checksum after it
    while (file.size() >= kAround) {
        const std::size_t length = big_endian(file);
        if (length > file.size() - kAround) break;
        if (std::memcmp(&file[4], "IDAT", 4) == 0) {
            const std::span<const std::uint8_t> chunk = file.subspan(8, length);
            data.insert(data.end(), chunk.begin(), chunk.end());
        }
        file = file.subspan(kAround + length);
    }
    return data;
}

/// Whether a PNG's pixels inflate to far more than its size needs. stb_image inflates before it looks at the size and
/// without bound; for files that could fill the memory so, a trial run into a buffer of the right size comes first.
bool inflates_too_far(std::span<const std::uint8_t> file, int width, int height) {
    constexpr std::size_t kHarmless = std::size_t{512} << 20;
    if (file.size() * kMostInflated <= kHarmless) return false;
    const std::vector<std::uint8_t> data = png_data(file);
    if (data.size() * kMostInflated <= kHarmless) return false;
    constexpr std::size_t kBytesPerTexel = 8;  // the widest: four channels of 16 bits
    const auto columns = static_cast<std::size_t>(width), rows = static_cast<std::size_t>(height);
    const std::size_t filters = 8 * (rows + 8);  // a byte for each row of each of seven interlaced passes
    const std::size_t most = columns * rows * kBytesPerTexel + filters;
    const std::unique_ptr<char[]> room(new char[most]);  // not cleared: only what is used takes memory
    return stbi_zlib_decode_buffer(room.get(), static_cast<int>(most), reinterpret_cast<const char*>(data.data()),
                                   static_cast<int>(data.size())) < 0;
}

}  // namespace

Result<Image> decode_image(std::span<const std::uint8_t> bytes, std::string_view name) {
    const std::string where(name);
    if (bytes.empty()) return Error{where, "is empty, expected an image such as a PNG"};
    if (bytes.size() > kMaxImageBytes)
        return Error{where, "is longer than " + std::to_string(kMaxImageBytes) + " bytes, the most that is read"};
    const auto length = static_cast<int>(bytes.size());
    int width = 0, height = 0, channels = 0;
    if (stbi_info_from_memory(bytes.data(), length, &width, &height, &channels) == 0)
        return Error{where, "is not an image that can be read, expected PNG, JPEG, BMP, TGA, GIF, PSD, HDR or PNM"};
    if (width < 1 || height < 1 || width > kMaxSize || height > kMaxSize)
        return Error{where, "is " + size_text(width, height) + ", expected sides of 1 to " + std::to_string(kMaxSize)};
    const auto texels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    if (texels > kMaxImageTexels)
        return Error{where, "is " + size_text(width, height) + ", expected at most " + std::to_string(kMaxImageTexels) +
                                " texels in an image file"};
    if (texels / kMostTexelsPerByte > bytes.size())
        return Error{where, "is too short a file for an image of " + size_text(width, height)};
    if (inflates_too_far(bytes, width, height))
        return Error{where, "is damaged: its pixels do not fit its size of " + size_text(width, height)};

    int decoded_width = 0, decoded_height = 0;
    const std::unique_ptr<stbi_uc, StbFree> decoded(
        stbi_load_from_memory(bytes.data(), length, &decoded_width, &decoded_height, &channels, 3));
    if (!decoded) {
        const char* why = stbi_failure_reason();
        return Error{where, std::string("is a damaged image: ") + (why != nullptr ? why : "it cannot be decoded")};
    }
    if (decoded_width != width || decoded_height != height)
        return Error{where, "is a damaged image: it gives two sizes"};
    Image image(width, height);
    static_assert(sizeof(Rgb) == 3);
    std::memcpy(image.data(), decoded.get(), texels * sizeof(Rgb));
    return image;
}

Result<Image> load_image(const std::filesystem::path& path) {
    std::error_code ignored;
    const std::filesystem::file_status status = std::filesystem::status(path, ignored);
    if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status))
        return Error{path.string(), "is not a regular file, expected an image"};
    const Result<std::string> bytes = read_file(path, kMaxImageBytes);
    if (!bytes) return bytes.error();
    return decode_image(bytes_of(*bytes), path.string());
}

Result<std::vector<std::uint8_t>> encode_png(const Image& image) {
    if (image.empty()) return Error{"", "an empty image cannot be written"};
    const auto append = [](void* context, void* data, int size) {
        const auto* first = static_cast<const std::uint8_t*>(data);
        auto& bytes = *static_cast<std::vector<std::uint8_t>*>(context);
        bytes.insert(bytes.end(), first, first + size);
    };
    constexpr std::size_t kMost = INT_MAX / 4;  // stb_image_write counts bytes in an int
    if (image.size() > kMost / sizeof(Rgb))
        return Error{"", "an image of " + size_text(image.width(), image.height()) + " is too large for a PNG here"};
    std::vector<std::uint8_t> bytes;
    const int row_bytes = image.width() * static_cast<int>(sizeof(Rgb));
    if (stbi_write_png_to_func(append, &bytes, image.width(), image.height(), 3, image.data(), row_bytes) == 0)
        return Error{"", "a PNG of " + size_text(image.width(), image.height()) + " cannot be encoded: out of memory"};
    return bytes;
}

}  // namespace texelscope
