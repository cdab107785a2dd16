#include "core/method/two_pass_buffer.h"

#include <cmath>

#include "core/method/run.h"
#include "core/method/two_pass_quirks.h"

namespace texelscope {
namespace {

/// The first stages of TwoPass::draw, by its own functions.
template <class M>
[[nodiscard]] TwoPassBuffer first_pass_of(const M& method, std::span<const Vertex> polygon) {
    using T = typename M::Number;
    TwoPassBuffer made;
    const Face<T> face = face_of(method, polygon, true);
    if (face.fate != Fate::written) return made;
    const Outline<T> on_texture = texture_outline(face);
    if (plain(face_detail::doubled_uv_area(face) == 0)) return made;
    if (plain(texels_in(on_texture) > most_texels(method.texture))) return made;
    const Matrix3<T> map = map_of(method, face);
    auto tmp = method.empty_buffer(face, on_texture);
    if (tmp.u.empty()) return made;
    method.quirk.forward ? method.first_pass_forward(on_texture, map, tmp) : method.first_pass(map, tmp);
    made.x0 = tmp.x0, made.x1 = tmp.x1, made.v0 = tmp.v0, made.v1 = tmp.v1;
    made.u = std::move(tmp.u);

    const auto rows = on_texture.rows();
    const T middle = (rows.low + rows.high) / 2;
    const auto span = on_texture.row(middle);
    const auto column = [&](const T& u) {
        const T w = map[2][0] * u + map[2][1] * middle + map[2][2];
        return approximate((map[0][0] * u + map[0][1] * middle + map[0][2]) / w);
    };
    made.width = span.empty ? 0 : std::abs(column(span.to) - column(span.from));
    made.texels = span.empty ? 0 : approximate(span.to) - approximate(span.from);
    return made;
}

}  // namespace

TwoPassBuffer two_pass_buffer(NumberFormat format, const Job& job) {
    return run::with_type(format, [&](auto type) {
        return first_pass_of(run::make<TwoPass, decltype(type)>(job, kTwoPassFields, NoTrace{}), job.corners);
    });
}

}  // namespace texelscope
