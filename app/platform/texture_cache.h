// The bookkeeping that all texture stores share: which pictures are held, in which version, and when to let them go.
#pragma once

#include <unordered_map>

#include "app/platform/texture_store.h"

namespace texelscope {

class TextureCache : public TextureStore {
public:
    static constexpr int kFramesKept = 240;  ///< how long a picture is held that nobody asks for

    [[nodiscard]] ImTextureID image(std::uint64_t key, std::uint64_t version, const Grid<Rgba>& pixels) final;
    [[nodiscard]] ImTextureID image(std::uint64_t key, std::uint64_t version, const MakePixels& make) final;

    /// Counts a frame, and lets go of what was not asked for in the last kFramesKept.
    void begin_frame();

protected:
    /// Holds `pixels`, which are never empty, in place of `old` where that is not null; returns its handle, not null.
    [[nodiscard]] virtual ImTextureID upload(ImTextureID old, const Grid<Rgba>& pixels) = 0;
    virtual void release(ImTextureID held) = 0;
    /// Releases everything; for destructors, which can no longer be called back.
    void release_all();

private:
    struct Held {
        ImTextureID id = nullptr;
        std::uint64_t version = 0;
        int frame = 0;  ///< last asked for
    };
    std::unordered_map<std::uint64_t, Held> held_;
    int frame_ = 0;
};

}  // namespace texelscope
