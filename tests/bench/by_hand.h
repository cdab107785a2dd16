// The loops of two methods as one would write them with no trace, no quirks and no choice of number: what the
// templates in core/method/ are measured against, and must equal byte for byte.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>

#include "core/geometry/vertex.h"
#include "core/image/texture.h"
#include "core/number/real.h"

namespace texelscope::by_hand {

inline void fetch(Image& picture, const Rect& frame, const Texture& texture, int x, int y, double u, double v) {
    const int column = wrap_index(floor(u), texture.width(), texture.wrap);
    const int row = wrap_index(floor(v), texture.height(), texture.wrap);
    picture.at(x - frame.x0, y - frame.y0) = texture.texels.at(column, row);
}

struct Plane {
    double x, y, k;
};

inline Plane plane(std::span<const Vertex> p, double a0, double a1, double a2, double delta) {
    const double x0 = p[0].x, y0 = p[0].y, x1 = p[1].x, y1 = p[1].y, x2 = p[2].x, y2 = p[2].y;
    const double x = ((a1 - a0) * (y2 - y0) - (a2 - a0) * (y1 - y0)) / delta;
    const double y = ((x1 - x0) * (a2 - a0) - (x2 - x0) * (a1 - a0)) / delta;
    return {x, y, a0 - x0 * x - y0 * y};
}

struct Side {
    double x, y, k;
    bool owns;
};

inline Side side(const Vertex& from, const Vertex& to, double delta) {
    const bool swapped = to.y < from.y || (to.y == from.y && to.x < from.x);
    const Vertex& p = swapped ? to : from;
    const Vertex& q = swapped ? from : to;
    double x = double{q.y} - p.y, y = double{p.x} - q.x, k = -(p.x * x + p.y * y);
    if (swapped != (delta < 0)) x = -x, y = -y, k = -k;
    return {x, y, k, x < 0 || (x == 0 && y < 0)};
}

inline bool inside(const Side& s, double x, double y) {
    const double e = x * s.x + y * s.y + s.k;
    return e < 0 || (e == 0 && s.owns);
}

/// Edge equations: a triangle into a picture whose top left is the frame's.
inline void triangle(Image& picture, const Rect& frame, const Texture& texture, std::span<const Vertex> p) {
    const double delta =
        (double{p[1].x} - p[0].x) * (double{p[2].y} - p[0].y) - (double{p[2].x} - p[0].x) * (double{p[1].y} - p[0].y);
    if (delta == 0) return;
    const Plane u = plane(p, p[0].u, p[1].u, p[2].u, delta), v = plane(p, p[0].v, p[1].v, p[2].v, delta);
    const Side a = side(p[0], p[1], delta), b = side(p[1], p[2], delta), c = side(p[2], p[0], delta);
    const auto [left, right] = std::minmax({p[0].x, p[1].x, p[2].x});
    const auto [top, bottom] = std::minmax({p[0].y, p[1].y, p[2].y});
    const int x0 = static_cast<int>(std::max<Integer>(floor(left), frame.x0));
    const int x1 = static_cast<int>(std::min<Integer>(floor(right) + 1, frame.x1));
    const int y0 = static_cast<int>(std::max<Integer>(floor(top), frame.y0));
    const int y1 = static_cast<int>(std::min<Integer>(floor(bottom) + 1, frame.y1));
    for (int j = y0; j < y1; ++j) {
        for (int i = x0; i < x1; ++i) {
            const double x = i + 0.5, y = j + 0.5;
            if (!inside(a, x, y) || !inside(b, x, y) || !inside(c, x, y)) continue;
            fetch(picture, frame, texture, i, j, x * u.x + y * u.y + u.k, x * v.x + y * v.y + v.k);
        }
    }
}

struct End {
    double x, u, v;
};

inline End end(const Vertex& upper, const Vertex& lower, double y) {
    const double m = (y - upper.y) / (double{lower.y} - upper.y);
    return {upper.x + m * (double{lower.x} - upper.x), upper.u + m * (double{lower.u} - upper.u),
            upper.v + m * (double{lower.v} - upper.v)};
}

/// Sections: a convex polygon into a picture whose top left is the frame's.
inline void polygon(Image& picture, const Rect& frame, const Texture& texture, std::span<const Vertex> ring) {
    const std::size_t size = ring.size();
    double area = 0;
    for (std::size_t n = 2; n < size; ++n) {
        area += (double{ring[n - 1].x} - ring[0].x) * (double{ring[n].y} - ring[0].y) -
                (double{ring[n].x} - ring[0].x) * (double{ring[n - 1].y} - ring[0].y);
    }
    if (area == 0) return;
    std::size_t left = 0;
    float bottom = ring[0].y;
    for (std::size_t n = 1; n < size; ++n) {
        if (ring[n].y < ring[left].y) left = n;
        bottom = std::max(bottom, ring[n].y);
    }
    std::size_t right = left;
    double y_beg = ring[left].y;
    for (std::size_t k = 1; k < size && y_beg < bottom; ++k) {
        const std::size_t next_left = (left + size - 1) % size, next_right = (right + 1) % size;
        const bool right_first = ring[next_right].y < ring[next_left].y;
        const double y_end = right_first ? ring[next_right].y : ring[next_left].y;
        const int first = static_cast<int>(std::max<Integer>(ceil(y_beg - 0.5), frame.y0));
        const int last = static_cast<int>(std::min<Integer>(ceil(y_end - 0.5), frame.y1));
        for (int j = first; j < last; ++j) {
            End l = end(ring[left], ring[next_left], j + 0.5), r = end(ring[right], ring[next_right], j + 0.5);
            if (r.x < l.x) std::swap(l, r);
            const int x0 = static_cast<int>(std::max<Integer>(ceil(l.x - 0.5), frame.x0));
            const int x1 = static_cast<int>(std::min<Integer>(ceil(r.x - 0.5), frame.x1));
            for (int i = x0; i < x1; ++i) {
                const double s = (i + 0.5 - l.x) / (r.x - l.x);
                fetch(picture, frame, texture, i, j, l.u + s * (r.u - l.u), l.v + s * (r.v - l.v));
            }
        }
        if (right_first)
            right = next_right;
        else
            left = next_left;
        y_beg = y_end;
    }
}

}  // namespace texelscope::by_hand
