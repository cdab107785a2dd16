// The samples inside a convex ring, row by row or column by column, under the top-left rule. Methods trace the
// crossings where they ask for them.
#pragma once

#include <boost/container/small_vector.hpp>

#include "core/number/real.h"

namespace texelscope {

/// Corners in order, either winding.
template <Real T>
struct Outline {
    using Int = IntegerOf<T>;
    struct Point {
        T x{}, y{};
    };
    /// Where a line of samples enters the ring and leaves it.
    struct Span {
        T from{}, to{};
        bool owns_from = true, owns_to = false;  ///< whether a sample right on that end is inside
        bool empty = true;
    };
    struct Extent {
        T low{}, high{};
    };
    boost::container::small_vector<Point, 8> ring;

    [[nodiscard]] Extent extent(T Point::*axis) const {
        Extent e{ring[0].*axis, ring[0].*axis};
        for (const Point& p : ring) {
            e.low = plain(p.*axis < e.low) ? p.*axis : e.low;
            e.high = plain(e.high < p.*axis) ? p.*axis : e.high;
        }
        return e;
    }
    [[nodiscard]] Extent columns() const { return extent(&Point::x); }
    [[nodiscard]] Extent rows() const { return extent(&Point::y); }

    /// The row of samples at height y: from the left crossing up to but without the right one.
    [[nodiscard]] Span row(const T& y) const {
        Span s;
        for (std::size_t n = 0; n < ring.size(); ++n) {
            const Point &p = ring[n], &q = ring[(n + 1) % ring.size()];
            // From its upper end, whichever shape a side belongs to: neighbours find the same crossing.
            const Point &upper = plain(q.y < p.y) ? q : p, &lower = plain(q.y < p.y) ? p : q;
            if (plain(y < upper.y) || !plain(y < lower.y)) continue;
            take(s, crossing(upper.x, lower.x, y - upper.y, lower.y - upper.y), true, false);
        }
        return s;
    }
    /// The column of samples at x. Left sides own their samples here, too, so an end may be inside at either end.
    [[nodiscard]] Span column(const T& x) const {
        Span s;
        for (std::size_t n = 0; n < ring.size(); ++n) {
            const Point &p = ring[n], &q = ring[(n + 1) % ring.size()];
            const Point &left = plain(q.x < p.x) ? q : p, &right = plain(q.x < p.x) ? p : q;
            if (plain(x < left.x) || !plain(x < right.x)) continue;
            const bool falls = plain(left.y < right.y);  // then the inside lies to its right only if it is above it
            take(s, crossing(left.y, right.y, x - left.x, right.x - left.x), !falls, falls);
        }
        return s;
    }
    /// The first sample of the span, and the one after its last.
    [[nodiscard]] static Int first(const Span& s) {
        return s.owns_from ? ceil(s.from - T(1) / 2) : floor(s.from - T(1) / 2) + 1;
    }
    [[nodiscard]] static Int last(const Span& s) {
        return s.owns_to ? floor(s.to - T(1) / 2) + 1 : ceil(s.to - T(1) / 2);
    }

private:
    [[nodiscard]] static T crossing(const T& a, const T& b, const T& way, const T& whole) {
        return a + way / whole * (b - a);
    }
    /// Where two sides meet the line in one corner, each says of its own end whether it is inside.
    static void take(Span& s, const T& at, bool owns_from, bool owns_to) {
        const bool least = s.empty || plain(at < s.from), most = s.empty || plain(s.to < at);
        s.owns_from = least ? owns_from : s.owns_from || (owns_from && plain(at == s.from));
        s.owns_to = most ? owns_to : s.owns_to || (owns_to && plain(at == s.to));
        if (least) s.from = at;
        if (most) s.to = at;
        s.empty = false;
    }
};

}  // namespace texelscope
