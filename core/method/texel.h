// From (u, v) to a colour: shared by every method, whatever its numbers. The calls are traced where they stand.
#pragma once

#include "core/image/texture.h"
#include "core/image/wrap.h"
#include "core/number/real.h"

namespace texelscope {

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

/// One sample as a method leaves it: every intermediate is in the method's own struct, this is what all have.
template <class T>
struct Texel {
    IntegerOf<T> column{}, row{};  ///< in the texture, after wrapping
    IntegerOf<T> r{}, g{}, b{};    ///< lit [0, 255]
};

}  // namespace texelscope
