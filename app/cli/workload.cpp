// texelscope workload NAME -o OUT.tri: triangles to time rasterizers with.
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "app/cli/command.h"
#include "app/cli/output.h"
#include "app/cli/suggestion.h"
#include "core/measure/workloads.h"

namespace texelscope::workload_command {
namespace {

constexpr std::uint64_t kJitterSeed = 0x9E3779B97F4A7C15;  ///< apart from those that people type
constexpr float kMaxJitter = 1024;                         ///< [px]

struct Options {
    std::string name, output;
    std::uint64_t seed = 1;
    float jitter = 0;  ///< [px]
    bool list = false;
};

[[nodiscard]] std::string list() {
    std::string text;
    for (const Workload& workload : workloads()) text += fmt::format("{:<21}{}\n", workload.name, workload.summary);
    return text;
}

[[nodiscard]] Error unknown(const std::string& name) {
    std::vector<std::string_view> names;
    for (const Workload& workload : workloads()) names.push_back(workload.name);
    const std::string_view near = nearest_word(name, names);
    return {"", fmt::format("workload '{}' is not known, expected one of {}{}", name, fmt::join(names, ", "),
                            near.empty() ? "" : fmt::format("; did you mean {}?", near))};
}

[[nodiscard]] std::string made(const Workload& workload, const Options& options) {
    TrianglesFile file = workload.make(options.seed);
    if (options.jitter > 0) jitter(file, options.jitter, options.seed ^ kJitterSeed);
    file.covered = covered_samples(file);
    return print_triangles(file);
}

int run(const Options& options) {
    const Workload* const workload = find_workload(options.name);
    if (workload == nullptr && !options.list) return fail(unknown(options.name));
    auto output = Output::open(options.output);
    if (!output) return fail(output.error());
    output->write(options.list ? list() : made(*workload, options));
    if (const auto error = output->finish()) return fail(*error);
    return kExitDone;
}

std::function<int()> define(CLI::App& app) {
    const auto options = std::make_shared<Options>();
    auto* const list = app.add_flag("--list", options->list, "print what workloads there are");
    app.add_option("NAME", options->name, "which triangles, see --list")->excludes(list);
    app.add_option("-o,--output", options->output, "the .tri file; stdout if absent or -");
    app.add_option("--seed", options->seed, "of the generator")->capture_default_str();
    app.add_option("--jitter", options->jitter, "move each corner by up to so many px along x and y, off the grid")
        ->check(CLI::Range(0.0F, kMaxJitter))
        ->type_name("PX");
    return [options] { return run(*options); };
}

constexpr Subcommand kCommand{"workload", "write triangles to time rasterizers with", define};
const RegisterCommand kRegistered(kCommand);

}  // namespace
}  // namespace texelscope::workload_command
