// How a view shows pixels without knowing what draws them.
#pragma once

#include <cstdint>
#include <functional>

#include <imgui.h>

#include "core/image/image.h"
#include "core/image/rgba.h"

namespace texelscope {

class TextureStore {
public:
    TextureStore() = default;
    TextureStore(const TextureStore&) = delete;
    TextureStore& operator=(const TextureStore&) = delete;
    virtual ~TextureStore() = default;

    /// The handle under which ImGui draws `pixels`, nearest texel, this frame; ask again in every frame that shows it.
    /// @param key      names the picture; one that is not asked for in many frames is forgotten.
    /// @param version  changes whenever the pixels do; they are read again only then.
    [[nodiscard]] virtual ImTextureID image(std::uint64_t key, std::uint64_t version, const Grid<Rgba>& pixels) = 0;
    /// The same of pixels that are made only when they are read.
    using MakePixels = std::function<Grid<Rgba>()>;
    [[nodiscard]] virtual ImTextureID image(std::uint64_t key, std::uint64_t version, const MakePixels& make) = 0;
};

}  // namespace texelscope
