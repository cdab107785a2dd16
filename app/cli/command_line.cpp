#include "app/cli/command_line.h"

#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <memory>
#include <new>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "app/cli/command.h"
#include "app/cli/suggestion.h"
#include "app/cli/window_request.h"
#include "core/trace/path.h"

namespace texelscope {
namespace {

using Arguments = std::vector<std::string>;

/// Reads `arguments` and runs `work`; help and usage errors end here.
int parse_and_run(CLI::App& app, Arguments arguments, const std::function<int()>& work) {
    std::reverse(arguments.begin(), arguments.end());  // as CLI11 takes them
    try {
        app.parse(arguments);
    } catch (const CLI::CallForHelp&) {
        std::fputs(app.help().c_str(), stdout);
        return kExitDone;
    } catch (const CLI::CallForVersion&) {
        std::puts(app.version().c_str());
        return kExitDone;
    } catch (const CLI::ParseError& error) {
        return fail({"", fmt::format("{} (see {} --help)", error.what(), app.get_name())});
    }
    return work();
}

std::string overview() {
    std::string text = "\nSubcommands (each has --help):\n";
    for (const Subcommand* command : commands()) text += fmt::format("  {:<26}{}\n", command->name, command->summary);
    return text;
}

int run_window(const Arguments& arguments) {
    WindowRequest request;
    CLI::App app("Texelscope: every step of a texture mapper, in a window.", "texelscope");
    app.footer(overview());
    app.add_option("target", request.target, "LESSON.md, SCENE.json, or a state's line \"texelscope:1:...\"");
    app.add_option("--lesson", request.lesson, "a lesson's id, see `texelscope list lessons`");
    app.add_option("--step", request.step, "go to a step, as in t0/s3/y11/x7/e2");
    app.add_flag("--present", request.present, "fill the screen, for a projector");
    app.add_option("--scale", request.scale, "size of everything")->check(CLI::Range(0.5, 4.0));
    app.add_option("--theme", request.theme, "colours")->check(CLI::IsMember({"dark", "light"}));
    return parse_and_run(app, arguments, [&] {
        if (!request.target.empty() && !request.lesson.empty())
            return fail({"", "--lesson " + request.lesson + " beside " + request.target + ", expected one of them"});
        if (!request.step.empty() && !parse_path(request.step))
            return fail({"", "--step '" + request.step + "' is not a step, expected one such as t0/s3/y11/x7/e2"});
        return open_window(request);
    });
}

int run_command(const Subcommand& command, const Arguments& arguments) {
    CLI::App app(std::string(command.summary), "texelscope " + std::string(command.name));
    return parse_and_run(app, arguments, command.define(app));
}

/// Whether a word can only be meant as a subcommand: no lesson, file or state is written like it.
bool is_command_word(const std::string& word) {
    std::error_code ignored;
    return word.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ_-") == std::string::npos &&
           !std::filesystem::exists(word, ignored);
}

int no_such_command(const std::string& word) {
    std::vector<std::string_view> names;
    for (const Subcommand* command : commands()) names.push_back(command->name);
    const std::string_view near = nearest_word(word, names);
    const std::string hint = near.empty() ? fmt::format("expected {}, or a file", fmt::join(names, ", "))
                                          : fmt::format("did you mean '{}'?", near);
    return fail({"", fmt::format("there is no subcommand '{}': {}", word, hint)});
}

int run(const Arguments& arguments) {
    if (arguments.empty() || arguments[0].empty() || arguments[0][0] == '-') return run_window(arguments);
    if (const Subcommand* command = find_command(arguments[0]))
        return run_command(*command, {arguments.begin() + 1, arguments.end()});
    if (is_command_word(arguments[0])) return no_such_command(arguments[0]);
    return run_window(arguments);
}

}  // namespace

int run_command_line(int argc, const char* const* argv) {
    try {
        return run(Arguments(argv + std::min(argc, 1), argv + argc));
    } catch (const std::bad_alloc&) {
        return fail({"", "out of memory"});
    } catch (const std::exception& error) {
        return fail({"", error.what()});
    }
}

}  // namespace texelscope
