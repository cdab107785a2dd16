// A small TOML table as a lesson has it, key by key with its line: texts, switches, lists of texts, tables of switches.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "core/base/result.h"

namespace texelscope {

using TomlSwitches = std::vector<std::pair<std::string, bool>>;  ///< in the order of the text

struct TomlEntry {
    std::string key;
    int line = 0;  ///< of the file
    std::variant<std::string, bool, std::vector<std::string>, TomlSwitches> value;
};

/// The entries in the order of the text. Anything else than the kinds above is an error.
/// @param file        what errors call the file.
/// @param first_line  the file's line on which `text` begins.
Result<std::vector<TomlEntry>> parse_toml_table(std::string_view text, const std::string& file, int first_line);

}  // namespace texelscope
