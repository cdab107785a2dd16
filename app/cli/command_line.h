// The whole program as one call: subcommands, the window, help and usage errors.
#pragma once

namespace texelscope {

/// @return  0 on success, 1 on a failed check, 2 on bad usage or bad input.
[[nodiscard]] int run_command_line(int argc, const char* const* argv);

}  // namespace texelscope
