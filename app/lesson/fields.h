// Reads the keys of a TOML table one by one and remembers the first fault.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/lesson/lesson.h"
#include "app/lesson/toml_table.h"
#include "core/base/result.h"

namespace texelscope {

/// "a, b or c".
[[nodiscard]] std::string one_of(const std::vector<std::string_view>& names);

class Fields {
public:
    /// @param what  the table as messages call it: "the front matter".
    /// @param line  of the table's beginning, for keys that are missing.
    Fields(std::vector<TomlEntry> entries, const std::string& file, std::string_view what, int line)
        : entries_(std::move(entries)), file_(file), what_(what), line_(line) {}

    /// What stands under a key; nothing where the key is absent or of another type, which is then the fault.
    [[nodiscard]] std::optional<std::string> text(std::string_view key);
    [[nodiscard]] std::optional<bool> truth(std::string_view key);
    [[nodiscard]] std::optional<std::vector<std::string>> texts(std::string_view key);
    [[nodiscard]] std::optional<TomlSwitches> switches(std::string_view key);
    /// A text that must be there, and stand in its place: not empty, readable, at most `longest` letters.
    [[nodiscard]] std::string prose(std::string_view key, int longest);
    /// One of `names`; nothing where the key is absent.
    [[nodiscard]] std::optional<std::string> name_among(std::string_view key,
                                                        const std::vector<std::string_view>& names);

    /// Remembers that the value of `key` is wrong.
    void fail(std::string_view key, std::string_view what);
    void missing(std::string_view key);
    /// Remembers that a key is none of those that were asked for.
    void demand_known();
    [[nodiscard]] const std::optional<Error>& fault() const { return fault_; }
    [[nodiscard]] int line_of(std::string_view key) const;
    /// Those that are there.
    [[nodiscard]] KeyLines lines() const;

private:
    template <class T>
    [[nodiscard]] std::optional<T> take(std::string_view key, std::string_view kind);
    void fail_at(int line, std::string what);

    std::vector<TomlEntry> entries_;
    const std::string& file_;
    std::string_view what_;
    int line_;
    std::vector<std::string_view> asked_;
    std::optional<Error> fault_;
};

}  // namespace texelscope
