// `texelscope check`: whether every step, view, prediction and link of a lesson works.
#include <cstdio>

#include <CLI/CLI.hpp>

#include "app/cli/command.h"
#include "app/shell/check.h"

namespace texelscope::check_command {
namespace {

int check(const std::vector<std::string>& files) {
    int faulty = 0;
    for (const std::string& file : files) {
        const LessonCheck result = check_lesson(file);
        for (const Error& fault : result.faults) fail(fault);
        if (!result.faults.empty()) {
            ++faulty;
            continue;
        }
        std::printf("%s: %d beats, %d predictions, %d screens, no fault\n", file.c_str(), result.beats,
                    result.predictions, result.screens);
    }
    return faulty == 0 ? kExitDone : kExitCheckFailed;
}

std::function<int()> define(CLI::App& app) {
    auto files = std::make_shared<std::vector<std::string>>();
    app.add_option("LESSON.md", *files, "Lesson files")->required();
    return [files] { return check(*files); };
}

const Subcommand kCommand{"check", "Whether every step, view, prediction and link of a lesson works", define};
const RegisterCommand kRegistered(kCommand);

}  // namespace
}  // namespace texelscope::check_command
