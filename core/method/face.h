// A face with its texture laid on by one 3x3 matrix, projection, view, model and texture in one (S5: N. Holzschuch,
// "Textures: un peu de maths"): (x W, y W, W) = M (u, v, 1), and by its inverse (u, v, 1) / W = M⁻¹ (x, y, 1).
// Everything is traced at the line of the method that asks for it.
#pragma once

#include <array>
#include <span>

#include "core/geometry/vertex.h"
#include "core/image/texture.h"
#include "core/method/outline.h"
#include "core/method/texel.h"
#include "core/trace/trace.h"

namespace texelscope {

template <Real T>
using Row3 = std::array<T, 3>;
template <Real T>
using Matrix3 = std::array<Row3<T>, 3>;

template <Real T>
struct Face {
    struct Corner {
        T x{}, y{}, u{}, v{}, w{};
    };
    boost::container::small_vector<Corner, 8> ring;
    std::array<int, 3> spanning{};  ///< three corners that say how the texture lies: the widest of a fan from the first
    Outline<T> outline;             ///< on the screen [px]
    Fate fate = Fate::written;

    [[nodiscard]] const Corner& corner(int n) const { return ring[static_cast<std::size_t>(spanning[n])]; }
};

namespace face_detail {

template <Real T>
[[nodiscard]] T doubled_area(const typename Face<T>::Corner& a, const typename Face<T>::Corner& b,
                             const typename Face<T>::Corner& c) {
    return (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
}

/// Of the spanning corners, on the texture.
template <Real T>
[[nodiscard]] T doubled_uv_area(const Face<T>& face) {
    const auto &a = face.corner(0), &b = face.corner(1), &c = face.corner(2);
    return (b.u - a.u) * (c.v - a.v) - (c.u - a.u) * (b.v - a.v);
}

/// rows · C⁻¹, where C has the given columns, by cofactors.
template <Real T>
[[nodiscard]] Matrix3<T> over_columns(const auto& trace, const Matrix3<T>& rows, const Matrix3<T>& columns,
                                      const std::array<Name, 9>& names, int line) {
    Matrix3<T> cofactors;
    for (int j = 0; j < 3; ++j) {
        const Row3<T>&a = columns[(j + 1) % 3], &b = columns[(j + 2) % 3];
        for (int m = 0; m < 3; ++m)
            cofactors[j][m] = trace(Name("A", 10 * (m + 1) + j + 1),
                                    a[(m + 1) % 3] * b[(m + 2) % 3] - a[(m + 2) % 3] * b[(m + 1) % 3], line);
    }
    const Row3<T>&c = columns[0], &d = cofactors[0];
    const T det = trace("det", c[0] * d[0] + c[1] * d[1] + c[2] * d[2], line);
    Matrix3<T> result;
    std::size_t entry = 0;
    for (int k = 0; k < 3; ++k) {
        for (int m = 0; m < 3; ++m) {
            const T sum = rows[k][0] * cofactors[0][m] + rows[k][1] * cofactors[1][m] + rows[k][2] * cofactors[2][m];
            result[k][m] = trace(names[entry++], sum / det, line);
        }
    }
    return result;
}

/// The columns (x W, y W, W) of the spanning corners.
template <Real T>
[[nodiscard]] Matrix3<T> on_screen(const auto& trace, const Face<T>& face, int line) {
    Matrix3<T> columns;
    for (int n = 0; n < 3; ++n) {
        const auto& p = face.corner(n);
        columns[n][0] = trace(Name("X", n), p.x * p.w, line);
        columns[n][1] = trace(Name("Y", n), p.y * p.w, line);
        columns[n][2] = p.w;
    }
    return columns;
}

}  // namespace face_detail

/// p x + q y + r: what a row of M or of its inverse is at a place.
template <Real T>
[[nodiscard]] T value_at(const Row3<T>& row, const T& x, const T& y) {
    return row[0] * x + row[1] * y + row[2];
}

/// Reads the corners. Fates: zero area, undefined, back face.
/// @param perspective  otherwise every w is 1: a parallelogram.
template <class Method>
[[nodiscard]] auto face_of(const Method& method, std::span<const Vertex> polygon, bool perspective,
                           int line = __builtin_LINE()) {
    using T = typename Method::Number;
    const auto& trace = method.trace;
    Face<T> face;
    face.ring.resize(polygon.size());
    face.outline.ring.resize(polygon.size());
    for (int n = 0; n < int(polygon.size()); ++n) {
        auto& p = face.ring[static_cast<std::size_t>(n)];
        p.x = trace(Name("x", n), Input<T>::from(polygon[n].x, method.mode), line);
        p.y = trace(Name("y", n), Input<T>::from(polygon[n].y, method.mode), line);
        p.u = trace(Name("u", n), Input<T>::from(polygon[n].u, method.mode), line);
        p.v = trace(Name("v", n), Input<T>::from(polygon[n].v, method.mode), line);
        p.w = trace(Name("w", n), Input<T>::from(perspective ? polygon[n].w : 1.0F, method.mode), line);
        face.outline.ring[static_cast<std::size_t>(n)] = {p.x, p.y};
    }
    face.spanning = trace.quiet([&] {
        std::array<int, 3> best{0, 1, 2};
        T widest = T(0);
        for (int n = 2; n < int(face.ring.size()); ++n) {
            const T area = face_detail::doubled_area<T>(face.ring[0], face.ring[n - 1], face.ring[n]);
            const T size = plain(area < 0) ? -area : area;
            if (plain(widest < size)) widest = size, best = {0, n - 1, n};
        }
        return best;
    });
    const T area = trace("area", face_detail::doubled_area<T>(face.corner(0), face.corner(1), face.corner(2)), line);
    if (plain(area == 0))
        face.fate = trace.fate(Fate::zero_area);
    else if (has_no_value(area))
        face.fate = trace.fate(Fate::undefined);
    else if (method.cull_back && plain(area < 0))
        face.fate = trace.fate(Fate::culled);
    return face;
}

/// The samples first, … up to but without last of a line of them, inside the frame.
template <Real T>
struct Samples {
    T at{};  ///< where the line lies: y of a row, x of a column [px]
    IntegerOf<T> first{}, last{};
    [[nodiscard]] bool empty() const { return plain(first >= last); }
};

/// The samples from `low` up to `high` that lie in [from, to), traced under the two names.
template <class Method, Real T>
void set_range(const Method& method, Samples<T>& s, Name first, Name last, const T& low, const T& high, int from,
               int to, int line) {
    using Int = IntegerOf<T>;
    s.first = method.trace(first, greater(ceil(low - T(1) / 2), Int(from)), line);
    s.last = method.trace(last, lesser(ceil(high - T(1) / 2), Int(to)), line);
}
/// The rows that an outline reaches, traced as first_row and last_row.
template <class Method, Real T>
[[nodiscard]] Samples<T> rows_of(const Method& method, const Outline<T>& outline, int line = __builtin_LINE()) {
    const auto rows = outline.rows();
    Samples<T> s;
    set_range(method, s, "first_row", "last_row", rows.low, rows.high, method.frame.y0, method.frame.y1, line);
    return s;
}
/// The columns that an outline reaches, traced as first_column and last_column.
template <class Method, Real T>
[[nodiscard]] Samples<T> columns_of(const Method& method, const Outline<T>& outline, int line = __builtin_LINE()) {
    const auto columns = outline.columns();
    Samples<T> s;
    set_range(method, s, "first_column", "last_column", columns.low, columns.high, method.frame.x0, method.frame.x1,
              line);
    return s;
}
/// The samples of row j inside an outline, traced as Y, x_l, x_r, first and last.
template <class Method, Real T>
[[nodiscard]] Samples<T> row_of(const Method& method, const Outline<T>& outline, const IntegerOf<T>& j,
                                int line = __builtin_LINE()) {
    Samples<T> s;
    s.at = method.trace("Y", T(j) + T(1) / 2, line);
    const auto span = outline.row(s.at);
    if (span.empty) return s;
    const T left = method.trace("x_l", span.from, line);
    const T right = method.trace("x_r", span.to, line);
    set_range(method, s, "first", "last", left, right, method.frame.x0, method.frame.x1, line);
    return s;
}
/// The samples of column i inside an outline, traced as X, y_t, y_b, first and last.
template <class Method, Real T>
[[nodiscard]] Samples<T> column_of(const Method& method, const Outline<T>& outline, const IntegerOf<T>& i,
                                   int line = __builtin_LINE()) {
    using Int = IntegerOf<T>;
    Samples<T> s;
    s.at = method.trace("X", T(i) + T(1) / 2, line);
    const auto span = outline.column(s.at);
    if (span.empty) return s;
    method.trace("y_t", span.from, line);
    method.trace("y_b", span.to, line);
    s.first = method.trace("first", greater(outline.first(span), Int(method.frame.y0)), line);
    s.last = method.trace("last", lesser(outline.last(span), Int(method.frame.y1)), line);
    return s;
}

/// The face on its texture [texels].
template <Real T>
[[nodiscard]] Outline<T> texture_outline(const Face<T>& face) {
    Outline<T> outline;
    for (const auto& p : face.ring) outline.ring.push_back({p.u, p.v});
    return outline;
}
/// Texels of the upright rectangle round the outline, at most 2^60.
template <Real T>
[[nodiscard]] Integer texels_in(const Outline<T>& on_texture) {
    constexpr Integer kMany = Integer{1} << 30;
    const auto rows = on_texture.rows(), columns = on_texture.columns();
    const Integer height = plain(ceil(rows.high)) - plain(floor(rows.low)) + 1;
    const Integer width = plain(ceil(columns.high)) - plain(floor(columns.low)) + 1;
    return lesser(width, kMany) * lesser(height, kMany);
}
/// A method that runs over texture space refuses a shape that repeats its texture more often than this.
[[nodiscard]] inline Integer most_texels(const Texture& texture) {
    constexpr Integer kRepeated = Integer{1} << 22;
    return greater(kRepeated, 2 * Integer{texture.width() + 2} * (texture.height() + 2));
}

/// For methods that run over all texels of a face: undefined where its corners lie on one line of the texture, too
/// large where it repeats the texture too often. Else written.
template <class Method, Real T>
[[nodiscard]] Fate texture_fate(const Method& method, const Face<T>& face, const Outline<T>& on_texture,
                                int line = __builtin_LINE()) {
    const T area = method.trace("texture_area", face_detail::doubled_uv_area(face), line);
    if (plain(area == 0)) return method.trace.fate(Fate::undefined);
    if (texels_in(on_texture) > most_texels(method.texture)) return method.trace.fate(Fate::too_large);
    return Fate::written;
}

/// M, its entries traced as m_11 … m_33. Without a value where the texture's corners lie on one line.
template <class Method, Real T>
[[nodiscard]] Matrix3<T> map_of(const Method& method, const Face<T>& face, int line = __builtin_LINE()) {
    const Matrix3<T> screen = face_detail::on_screen(method.trace, face, line);
    Matrix3<T> texture, rows;
    for (int n = 0; n < 3; ++n) {
        texture[n][0] = face.corner(n).u, texture[n][1] = face.corner(n).v, texture[n][2] = T(1);
        for (int k = 0; k < 3; ++k) rows[k][n] = screen[n][k];
    }
    constexpr std::array<Name, 9> kNames{Name("m", 11), Name("m", 12), Name("m", 13), Name("m", 21), Name("m", 22),
                                         Name("m", 23), Name("m", 31), Name("m", 32), Name("m", 33)};
    return face_detail::over_columns<T>(method.trace, rows, texture, kNames, line);
}

/// M⁻¹, its entries traced as a … i.
template <class Method, Real T>
[[nodiscard]] Matrix3<T> inverse_of(const Method& method, const Face<T>& face, int line = __builtin_LINE()) {
    Matrix3<T> rows;
    for (int n = 0; n < 3; ++n) rows[0][n] = face.corner(n).u, rows[1][n] = face.corner(n).v, rows[2][n] = T(1);
    constexpr std::array<Name, 9> kNames{"a", "b", "c", "d", "e", "f", "g", "h", "i"};
    const Matrix3<T> screen = face_detail::on_screen(method.trace, face, line);
    return face_detail::over_columns<T>(method.trace, rows, screen, kNames, line);
}

}  // namespace texelscope
