// Makes a Method's functions out of its struct template: the same code over each number type and trace.
// Included by the two files of a method: the plain half (always -O3) and the recorded half.
#pragma once

#include <array>

#include "core/method/method.h"
#include "core/method/texel.h"

namespace texelscope::run {

/// Sets the flags of a quirk struct from the bits of a set, in the order of the method's list.
template <class Quirks, std::size_t N>
[[nodiscard]] Quirks quirks_from(QuirkSet bits, const std::array<bool Quirks::*, N>& fields) {
    Quirks quirks;
    for (std::size_t n = 0; n < N; ++n) quirks.*fields[n] = (bits >> n & 1U) != 0;
    return quirks;
}

template <template <class, class> class M, class T, class Trace, std::size_t N>
[[nodiscard]] M<T, Trace> make(const Job& job, const std::array<bool M<T, Trace>::Quirks::*, N>& fields, Trace trace) {
    M<T, Trace> method{job.frame, *job.texture, job.light, job.cull_back, quirks_from(job.quirks, fields),
                       job.mode,  trace};
    if constexpr (requires { method.shape; }) method.shape = job.shape;
    if constexpr (requires { method.unrounded; })
        method.unrounded = job.unrounded, method.unrounded_light = job.unrounded_light;
    return method;
}

/// Calls f(T{}) with the type of the format.
auto with_type(NumberFormat format, auto&& f) {
    switch (format) {
        case NumberFormat::f32: return f(float{});
        case NumberFormat::fx16_16: return f(Fixed16{});
        case NumberFormat::fx8_8: return f(Fixed8{});
        case NumberFormat::exact: return f(Exact{});
        case NumberFormat::f64: break;
    }
    return f(double{});
}

[[nodiscard]] inline Rgb colour_of(const auto& texel) {
    return {static_cast<std::uint8_t>(plain(texel.r)), static_cast<std::uint8_t>(plain(texel.g)),
            static_cast<std::uint8_t>(plain(texel.b))};
}

template <class Method>
[[nodiscard]] Fate draw_into(Image& picture, const Job& job, const Method& method) {
    // By value, as for all that the compiler knows a pixel's bytes may be anybody's; in 64 bits, as x and y are.
    Rgb* const first = picture.data();
    const Integer width = picture.width();
    const Rect frame = job.frame;
    return method.draw(job.corners, [=](Integer x, Integer y, const auto& pixel) {
        if (pixel.fate != Fate::written) return;
        TEXELSCOPE_ASSERT(frame.contains(x, y));
        first[(y - frame.y0) * width + (x - frame.x0)] = colour_of(pixel.texel);
    });
}
/// All that a method calls becomes one function, or the calls would cost more than the arithmetic; and where there is
/// neither quirk nor light the compiler is told so, for the loop over pixels to have no branches on them.
template <template <class, class> class M, class T>
[[gnu::flatten]] Fate draw_corrected(const Job& job, Image& picture) {
    const M<T, NoTrace> method{job.frame, *job.texture, 1, job.cull_back, {}, job.mode, {}};
    return draw_into(picture, job, method);
}
template <template <class, class> class M, class T, auto fields>
[[gnu::flatten]] Fate draw_flat(const Job& job, Image& picture) {
    return draw_into(picture, job, make<M, T>(job, fields, NoTrace{}));
}

template <template <class, class> class M, auto fields>
Fate render(NumberFormat format, const Job& job, Image& picture) {
    return with_type(format, [&](auto type) {
        using T = decltype(type);
        // Flattening takes the compiler long, and only where the machine's own arithmetic is used is it worth it.
        if constexpr (!std::floating_point<T>)
            return draw_into(picture, job, make<M, T>(job, fields, NoTrace{}));
        else
            return job.quirks == 0 && job.light == 1 ? draw_corrected<M, T>(job, picture)
                                                     : draw_flat<M, T, fields>(job, picture);
    });
}

/// Hands on those samples of `draw` that lie in the window, in plain numbers.
[[nodiscard]] inline auto put_inside(const Window& window, const Put& put) {
    return [&](Integer x, Integer y, const auto& pixel) {
        const Rect& rect = window.rect;
        if (x < rect.x0 || x >= rect.x1 || y < rect.y0 || y >= rect.y1) return;
        if ((x - rect.x0) % window.stride != 0 || (y - rect.y0) % window.stride != 0) return;
        Sample s{.x = x, .y = y, .fate = pixel.fate, .note = pixel.note};
        if (s.fate == Fate::written) {
            s.u = approximate(pixel.u), s.v = approximate(pixel.v);
            s.column = static_cast<int>(pixel.texel.column), s.row = static_cast<int>(pixel.texel.row);
            s.colour = colour_of(pixel.texel);
        }
        put(s);
    };
}

/// What the methods make of each value of a channel under the job's light.
template <class T>
[[nodiscard]] std::array<std::uint8_t, 256> lit_channels(const Job& job) {
    std::array<std::uint8_t, 256> lit{};
    for (std::size_t n = 0; n < lit.size(); ++n)
        lit[n] = static_cast<std::uint8_t>(shaded<T>(static_cast<int>(n), job.light, job.mode));
    return lit;
}
/// As draw_corrected, and for the same reason. The faces of solids have a light: it is looked up.
template <template <class, class> class M, class T>
[[gnu::flatten]] Fate paint_corrected(const Job& job, const Window& part, int shape, Layer& layer) {
    const auto lit = lit_channels<T>(job);
    const M<T, WindowTrace> method{job.frame, *job.texture, 1, job.cull_back, {}, job.mode, WindowTrace(part)};
    return method.draw(job.corners, layer.put(shape, job.half, [lit = lit.data()](const auto& texel) {
        const Rgb colour = colour_of(texel);
        return Rgb{lit[colour.r], lit[colour.g], lit[colour.b]};
    }));
}

template <template <class, class> class M, class T, auto fields>
Fate paint_any(const Job& job, const Window& part, int shape, Layer& layer) {
    const auto method = make<M, T>(job, fields, WindowTrace(part));
    return method.draw(job.corners, layer.put(shape, job.half, [](const auto& texel) { return colour_of(texel); }));
}
template <template <class, class> class M, class T, auto fields>
[[gnu::flatten]] Fate paint_flat(const Job& job, const Window& part, int shape, Layer& layer) {
    return paint_any<M, T, fields>(job, part, shape, layer);
}

template <template <class, class> class M, auto fields>
Fate paint(NumberFormat format, const Job& job, const Window& part, int shape, Layer& layer) {
    return with_type(format, [&](auto type) {
        using T = decltype(type);
        if constexpr (!std::floating_point<T>)
            return paint_any<M, T, fields>(job, part, shape, layer);
        else
            return job.quirks == 0 ? paint_corrected<M, T>(job, part, shape, layer)
                                   : paint_flat<M, T, fields>(job, part, shape, layer);
    });
}

template <template <class, class> class M, auto fields>
Fate samples(NumberFormat format, const Job& job, const Window& window, const Put& put) {
    return with_type(format, [&](auto type) {
        const auto method = make<M, decltype(type)>(job, fields, WindowTrace(window));
        return method.draw(job.corners, put_inside(window, put));
    });
}

template <template <class, class> class M, auto fields>
LineCounts until(NumberFormat format, const Job& job, const Window& window, const Path& target, const Put& put) {
    Progress progress;
    progress.target = target.unit();
    with_type(format, [&](auto type) {
        const auto method = make<M, decltype(type)>(job, fields, PartialTrace{WindowTrace(window), &progress});
        return method.draw(job.corners, put_inside(window, put));
    });
    return std::move(progress.counts);
}

template <template <class, class> class M, auto fields>
Visit visit(NumberFormat format, const Job& job, const Path& path) {
    return with_type(format, [&](auto type) {
        Recording recording(path);
        const auto method = make<M, Recorded<decltype(type)>>(job, fields, Listener{&recording});
        const Fate fate = method.draw(job.corners, [](const auto&, const auto&, const auto&) {});
        return std::move(recording).finish(fate);
    });
}

/// The functions of a method's plain half, filled in.
template <template <class, class> class M, auto fields>
[[nodiscard]] constexpr Method with_functions(Method method) {
    method.render = render<M, fields>;
    method.paint = paint<M, fields>;
    method.samples = samples<M, fields>;
    method.until = until<M, fields>;
    return method;
}

}  // namespace texelscope::run
