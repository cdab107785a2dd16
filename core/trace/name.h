// The name of a traced value, kept in parts and joined only when it is printed.
#pragma once

#include <string>
#include <string_view>

namespace texelscope {

/// "u", {"u", "_x"} = "u_x", {"x", 0} = "x_0", Name::side("n_x", 1) = "n_x_B". Parts are string literals.
/// Underscores separate a base from its subscripts; the screen sets them as subscripts.
class Name {
public:
    constexpr Name() = default;
    constexpr Name(const char* base) : base_(base) {}  // NOLINT(google-explicit-constructor): trace("u", …) reads best
    constexpr Name(const char* base, const char* rest) : base_(base), rest_(rest) {}
    constexpr Name(const char* base, int index) : base_(base), index_(index) {}
    /// Of side 0, 1 or 2 of a triangle: A, B, C.
    [[nodiscard]] static constexpr Name side(const char* base, int side) {
        Name name(base);
        name.index_ = side;
        name.letter_ = true;
        return name;
    }

    [[nodiscard]] constexpr bool empty() const { return base_ == nullptr; }
    [[nodiscard]] std::string text() const {
        if (empty()) return {};
        std::string text(base_);
        if (rest_ != nullptr) text += rest_;
        if (index_ >= 0)
            text += '_', text += letter_ ? std::string(1, static_cast<char>('A' + index_)) : std::to_string(index_);
        return text;
    }

private:
    const char* base_ = nullptr;
    const char* rest_ = nullptr;
    int index_ = -1;
    bool letter_ = false;
};

}  // namespace texelscope
