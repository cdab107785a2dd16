#include "app/ui/color.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace texelscope::ui {
namespace {

using Triple = std::array<double, 3>;
using Matrix = std::array<Triple, 3>;

double linear(std::uint32_t byte) {
    const double c = byte / 255.0;
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

Triple linear_rgb(Color c) { return {linear(c & 0xFFU), linear((c >> 8U) & 0xFFU), linear((c >> 16U) & 0xFFU)}; }

Triple times(const Matrix& m, const Triple& v) {
    Triple out{};
    for (std::size_t i = 0; i < 3; ++i) out[i] = m[i][0] * v[0] + m[i][1] * v[1] + m[i][2] * v[2];
    return out;
}

double luminance(Color c) {
    const Triple v = linear_rgb(c);
    return 0.2126 * v[0] + 0.7152 * v[1] + 0.0722 * v[2];
}

constexpr Matrix kIdentity{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
constexpr Matrix kProtan{
    {{0.152286, 1.052583, -0.204868}, {0.114503, 0.786281, 0.099216}, {-0.003882, -0.048116, 1.051998}}};
constexpr Matrix kDeutan{
    {{0.367322, 0.860646, -0.227968}, {0.280085, 0.672501, 0.047413}, {-0.011820, 0.042940, 0.968881}}};
constexpr Matrix kTritan{
    {{1.255528, -0.076749, -0.178779}, {-0.078411, 0.930809, 0.147602}, {0.004733, 0.691367, 0.303900}}};

const Matrix& matrix_of(Sight sight) {
    switch (sight) {
        case Sight::protan: return kProtan;
        case Sight::deutan: return kDeutan;
        case Sight::tritan: return kTritan;
        case Sight::normal: break;
    }
    return kIdentity;
}

double degrees_of(double y, double x) {
    if (x == 0 && y == 0) return 0;
    const double h = std::atan2(y, x) * 180 / std::numbers::pi;
    return h < 0 ? h + 360 : h;
}

double radians(double degrees) { return degrees * std::numbers::pi / 180; }

}  // namespace

Color over(Color c, float alpha, Color ground) {
    Color out = 0xFF000000U;
    for (unsigned shift = 0; shift < 24; shift += 8) {
        const auto f = static_cast<float>((c >> shift) & 0xFFU), g = static_cast<float>((ground >> shift) & 0xFFU);
        out |= static_cast<std::uint32_t>(f * alpha + g * (1 - alpha) + 0.5F) << shift;
    }
    return out;
}

double contrast(Color a, Color b) {
    const double la = luminance(a) + 0.05, lb = luminance(b) + 0.05;
    return std::max(la, lb) / std::min(la, lb);
}

Lab seen(Color c, Sight sight) {
    Triple rgb = times(matrix_of(sight), linear_rgb(c));
    for (double& channel : rgb) channel = std::clamp(channel, 0.0, 1.0);
    static constexpr Matrix kToXyz{
        {{0.4124564, 0.3575761, 0.1804375}, {0.2126729, 0.7151522, 0.0721750}, {0.0193339, 0.1191920, 0.9503041}}};
    static constexpr Triple kWhite{0.95047, 1.0, 1.08883};
    Triple f = times(kToXyz, rgb);
    for (std::size_t i = 0; i < 3; ++i) {
        const double t = f[i] / kWhite[i];
        f[i] = t > 216.0 / 24389 ? std::cbrt(t) : (t * 24389 / 27 + 16) / 116;
    }
    return {116 * f[1] - 16, 500 * (f[0] - f[1]), 200 * (f[1] - f[2])};
}

double difference(const Lab& x, const Lab& y) {
    const double mean_c = (std::hypot(x.a, x.b) + std::hypot(y.a, y.b)) / 2;
    const double c7 = std::pow(mean_c, 7), k25 = std::pow(25.0, 7);
    const double g = 0.5 * (1 - std::sqrt(c7 / (c7 + k25)));
    const double a1 = (1 + g) * x.a, a2 = (1 + g) * y.a;
    const double c1 = std::hypot(a1, x.b), c2 = std::hypot(a2, y.b);
    const double h1 = degrees_of(x.b, a1), h2 = degrees_of(y.b, a2);

    double dh = 0, mean_h = h1 + h2;
    if (c1 * c2 != 0) {
        dh = h2 - h1;
        if (dh > 180) dh -= 360;
        if (dh < -180) dh += 360;
        const bool wraps = std::abs(h1 - h2) > 180;
        mean_h = (wraps ? h1 + h2 + (h1 + h2 < 360 ? 360 : -360) : h1 + h2) / 2;
    }
    const double dl = y.l - x.l, dc = c2 - c1, dhh = 2 * std::sqrt(c1 * c2) * std::sin(radians(dh / 2));
    const double ml = (x.l + y.l) / 2, mc = (c1 + c2) / 2;
    const double t = 1 - 0.17 * std::cos(radians(mean_h - 30)) + 0.24 * std::cos(radians(2 * mean_h)) +
                     0.32 * std::cos(radians(3 * mean_h + 6)) - 0.20 * std::cos(radians(4 * mean_h - 63));
    const double l50 = (ml - 50) * (ml - 50);
    const double sl = 1 + 0.015 * l50 / std::sqrt(20 + l50), sc = 1 + 0.045 * mc, sh = 1 + 0.015 * mc * t;
    const double mc7 = std::pow(mc, 7);
    const double turn = 30 * std::exp(-((mean_h - 275) / 25) * ((mean_h - 275) / 25));
    const double rt = -std::sin(radians(2 * turn)) * 2 * std::sqrt(mc7 / (mc7 + k25));
    const double l = dl / sl, c = dc / sc, h = dhh / sh;
    return std::sqrt(l * l + c * c + h * h + rt * c * h);
}

}  // namespace texelscope::ui
