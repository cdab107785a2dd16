// Readers of single JSON values that remember the first error, so that reading a scene needs no check at each value.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "core/base/result.h"
#include "core/scene/json_tree.h"

namespace texelscope {

/// One member of an object: what it is called, whether it must be there, and what to do with its value.
template <class Read>
struct Field {
    std::string_view key;
    bool required = false;
    Read read;
};
template <class Read>
Field<Read> required(std::string_view key, Read read) {
    return {key, true, std::move(read)};
}
template <class Read>
Field<Read> optional(std::string_view key, Read read) {
    return {key, false, std::move(read)};
}

/// "inf", "-inf", "nan", or a number in C's hexadecimal form such as "-0x1.8p+3", rounded to float32.
[[nodiscard]] std::optional<float> number_of_text(std::string_view text);

/// "a, b or c".
template <class Names>
[[nodiscard]] std::string any_of(const Names& names) {
    std::string out;
    for (std::size_t i = 0; i < names.size(); ++i)
        out += (i == 0 ? "" : i + 1 == names.size() ? " or " : ", ") + std::string(names[i]);
    return out;
}

class ValueReader {
public:
    explicit ValueReader(std::string_view name) : name_(name) {}

    [[nodiscard]] const std::optional<Error>& error() const { return error_; }
    [[nodiscard]] bool failed() const { return error_.has_value(); }
    /// "name:line".
    [[nodiscard]] std::string place(int line) const { return name_ + ":" + std::to_string(line); }
    /// Keeps the first error only.
    void fail(int line, std::string what) {
        if (!error_) error_ = Error{place(line), std::move(what)};
    }

    /// The readers below give a value of the type also after an error, which is then remembered.
    /// @param what  the value as messages call it: "width", "x of a vertex".
    [[nodiscard]] int whole(const JsonValue& value, std::string_view what, int low, int high);
    [[nodiscard]] float number(const JsonValue& value, std::string_view what);
    [[nodiscard]] std::string_view text(const JsonValue& value, std::string_view what);
    /// A finite number in [low, high].
    [[nodiscard]] float number_within(const JsonValue& value, std::string_view what, float low, float high);
    /// `count` numbers in [low, high].
    template <std::size_t count>
    [[nodiscard]] std::array<float, count> numbers_within(const JsonValue& value, std::string_view what, float low,
                                                          float high) {
        std::array<float, count> numbers{};
        if (value.kind() != JsonKind::array || value.size() != count) {
            wrong(value, what, "a list of " + std::to_string(count) + " numbers");
            return numbers;
        }
        std::size_t i = 0;
        for (const JsonValue item : value) numbers[i++] = number_within(item, what, low, high);
        return numbers;
    }
    /// `count` whole numbers.
    template <std::size_t count>
    [[nodiscard]] std::array<int, count> wholes(const JsonValue& value, std::string_view what, int low, int high) {
        std::array<int, count> numbers{};
        if (value.kind() != JsonKind::array || value.size() != count) {
            wrong(value, what, "a list of " + std::to_string(count) + " whole numbers");
            return numbers;
        }
        std::size_t i = 0;
        for (const JsonValue item : value) numbers[i++] = whole(item, what, low, high);
        return numbers;
    }
    /// The index among `names` of a text.
    template <class Names>
    [[nodiscard]] int choice(const JsonValue& value, std::string_view what, const Names& names) {
        if (value.kind() == JsonKind::text)
            for (std::size_t i = 0; i < names.size(); ++i)
                if (names[i] == value.text()) return static_cast<int>(i);
        wrong(value, what, any_of(names));
        return 0;
    }
    /// Calls the field of each member; no others may be there.
    template <class... Fields>
    void object(const JsonValue& value, std::string_view what, const Fields&... fields) {
        if (value.kind() != JsonKind::object) return wrong(value, what, "an object");
        const std::array<std::string_view, sizeof...(fields)> keys{fields.key...};
        std::array<bool, sizeof...(fields)> seen{};
        for (const JsonValue member : value) {
            std::size_t i = 0;
            bool known = false;
            const auto offer = [&](const auto& field) {
                if (field.key == member.key()) known = seen[i] = true, field.read(member);
                ++i;
            };
            (offer(fields), ...);
            if (!known)
                fail(member.key_line(), "key " + in_quotes(member.key()) + " of " + std::string(what) +
                                            " is not known, expected " + any_of(keys));
            if (failed()) return;
        }
        std::size_t i = 0;
        const auto demand = [&](const auto& field) {
            if (field.required && !seen[i])
                fail(value.line(), std::string(what) + " has no '" + std::string(field.key) + "'");
            ++i;
        };
        (demand(fields), ...);
    }
    /// Remembers that `what` is not as `expected`.
    void wrong(const JsonValue& value, std::string_view what, std::string_view expected);

private:
    std::string name_;
    std::optional<Error> error_;
};

}  // namespace texelscope
