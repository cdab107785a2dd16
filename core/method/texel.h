// From (u, v) to a colour: shared by every method, whatever its numbers. The calls are traced where they stand.
#pragma once

#include "core/image/texture.h"
#include "core/image/wrap.h"
#include "core/number/real.h"
#include "core/trace/fate.h"

namespace texelscope {

/// NaN, or an exact number without a value: what differs from itself.
template <class T>
[[nodiscard]] bool has_no_value(const T& x) {
    const T& itself = x;
    return plain(x != itself);
}

/// The texel index inside [0, size); the recorded twin of wrap_index.
template <class Int>
[[nodiscard]] Int wrapped(const Int& index, int size, Wrap wrap) {
    switch (wrap) {
        case Wrap::mask: return index & Integer{size - 1};
        case Wrap::clamp: return lesser(greater(index, Int(0)), Int(size - 1));
        case Wrap::repeat: break;
    }
    return euclidean_modulo(index, Integer{size});
}

/// A channel under light L: min(255, trunc(channel * L)), or modulo 256 as a byte store has it.
template <class T>
[[nodiscard]] IntegerOf<T> lit(const T& channel, const T& light, bool modulo_256) {
    using Int = IntegerOf<T>;
    const Int value = trunc(channel * light);
    if (modulo_256) return value & Integer{255};
    return lesser(greater(value, Int(0)), Int(255));
}

/// A channel of a texel under the method's light; a light of 1 leaves it alone.
template <class T>
[[nodiscard]] IntegerOf<T> shaded(int channel, float lightness, NumberMode mode, bool modulo_256 = false) {
    if (lightness == 1) return IntegerOf<T>(channel);
    return lit(T(channel), Input<T>::from(lightness, mode), modulo_256);
}

/// One sample as a method leaves it: every intermediate is in the method's own struct, this is what all have.
template <class T>
struct Texel {
    IntegerOf<T> column{}, row{};  ///< in the texture, after wrapping
    IntegerOf<T> r{}, g{}, b{};    ///< lit [0, 255]
};

/// A sample that is covered, where a method computes nothing else for it.
template <class T>
struct Fragment {
    T u{}, v{};
    Texel<T> texel{};
    Fate fate = Fate::written;
    Note note = Note::none;
};

/// From (u, v) to the lit colour, for methods that do nothing else than this with it. Traced at the caller's line.
/// @param as_printed  trunc(u) & (size - 1), as the sources index their textures, in place of floor and wrap mode.
template <class T>
[[nodiscard]] Texel<T> read_texel(const auto& method, const T& u, const T& v, bool as_printed = false,
                                  int line = __builtin_LINE()) {
    const Texture& texture = method.texture;
    const auto index = [&](const T& a, int size) {
        return as_printed ? wrapped(trunc(a), size, Wrap::mask) : wrapped(floor(a), size, texture.wrap);
    };
    Texel<T> t;
    t.column = method.trace("column", index(u, texture.width()), line);
    t.row = method.trace("row", index(v, texture.height()), line);
    const Rgb& colour = texture.texels.at(int(plain(t.column)), int(plain(t.row)));
    t.r = method.trace("r", shaded<T>(colour.r, method.lightness, method.mode), line);
    t.g = method.trace("g", shaded<T>(colour.g, method.lightness, method.mode), line);
    t.b = method.trace("b", shaded<T>(colour.b, method.lightness, method.mode), line);
    return t;
}

/// A fragment of given (u, v), traced and written.
template <class T>
[[nodiscard]] Fragment<T> fragment_at(const auto& method, const T& u, const T& v, int line = __builtin_LINE()) {
    Fragment<T> f;
    f.u = method.trace("u", u, line);
    f.v = method.trace("v", v, line);
    f.texel = read_texel(method, f.u, f.v, false, line);
    f.fate = method.trace.fate(Fate::written);
    return f;
}

}  // namespace texelscope
