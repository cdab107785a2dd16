// The number formats a method can be run with, and their names.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

namespace texelscope {

enum class NumberFormat : std::uint8_t { f64, f32, fx16_16, fx8_8, exact };

struct NumberFormatInfo {
    NumberFormat format;
    std::string_view id;     ///< on the command line and in lessons
    std::string_view title;  ///< for people
};

inline constexpr std::array<NumberFormatInfo, 5> kNumberFormats{{
    {NumberFormat::f64, "f64", "double: 53 bits and an exponent"},
    {NumberFormat::f32, "f32", "float: 24 bits and an exponent"},
    {NumberFormat::fx16_16, "fx16.16", "fixed point, 16 bits before the point and 16 behind it"},
    {NumberFormat::fx8_8, "fx8.8", "fixed point, 8 bits before the point and 8 behind it"},
    {NumberFormat::exact, "exact", "rational numbers of any size: no error at all"},
}};

[[nodiscard]] constexpr std::string_view id_of(NumberFormat format) {
    return kNumberFormats[static_cast<std::size_t>(format)].id;
}
[[nodiscard]] constexpr std::optional<NumberFormat> number_format(std::string_view id) {
    for (const NumberFormatInfo& info : kNumberFormats) {
        if (info.id == id) return info.format;
    }
    return std::nullopt;
}

}  // namespace texelscope
