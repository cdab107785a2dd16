#include "app/cli/command.h"

#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

namespace texelscope {
namespace {

std::vector<const Subcommand*>& registry() {
    static std::vector<const Subcommand*> registry;
    return registry;
}

bool is_before(const Subcommand* command, std::string_view name) { return command->name < name; }

/// Scripts read line by line: whatever a file name holds, a message is one line.
void print_line(std::string line) {
    for (char& c : line) {
        if (static_cast<unsigned char>(c) < ' ' || c == '\x7f') c = ' ';
    }
    std::fflush(stdout);
    std::fprintf(stderr, "%s\n", line.c_str());
}

}  // namespace

std::span<const Subcommand* const> commands() { return registry(); }

const Subcommand* find_command(std::string_view name) {
    const auto found = std::lower_bound(registry().begin(), registry().end(), name, is_before);
    return found != registry().end() && (*found)->name == name ? *found : nullptr;
}

RegisterCommand::RegisterCommand(const Subcommand& command) {
    registry().insert(std::lower_bound(registry().begin(), registry().end(), command.name, is_before), &command);
}

int fail(const Error& error) {
    print_line("texelscope: " + error.text());
    return kExitBadInput;
}

void warn(std::string_view what) { print_line("texelscope: warning: " + std::string(what)); }

}  // namespace texelscope
