#include "app/platform/texture_cache.h"

namespace texelscope {

ImTextureID TextureCache::image(std::uint64_t key, std::uint64_t version, const Grid<Rgba>& pixels) {
    static const Grid<Rgba> kNothing(1, 1, Rgba{0, 0, 0, 0});
    Held& held = held_[key];
    if (held.id == nullptr || held.version != version) {
        held.id = upload(held.id, pixels.empty() ? kNothing : pixels);
        held.version = version;
    }
    held.frame = frame_;
    return held.id;
}

ImTextureID TextureCache::image(std::uint64_t key, std::uint64_t version, const MakePixels& make) {
    const auto held = held_.find(key);
    const bool known = held != held_.end() && held->second.id != nullptr && held->second.version == version;
    return image(key, version, known ? Grid<Rgba>() : make());
}

void TextureCache::begin_frame() {
    ++frame_;
    for (auto it = held_.begin(); it != held_.end();) {
        if (frame_ - it->second.frame <= kFramesKept) {
            ++it;
            continue;
        }
        release(it->second.id);
        it = held_.erase(it);
    }
}

void TextureCache::release_all() {
    for (const auto& [key, held] : held_) release(held.id);
    held_.clear();
}

}  // namespace texelscope
