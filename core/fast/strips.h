// Which rows each triangle meets, found once, so that a band of rows need not look at the triangles of others: two
// bytes a triangle.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>

namespace texelscope {

/// A target's rows cut into strips of equal height, and the strips of each triangle.
struct Strips {
    static constexpr int kMost = 127;  ///< strips of a target
    static constexpr int kBlock = 64;  ///< the bytes are a multiple of so many

    Strips(int triangles, int height)
        : bytes((triangles + kBlock - 1) / kBlock * kBlock),
          first(new std::int8_t[static_cast<std::size_t>(bytes)]),
          last(new std::int8_t[static_cast<std::size_t>(bytes)]) {
        while (height > kMost << shift) ++shift;
        count = ((height - 1) >> shift) + 1;
    }

    int bytes;
    int shift = 4;  ///< a strip has 2^shift rows: no fewer than a tile of depths
    int count;      ///< strips of the target
    /// Of each triangle, the first and the last strip that it may meet; kMost and 0 where it draws nothing.
    std::unique_ptr<std::int8_t[]> first, last;
};

/// Some strips, to be drawn by themselves.
struct Band {
    const Strips* strips;
    int begin, end;
};

}  // namespace texelscope
