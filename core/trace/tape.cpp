#include "core/trace/tape.h"

#include <fmt/format.h>

namespace texelscope {
namespace {

std::string text_of_double(double x, int digits) {
    if (std::isnan(x)) return "nan";
    if (std::isinf(x)) return x < 0 ? "-inf" : "inf";
    return fmt::format("{:.{}g}", x, digits);
}

/// A fixed-point value has finitely many decimals: all of them.
std::string text_of_raw(std::int64_t raw, int fraction_bits) {
    const bool negative = raw < 0;
    const std::uint64_t size = negative ? 0 - static_cast<std::uint64_t>(raw) : static_cast<std::uint64_t>(raw);
    const std::uint64_t mask = (std::uint64_t{1} << fraction_bits) - 1;
    std::string text = fmt::format("{}{}", negative ? "-" : "", size >> fraction_bits);
    std::uint64_t rest = size & mask;
    if (rest != 0) text += '.';
    for (; rest != 0; rest &= mask) {
        rest *= 10;
        text += static_cast<char>('0' + (rest >> fraction_bits));
    }
    return text;
}

std::string text_of_value(bool x) { return x ? "true" : "false"; }
std::string text_of_value(Integer x) { return std::to_string(x); }
std::string text_of_value(double x) { return text_of_double(x, 17); }
std::string text_of_value(float x) { return text_of_double(static_cast<double>(x), 9); }
template <int I, int F>
std::string text_of_value(const Fixed<I, F>& x) {
    return text_of_raw(x.raw(), F);
}
std::string text_of_value(const Exact& x) { return x.is_undefined() ? "nan" : x.value().str(); }

double approximate_value(bool x) { return x ? 1 : 0; }
double approximate_value(Integer x) { return static_cast<double>(x); }
template <class T>
double approximate_value(const T& x) {
    return approximate(x);
}

}  // namespace

std::int32_t Tape::push(Op op, Value value, std::int32_t a, std::int32_t b, std::int32_t c) {
    operations.push_back({op, a, b, c, std::move(value)});
    return static_cast<std::int32_t>(operations.size()) - 1;
}

double approximate(const Value& value) {
    return std::visit([](const auto& x) { return approximate_value(x); }, value);
}

std::string full_text(const Value& value) {
    return std::visit([](const auto& x) { return text_of_value(x); }, value);
}

bool overflowed(const Value& value) {
    if (const auto* x = std::get_if<Fixed16>(&value)) return x->overflowed();
    if (const auto* x = std::get_if<Fixed8>(&value)) return x->overflowed();
    return false;
}

bool undefined(const Value& value) { return std::isnan(approximate(value)); }

}  // namespace texelscope
