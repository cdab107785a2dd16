// What the views of random triangles show: the bills of the racing methods, and where palette colours are used.
#include <algorithm>

#include "app/state/derived_cache.h"

namespace texelscope {
namespace {

/// The colour's place in a palette, which ascends; -1 where it is not there.
[[nodiscard]] int index_of(const std::vector<Rgb>& palette, const Rgb& colour) {
    const auto key = [](const Rgb& c) { return c.r << 16 | c.g << 8 | c.b; };
    const auto found = std::lower_bound(palette.begin(), palette.end(), colour,
                                        [&](const Rgb& a, const Rgb& b) { return key(a) < key(b); });
    return found == palette.end() || !(*found == colour) ? -1 : static_cast<int>(found - palette.begin());
}

}  // namespace

const std::vector<Bill>& Derived::bills() const {
    auto& bills = cache_->bills;
    if (bills) return *bills;
    bills.emplace();
    if (drawing().shape_count() == 0) return *bills;
    for (const Method* racer : racers()) bills->push_back(bill_of(scene(), *racer));
    return *bills;
}

const PaletteUse& Derived::palette_use() const {
    auto& kept = cache_->of_drawing.palette;
    const Texture& texture = this->texture();
    if (kept && kept->first == &texture) return kept->second;
    kept.emplace(&texture, PaletteUse{});
    PaletteUse& use = kept->second;
    const Rect frame = scene().framebuffer.rect();
    use.shown = Grid<std::int16_t>(frame.width(), frame.height(), -1);
    if (texture.palette.empty()) return use;
    for (std::size_t n = 0; n < texture.indices.size(); ++n) ++use.texels[texture.indices.data()[n]];
    const Layer layer = layer_of(drawing(), drawing().shape_count(), {frame, 1});
    for (std::size_t n = 0; n < layer.cells().size(); ++n) {
        const LayerCell& cell = layer.cells().data()[n];
        if (cell.shape < 0 || drawing().is_half(cell.shape)) continue;
        const Job job = drawing().job(cell.shape);
        const int index = job.texture == &texture && job.light == 1 ? index_of(texture.palette, cell.colour) : -1;
        if (index < 0) continue;
        use.shown.data()[n] = static_cast<std::int16_t>(index);
        ++use.pixels[static_cast<std::size_t>(index)];
    }
    return use;
}

}  // namespace texelscope
