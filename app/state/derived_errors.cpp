// Where the texel coordinates of the settings leave those in perspective.
#include <algorithm>
#include <cmath>

#include "app/state/derived_cache.h"
#include "core/method/cells.h"

namespace texelscope {
namespace {

constexpr std::string_view kReference = "barycentric", kAffine = "affine";

/// The same scene in perspective. The method's own quirks stay where it is the reference's, so that the map shows
/// what the missing perspective does and nothing else.
[[nodiscard]] DrawSettings in_perspective(const DrawSettings& settings, NumberFormat format) {
    const Method* method = find_method(kReference);
    DrawSettings reference{method, format, 0, {}};
    if (settings.method != method) return reference;
    for (std::size_t n = 0; n < method->quirks.size(); ++n)
        if (method->quirks[n].field != kAffine) reference.quirks |= settings.quirks & QuirkSet{1} << n;
    return reference;
}

/// (u, v) of the sample that is seen in the end, of each cell; nothing where none is written.
[[nodiscard]] Grid<std::optional<glm::dvec2>> seen(const Drawing& drawing, const Window& window) {
    auto uv = cells_of<std::optional<glm::dvec2>>(window);
    each_sample(drawing, 0, drawing.shape_count(), window, [&](int, const Sample& s) {
        if (s.fate == Fate::written) cell_of(uv, window, s) = glm::dvec2(s.u, s.v);
    });
    return uv;
}

[[nodiscard]] UvError between(const std::optional<glm::dvec2>& a, const std::optional<glm::dvec2>& b) {
    if (!a && !b) return {};
    const glm::dvec2 apart = a && b ? *a - *b : glm::dvec2(NAN);
    if (!std::isfinite(apart.x) || !std::isfinite(apart.y)) return {UvError::Kind::one_only, 0, 0};
    return {UvError::Kind::both, apart.x, apart.y};
}

}  // namespace

double UvError::length() const { return std::hypot(u, v); }

const ErrorMap& Derived::errors(const Window& wanted) const {
    const Window window{intersection(wanted.rect, scene().framebuffer.rect()), std::max(1, wanted.stride)};
    auto& errors = cache_->of_drawing.errors;
    if (errors && errors->window == window) return *errors;
    const DrawSettings& settings = drawing().settings();
    const auto now = seen(drawing(), window),
               then = seen(Drawing(scene(), in_perspective(settings, NumberFormat::f64)), window);
    errors = {window, {now.width(), now.height()}, {}, {}, 0};
    double most = 0;
    for (int y = 0; y < now.height(); ++y) {
        for (int x = 0; x < now.width(); ++x) {
            const UvError e = errors->cells.at(x, y) = between(now.at(x, y), then.at(x, y));
            if (e.kind != UvError::Kind::both) continue;
            errors->v_most = std::max(errors->v_most, std::abs(e.v));
            if (errors->worst && !(e.length() > most)) continue;
            most = e.length();
            errors->worst = {window.rect.x0 + x * window.stride, window.rect.y0 + y * window.stride};
        }
    }
    if (!errors->worst) return *errors;
    // Exact numbers are too slow for a picture in every frame of a drag, but not for one pixel.
    const glm::ivec2 p = *errors->worst;
    const Window one{{p.x, p.y, p.x + 1, p.y + 1}, 1};
    const Drawing exact(scene(), in_perspective(settings, NumberFormat::exact));
    errors->error = between(seen(drawing(), one).at(0, 0), seen(exact, one).at(0, 0));
    return *errors;
}

}  // namespace texelscope
