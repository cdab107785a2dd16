// What the views `front`, `skips` and `certificate` show of the scene without a clock.
#include "app/state/derived_cache.h"
#include "core/method/decisions.h"

namespace texelscope {

const RungPicture& Derived::rung_picture(const Rung& rung) const {
    auto& kept = cache_->rung;
    if (!kept || kept->first != rung.id) kept.emplace(rung.id, texelscope::rung_picture(front_scene_of(scene()), rung));
    return kept->second;
}

const SkipCount& Derived::skip_count() const {
    auto& kept = cache_->skips;
    const std::uint32_t skips = cache_->state.look.skips;
    if (!kept || kept->first != skips) kept.emplace(skips, count_skips(scene(), skips));
    return kept->second;
}

const Decisions& Derived::decisions() const {
    auto& kept = cache_->of_drawing.decisions;
    const int n = shape();
    if (kept && kept->first == n) return kept->second;
    kept.emplace(n, decisions_of(drawing(), n));
    return kept->second;
}

}  // namespace texelscope
