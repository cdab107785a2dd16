// The methods that are stressed, what they draw, and the bound of error that each must keep.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "core/method/method.h"

namespace texelscope {

struct StressedMethod {
    std::string_view id;
    bool affine = false, perspective = false;  ///< defines the same mapping as the exact triangle there
    std::string_view why_not;                  ///< where it does not
};
/// Every method is among them.
[[nodiscard]] std::span<const StressedMethod> stressed_methods();

struct DrawnSample {
    Integer x = 0, y = 0;
    double u = 0, v = 0;              ///< before wrapping [texels]
    int column = 0, row = 0;          ///< after it
    double u_bound = 0, v_bound = 0;  ///< the most that u and v may be off: core/measure/bounded.h; infinite: no bound
};

/// The written samples of one triangle, in drawing order. Corrected methods in number formats that round come with the
/// bounds.
[[nodiscard]] std::vector<DrawnSample> drawn_samples(const Method& method, NumberFormat format, const Job& job);

}  // namespace texelscope
