// JSON text as a tree whose every value knows its line. json_tree.cpp is the only user of nlohmann.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"

namespace texelscope {

enum class JsonKind : std::uint8_t { null, boolean, number, text, array, object };

inline constexpr std::size_t kMaxJsonValues = std::size_t{1} << 23;  ///< the most values of one document
inline constexpr int kMaxJsonDepth = 32;                             ///< the deepest nesting

/// "a number", "a list", ...: a kind as messages call it.
[[nodiscard]] std::string_view json_kind_name(JsonKind kind);

/// 'text', cut to a length that fits a message and without control characters.
[[nodiscard]] std::string in_quotes(std::string_view text);

class JsonTree;

/// One value of a JsonTree, which must outlive it.
class JsonValue {
public:
    [[nodiscard]] JsonKind kind() const;
    [[nodiscard]] int line() const;               ///< where it begins; a member's key may be some lines above
    [[nodiscard]] double number() const;          ///< of a number
    [[nodiscard]] bool boolean() const;           ///< of a boolean
    [[nodiscard]] std::string_view text() const;  ///< of a text, escapes resolved; valid UTF-8, may hold any character
    [[nodiscard]] std::string_view key() const;   ///< of a member of an object
    [[nodiscard]] int key_line() const;           ///< of a member of an object

    /// Over the elements of a list or the members of an object, in the order of the text.
    class Iterator {
    public:
        Iterator(const JsonTree* tree, std::uint32_t at) : tree_(tree), at_(at) {}
        [[nodiscard]] JsonValue operator*() const { return {tree_, at_}; }
        Iterator& operator++();
        [[nodiscard]] bool operator!=(const Iterator& other) const { return at_ != other.at_; }

    private:
        const JsonTree* tree_;
        std::uint32_t at_;
    };
    [[nodiscard]] Iterator begin() const { return {tree_, at_ + 1}; }
    [[nodiscard]] Iterator end() const;
    [[nodiscard]] std::size_t size() const;  ///< how many; takes as many steps

private:
    friend class JsonTree;
    JsonValue(const JsonTree* tree, std::uint32_t at) : tree_(tree), at_(at) {}
    const JsonTree* tree_;
    std::uint32_t at_;
};

/// A document: its values in the order of the text, each followed by what it holds.
class JsonTree {
public:
    /// Fails with `name`:LINE for text that is not one JSON value, deeper nesting or more values than the bounds
    /// above, and a key that an object has twice.
    /// @param first_line  the number of the text's first line.
    static Result<JsonTree> parse(std::string_view text, std::string_view name, int first_line = 1);

    [[nodiscard]] JsonValue root() const { return {this, 0}; }

    struct Piece {
        std::uint32_t first = 0, size = 0;  ///< of `characters`
    };
    struct Node {
        JsonKind kind = JsonKind::null;
        std::int32_t line = 1, key_line = 1;
        std::uint32_t end = 0;  ///< the node after all that this one holds
        Piece key, text;
        double number = 0;
    };

private:
    friend class JsonValue;
    std::vector<Node> nodes_;
    std::string characters_;  ///< of all keys and texts
};

}  // namespace texelscope
