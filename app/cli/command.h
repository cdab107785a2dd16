// What a subcommand is. One file each: it registers itself, and `texelscope --help` lists it unasked.
#pragma once

#include <functional>
#include <span>
#include <string_view>

#include "core/base/result.h"

namespace CLI {
class App;
}

namespace texelscope {

inline constexpr int kExitDone = 0;
inline constexpr int kExitCheckFailed = 1;
inline constexpr int kExitBadInput = 2;

struct Subcommand {
    std::string_view name, summary;
    /// Adds the options to `app`; what it returns does the work once they are read, and gives the exit code.
    std::function<int()> (*define)(CLI::App& app);
};

/// In order of their names. Filled before main by RegisterCommand.
[[nodiscard]] std::span<const Subcommand* const> commands();
/// Null where there is none of that name.
[[nodiscard]] const Subcommand* find_command(std::string_view name);

/// The command must live as long as the program.
struct RegisterCommand {
    explicit RegisterCommand(const Subcommand& command);
};

/// Prints "texelscope: FILE:LINE: what" as one line on stderr and gives the exit code for bad input.
int fail(const Error& error);
/// The same for what was drawn all the same.
void warn(std::string_view what);

}  // namespace texelscope
