// Textures of the current OpenGL context.
#pragma once

#include "app/platform/texture_cache.h"

namespace texelscope {

/// Needs a current context whenever it is used or destroyed. A picture larger than the driver allows shows black.
class OpenGlTextures final : public TextureCache {
public:
    ~OpenGlTextures() override { release_all(); }

private:
    ImTextureID upload(ImTextureID old, const Grid<Rgba>& pixels) override;
    void release(ImTextureID held) override;
};

}  // namespace texelscope
