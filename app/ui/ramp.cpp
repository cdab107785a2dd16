#include "app/ui/ramp.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace texelscope::ui {
namespace {

constexpr std::array<std::uint32_t, 11> kViridis{0x440154, 0x482475, 0x414487, 0x355F8D, 0x2A788E, 0x21918C,
                                                 0x22A884, 0x44BF70, 0x7AD151, 0xBDDF26, 0xFDE725};

}  // namespace

Color viridis(double t) {
    constexpr double kSteps = kViridis.size() - 1;
    const double at = t > 0 ? std::fmin(t, 1) * kSteps : 0;
    const auto low = std::min(static_cast<std::size_t>(at), kViridis.size() - 2);
    return over(hex(kViridis[low + 1]), static_cast<float>(at - static_cast<double>(low)), hex(kViridis[low]));
}

}  // namespace texelscope::ui
