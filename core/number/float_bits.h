// A float32 as whole digits and an exponent.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>

namespace texelscope {

/// The exponent of the lowest bit of a finite number that is not 0.
[[nodiscard]] inline int lowest_exponent(float value) {
    constexpr int kDigits = 23, kBias = 127;
    std::uint32_t bits = 0;
    std::memcpy(&bits, &value, sizeof bits);
    const int exponent = static_cast<int>(bits >> kDigits & 255U);
    const std::uint32_t digits = (bits & ((1U << kDigits) - 1)) | (exponent > 0 ? 1U << kDigits : 0);
    return std::max(exponent, 1) - kBias - kDigits + std::countr_zero(digits);
}

}  // namespace texelscope
