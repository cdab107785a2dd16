// A value, or the reason why there is none. For files, images and what people typed; broken preconditions
// are TEXELSCOPE_ASSERT's, and degenerate geometry is an ordinary value.
#pragma once

#include <string>
#include <utility>
#include <variant>

#include "core/base/assert.h"

namespace texelscope {

/// Says which input, what was wrong and what was expected, in one line that is fit for a person.
struct Error {
    std::string where;  ///< "scene.json:12", "lesson.md:3"; empty where the input is a single word
    std::string what;   ///< "wrap is 'mirror', expected repeat, mask or clamp"

    /// "where: what", or just "what".
    [[nodiscard]] std::string text() const { return where.empty() ? what : where + ": " + what; }
};

template <class T>
class [[nodiscard]] Result {
public:
    Result(T value) : state_(std::in_place_index<0>, std::move(value)) {}      // NOLINT(google-explicit-constructor)
    Result(Error error) : state_(std::in_place_index<1>, std::move(error)) {}  // NOLINT(google-explicit-constructor)

    [[nodiscard]] explicit operator bool() const { return state_.index() == 0; }
    [[nodiscard]] const T& operator*() const& { return value(); }
    [[nodiscard]] T& operator*() & { return const_cast<T&>(value()); }
    [[nodiscard]] T&& operator*() && { return std::move(const_cast<T&>(value())); }
    [[nodiscard]] const T* operator->() const { return &value(); }
    [[nodiscard]] T* operator->() { return const_cast<T*>(&value()); }
    [[nodiscard]] const Error& error() const {
        TEXELSCOPE_ASSERT(!*this);
        return *std::get_if<1>(&state_);
    }

private:
    [[nodiscard]] const T& value() const {
        TEXELSCOPE_ASSERT(*this);
        return *std::get_if<0>(&state_);
    }
    std::variant<T, Error> state_;
};

}  // namespace texelscope
