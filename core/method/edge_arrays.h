// The four passes of edge-equations over arrays that are really there: what runs where nobody asks for a step in their
// midst. Where somebody does, each pass computes anew what it needs of those before it (draw_arrays).
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/number/real.h"
#include "core/trace/fate.h"

namespace texelscope::edge_arrays {

inline constexpr Integer kMostSamples = 1 << 23;  ///< of a box whose arrays are kept; together below 0.5 GB in double

/// Whether the arrays of a box may be kept.
[[nodiscard]] bool fit(const auto& box) {
    return Integer{plain(box.x1 - box.x0)} * Integer{plain(box.y1 - box.y0)} <= kMostSamples;
}

/// Puts the samples that draw_arrays would put, in the same order.
template <class Method>
Fate draw(const Method& method, const typename Method::Setup& s, auto&& put) {
    using Int = typename Method::Int;
    using Pixel = typename Method::Pixel;
    struct Place {
        Int x, y;
    };
    struct Found {
        decltype(Pixel::u) u, v;
        Int column, row;
    };
    const auto rows = method.trace.each('y', s.box.y0, s.box.y1), columns = method.trace.each('x', s.box.x0, s.box.x1);
    std::vector<std::uint8_t> mask;
    for (const Int j : rows) {
        for (const Int i : columns) {
            const Pixel p = method.cover(s, i, j);
            mask.push_back(p.fate == Fate::written ? 1 : 0);
            if (p.fate != Fate::written) put(i, j, p);
        }
    }
    std::vector<Place> places;
    std::size_t at = 0;
    for (const Int j : rows)
        for (const Int i : columns)
            if (mask[at++] != 0) places.push_back({i, j});
    std::vector<Found> found;
    found.reserve(places.size());
    for (const Place& place : places) {
        Pixel p = method.sample(s, place.x, place.y);
        method.address(s, p);
        found.push_back({p.u, p.v, p.texel.column, p.texel.row});
    }
    for (std::size_t n = 0; n < places.size(); ++n) {
        Pixel p;
        p.u = found[n].u, p.v = found[n].v, p.texel.column = found[n].column, p.texel.row = found[n].row;
        method.fetch(s, p);
        put(places[n].x, places[n].y, p);
    }
    return Fate::written;
}

}  // namespace texelscope::edge_arrays
