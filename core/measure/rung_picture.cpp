#include "core/measure/rung_picture.h"

#include <algorithm>

#include "core/base/assert.h"

namespace texelscope {
namespace {

constexpr std::int32_t kNone = -1;
constexpr std::size_t kRational = 2;  ///< triangles of a method in fractions: a window waits for them

/// The texel that each pixel shows in the end, row * width of the texture + column.
[[nodiscard]] Grid<std::int32_t> texels_of(RungStage& stage, const Rung& rung, std::size_t triangles) {
    const Rect& frame = stage.scene().frame;
    Grid<std::int32_t> texels(frame.width(), frame.height(), kNone);
    for (std::size_t n = 0; n < triangles; ++n)
        stage.each_sample(rung, n, [&](const Sample& s) {
            if (!frame.contains(s.x, s.y)) return;
            texels.at(static_cast<int>(s.x) - frame.x0, static_cast<int>(s.y) - frame.y0) =
                s.row * kFrontTexture + s.column;
        });
    return texels;
}

[[nodiscard]] PixelVerdict verdict_of(std::int32_t given, std::int32_t exact) {
    if (given == exact) return given == kNone ? PixelVerdict::empty : PixelVerdict::right;
    if (given == kNone) return PixelVerdict::missing;
    return exact == kNone ? PixelVerdict::extra : PixelVerdict::wrong;
}

}  // namespace

RungPicture rung_picture(const FrontScene& scene, const Rung& rung) {
    static const Rung* const kExact = find_rung("fast");  // sample for sample the definition, and quick
    TEXELSCOPE_ASSERT(kExact != nullptr);
    RungStage stage(scene);
    RungPicture picture{.frame = scene.frame};
    const bool rational = rung.kind == RungKind::method && rung.format == NumberFormat::exact;
    picture.triangles = std::min(stage.count(rung), rational ? kRational : scene.triangles());
    const Grid<std::int32_t> given = texels_of(stage, rung, picture.triangles),
                             exact = texels_of(stage, *kExact, picture.triangles);
    picture.pixels = Grid<PixelVerdict>(scene.frame.width(), scene.frame.height(), PixelVerdict::empty);
    for (std::size_t n = 0; n < given.size(); ++n) {
        const PixelVerdict verdict = verdict_of(given.data()[n], exact.data()[n]);
        picture.pixels.data()[n] = verdict;
        picture.right += verdict == PixelVerdict::right, picture.wrong += verdict == PixelVerdict::wrong;
        picture.missing += verdict == PixelVerdict::missing, picture.extra += verdict == PixelVerdict::extra;
    }
    return picture;
}

}  // namespace texelscope
