#include "core/image/palette.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

namespace texelscope {
namespace {

struct Colour {
    std::uint32_t key;          // r, g, b from the high byte down, so that keys sort as colours do
    std::uint32_t count;        // pixels that have it
    std::uint32_t becomes = 0;  // the colour, then the palette entry, that takes its place
};

std::uint32_t key_of(Rgb c) { return std::uint32_t{c.r} << 16 | std::uint32_t{c.g} << 8 | c.b; }
int channel_of(std::uint32_t key, int channel) { return static_cast<int>(key >> (16 - 8 * channel) & 255); }

/// The colours of the image, ascending.
std::vector<Colour> colours_of(const Image& image) {
    constexpr std::size_t kSortAtMost = std::size_t{1} << 18;  // above that a table of all colours is the cheaper way
    const std::span<const Rgb> pixels(image.data(), image.size());
    std::vector<Colour> colours;
    if (pixels.size() <= kSortAtMost) {
        std::vector<std::uint32_t> keys;
        keys.reserve(pixels.size());
        for (const Rgb pixel : pixels) keys.push_back(key_of(pixel));
        std::sort(keys.begin(), keys.end());
        for (const std::uint32_t key : keys) {
            if (colours.empty() || colours.back().key != key) colours.push_back({key, 0});
            ++colours.back().count;
        }
        return colours;
    }
    std::vector<std::uint32_t> counts(std::size_t{1} << 24);
    for (const Rgb pixel : pixels) ++counts[key_of(pixel)];
    for (std::uint32_t key = 0; key < counts.size(); ++key)
        if (counts[key] != 0) colours.push_back({key, counts[key]});
    return colours;
}

struct Box {
    std::span<Colour> colours;
    int channel = 0;  // the one in which the colours differ most
    int extent = 0;   // by how much; 0 for a single colour
};

Box box_of(std::span<Colour> colours) {
    Box box{colours};
    for (int channel = 0; channel < 3; ++channel) {
        int low = 255, high = 0;
        for (const Colour& colour : colours) {
            low = std::min(low, channel_of(colour.key, channel));
            high = std::max(high, channel_of(colour.key, channel));
        }
        if (high - low > box.extent) box.channel = channel, box.extent = high - low;
    }
    return box;
}

/// Sorts the box's colours along its channel and gives where to cut: half the pixels on each side, neither side empty.
std::size_t median(const Box& box) {
    std::sort(box.colours.begin(), box.colours.end(), [c = box.channel](const Colour& a, const Colour& b) {
        const int x = channel_of(a.key, c), y = channel_of(b.key, c);
        return x != y ? x < y : a.key < b.key;
    });
    std::uint64_t total = 0, below = 0;
    for (const Colour& colour : box.colours) total += colour.count;
    std::size_t cut = 0;
    while (cut + 1 < box.colours.size() && 2 * below < total) below += box.colours[cut++].count;
    return cut;
}

Rgb mean(std::span<const Colour> colours) {
    std::uint64_t total = 0;
    std::array<std::uint64_t, 3> sum{};
    for (const Colour& colour : colours) {
        total += colour.count;
        for (int c = 0; c < 3; ++c) sum[c] += static_cast<std::uint64_t>(channel_of(colour.key, c)) * colour.count;
    }
    const auto round = [total](std::uint64_t s) { return static_cast<std::uint8_t>((s + total / 2) / total); };
    return {round(sum[0]), round(sum[1]), round(sum[2])};
}

std::vector<Box> cut_boxes(std::span<Colour> colours, int most) {
    std::vector<Box> boxes{box_of(colours)};
    while (static_cast<int>(boxes.size()) < most) {
        const auto widest = std::max_element(boxes.begin(), boxes.end(),
                                             [](const Box& a, const Box& b) { return a.extent < b.extent; });
        if (widest->extent == 0) break;
        const std::size_t cut = median(*widest);
        const std::span<Colour> all = widest->colours;
        *widest = box_of(all.first(cut));
        boxes.push_back(box_of(all.subspan(cut)));
    }
    return boxes;
}

}  // namespace

Paletted reduce_to_palette(const Image& image, int colours) {
    TEXELSCOPE_ASSERT(colours >= 1 && colours <= 256);
    Paletted result{{}, Grid<std::uint8_t>(image.width(), image.height())};
    if (image.empty()) return result;
    std::vector<Colour> found = colours_of(image);
    const std::vector<Box> boxes = cut_boxes(found, colours);
    std::vector<std::uint32_t> keys;
    for (const Box& box : boxes) keys.push_back(key_of(mean(box.colours)));
    for (std::size_t b = 0; b < boxes.size(); ++b)
        for (Colour& colour : boxes[b].colours) colour.becomes = keys[b];
    std::sort(keys.begin(), keys.end());
    keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
    for (const std::uint32_t key : keys)
        result.palette.push_back({static_cast<std::uint8_t>(key >> 16), static_cast<std::uint8_t>(key >> 8 & 255),
                                  static_cast<std::uint8_t>(key & 255)});
    const auto by_key = [](const Colour& a, const Colour& b) { return a.key < b.key; };
    std::sort(found.begin(), found.end(), by_key);
    for (Colour& colour : found)
        colour.becomes =
            static_cast<std::uint32_t>(std::lower_bound(keys.begin(), keys.end(), colour.becomes) - keys.begin());
    for (std::size_t i = 0; i < image.size(); ++i) {
        const Colour wanted{key_of(image.data()[i]), 0};
        const auto at = std::lower_bound(found.begin(), found.end(), wanted, by_key);
        result.indices.data()[i] = static_cast<std::uint8_t>(at->becomes);
    }
    return result;
}

Texture with_palette(Texture texture, int colours) {
    Paletted paletted = reduce_to_palette(texture.texels, colours);
    for (std::size_t i = 0; i < paletted.indices.size(); ++i)
        texture.texels.data()[i] = paletted.palette[paletted.indices.data()[i]];
    texture.palette = std::move(paletted.palette);
    texture.indices = std::move(paletted.indices);
    texture.source.palette = colours;
    return texture;
}

}  // namespace texelscope
