// texelscope stress: numerical stability, the families of hard input by every method against what is decided exactly.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "app/cli/command.h"
#include "app/cli/json_line.h"
#include "app/cli/output.h"
#include "core/measure/stress.h"
#include "core/measure/stress_methods.h"

namespace texelscope::stress_command {
namespace {

constexpr int kMostCount = 10'000'000;

struct Options {
    StressSettings settings;
    std::string family, output;
    bool json = false;
};

[[nodiscard]] std::string mode_name(const StressMode& mode) {
    return fmt::format("{} {}", mode.snapped ? "snapped" : "raw", mode.perspective ? "perspective" : "affine");
}
[[nodiscard]] bool is_fast(const StressRow& row) { return row.number.empty(); }

/// A column of the CSV, which is a member of the JSON.
struct Column {
    std::string_view name;
    std::string (*value)(const StressRow&);
    bool text = false;
};
[[nodiscard]] std::string number(double x) { return fmt::format("{:.4g}", x); }
[[nodiscard]] std::string number(std::int64_t n) { return std::to_string(n); }
[[nodiscard]] std::string number(std::uint64_t n) { return std::to_string(n); }

constexpr Column kColumns[] = {
    {"family", [](const StressRow& r) { return std::string(r.family->name); }, true},
    {"vertices", [](const StressRow& r) { return std::string(r.mode.snapped ? "snapped" : "raw"); }, true},
    {"mapping", [](const StressRow& r) { return std::string(r.mode.perspective ? "perspective" : "affine"); }, true},
    {"method", [](const StressRow& r) { return std::string(r.method); }, true},
    {"number", [](const StressRow& r) { return std::string(r.number); }, true},
    {"shapes", [](const StressRow& r) { return number(r.shapes); }},
    {"triangles", [](const StressRow& r) { return number(r.triangles); }},
    {"samples", [](const StressRow& r) { return number(r.samples); }},
    {"missing", [](const StressRow& r) { return number(r.missing); }},
    {"extra", [](const StressRow& r) { return number(r.extra); }},
    {"twice", [](const StressRow& r) { return number(r.twice); }},
    {"wrong_texels", [](const StressRow& r) { return number(r.wrong); }},
    {"meshes", [](const StressRow& r) { return number(r.meshes); }},
    {"leaky", [](const StressRow& r) { return number(r.leaky); }},
    {"worst", [](const StressRow& r) { return number(r.worst); }},
    {"p99", [](const StressRow& r) { return number(r.p99); }},
    {"mean", [](const StressRow& r) { return number(r.mean); }},
    {"bound", [](const StressRow& r) { return number(r.bound); }},
    {"exceeded", [](const StressRow& r) { return number(r.exceeded); }},
    {"together", [](const StressRow& r) { return number(r.together); }},
    {"not_served", [](const StressRow& r) { return number(r.not_served); }},
    {"crossings", [](const StressRow& r) { return number(r.counters.crossings); }},
    {"in_double", [](const StressRow& r) { return number(r.counters.in_double); }},
    {"in_whole", [](const StressRow& r) { return number(r.counters.in_whole); }},
    {"slow", [](const StressRow& r) { return number(r.counters.slow); }},
};

[[nodiscard]] std::string csv(const std::vector<StressRow>& rows) {
    std::string text;
    for (const Column& column : kColumns) text += fmt::format("{}{}", text.empty() ? "" : ",", column.name);
    for (const StressRow& row : rows) {
        text += '\n';
        for (const Column& column : kColumns)
            text += fmt::format("{}{}", &column == kColumns ? "" : ",", column.value(row));
    }
    return text + '\n';
}
[[nodiscard]] std::string json(const std::vector<StressRow>& rows) {
    std::string text;
    for (const StressRow& row : rows) {
        JsonLine line;
        for (const Column& column : kColumns) {
            if (column.text)
                line.text(column.name, column.value(row));
            else
                line.raw(column.name, json_number(column.value(row)));
        }
        text += line.line() + '\n';
    }
    return text;
}

/// Cells in columns, the first to the left and all others to the right.
[[nodiscard]] std::string table(const std::vector<std::vector<std::string>>& rows) {
    std::vector<std::size_t> widths;
    for (const auto& row : rows) {
        widths.resize(std::max(widths.size(), row.size()));
        for (std::size_t n = 0; n < row.size(); ++n) widths[n] = std::max(widths[n], row[n].size());
    }
    std::string text;
    for (const auto& row : rows) {
        for (std::size_t n = 0; n < row.size(); ++n)
            text += n == 0 ? fmt::format("{:<{}}", row[n], widths[n]) : fmt::format("  {:>{}}", row[n], widths[n]);
        text += '\n';
    }
    return text;
}

[[nodiscard]] std::string share(std::uint64_t part, std::int64_t all) {
    if (part == 0) return "0";
    return all == 0 ? "-" : fmt::format("{:.1e}", static_cast<double>(part) / static_cast<double>(all));
}

/// The fast rasterizer by family, its modes together.
[[nodiscard]] std::string fast_table(const std::vector<StressRow>& rows) {
    std::vector<std::vector<std::string>> cells{{"fast", "triangles", "samples", "missing", "extra", "twice", "wrong",
                                                 "together", "meshes", "leaky", "crossings", "in double", "in whole",
                                                 "slow", "not served"}};
    std::vector<StressRow> families;
    for (const StressRow& row : rows) {
        if (!is_fast(row)) continue;
        if (families.empty() || families.back().family != row.family) families.push_back({.family = row.family});
        StressRow& sum = families.back();
        sum.shapes += row.shapes, sum.triangles += row.triangles, sum.samples += row.samples;
        sum.missing += row.missing, sum.extra += row.extra, sum.twice += row.twice, sum.wrong += row.wrong;
        sum.together += row.together, sum.meshes += row.meshes, sum.leaky += row.leaky;
        sum.not_served += row.not_served;
        sum.counters.crossings += row.counters.crossings, sum.counters.slow += row.counters.slow;
        sum.counters.in_double += row.counters.in_double, sum.counters.in_whole += row.counters.in_whole;
    }
    for (const StressRow& r : families)
        cells.push_back({std::string(r.family->name), number(r.triangles), number(r.samples), number(r.missing),
                         number(r.extra), number(r.twice), number(r.wrong), number(r.together), number(r.meshes),
                         number(r.leaky), number(r.counters.crossings), share(r.counters.in_double, r.samples),
                         share(r.counters.in_whole, r.samples), number(r.counters.slow), number(r.not_served)});
    return families.empty() ? "" : table(cells) + '\n';
}

/// Methods in their number formats, all families and modes together; errors and bounds are those of the worst of them.
[[nodiscard]] std::string methods_table(const std::vector<StressRow>& rows) {
    struct Sum {
        StressRow row;
        const StressRow* worst = nullptr;
        double p99 = 0;
    };
    std::map<std::pair<std::string, std::string>, Sum> sums;
    for (const StressRow& row : rows) {
        if (is_fast(row)) continue;
        Sum& sum = sums[{std::string(row.method), std::string(row.number)}];
        sum.row.samples += row.samples, sum.row.missing += row.missing, sum.row.extra += row.extra;
        sum.row.twice += row.twice, sum.row.wrong += row.wrong, sum.row.meshes += row.meshes;
        sum.row.leaky += row.leaky, sum.row.exceeded += row.exceeded;
        if (sum.worst == nullptr || row.worst > sum.worst->worst) sum.worst = &row;
    }
    std::vector<std::vector<std::string>> cells{{"method", "number", "samples", "missing", "extra", "twice", "wrong",
                                                 "leaky", "meshes", "worst error", "p99 there", "bound there",
                                                 "exceeded", "worst in"}};
    for (const auto& [key, sum] : sums)
        cells.push_back({key.first, key.second, number(sum.row.samples), number(sum.row.missing), number(sum.row.extra),
                         number(sum.row.twice), number(sum.row.wrong), number(sum.row.leaky), number(sum.row.meshes),
                         number(sum.worst->worst), number(sum.worst->p99), number(sum.worst->bound),
                         number(sum.row.exceeded),
                         fmt::format("{}, {}", sum.worst->family->name, mode_name(sum.worst->mode))});
    return sums.empty() ? "" : table(cells) + '\n';
}

[[nodiscard]] std::string absentees() {
    std::string text;
    for (const StressedMethod& method : stressed_methods()) {
        if (method.affine && method.perspective) continue;
        text +=
            fmt::format("{} takes no part{}: {}.\n", method.id, method.affine ? " in perspective" : "", method.why_not);
    }
    return text;
}

[[nodiscard]] std::string faults(const std::vector<StressRow>& rows) {
    std::string text;
    for (const StressRow& row : rows)
        if (row.failed())
            text += fmt::format("FAILED {} {}, {}, {}: {}\n", row.method, row.number, row.family->name,
                                mode_name(row.mode), row.fault);
    return text;
}

int run(Options& options) {
    if (!options.family.empty()) options.settings.family = find_family(options.family);
    auto output = Output::open(options.output);
    if (!output) return fail(output.error());
    std::vector<StressRow> rows;
    stress(options.settings, [&](const StressRow& row) {
        if (rows.empty() || rows.back().family != row.family)
            std::fprintf(stderr, "%.*s\n", static_cast<int>(row.family->name.size()), row.family->name.data());
        rows.push_back(row);
    });
    const bool to_file = !options.output.empty() && options.output != "-";
    const std::string summary = fast_table(rows) + methods_table(rows) + absentees();
    if (options.json)
        output->write(json(rows));
    else
        output->write(to_file ? csv(rows) : summary);
    if (const auto error = output->finish()) return fail(*error);
    if (to_file) std::fputs(summary.c_str(), stdout);
    const std::string wrong = faults(rows);
    std::fputs(wrong.c_str(), stderr);
    return wrong.empty() ? kExitDone : kExitCheckFailed;
}

std::function<int()> define(CLI::App& app) {
    const auto options = std::make_shared<Options>();
    std::vector<std::string> names, ids;
    for (const Family& family : families()) names.emplace_back(family.name);
    for (const StressedMethod& method : stressed_methods())
        if (method.affine || method.perspective) ids.emplace_back(method.id);
    app.add_option("--seed", options->settings.seed, "of the random numbers")->capture_default_str();
    app.add_option("--count", options->settings.count,
                   "triangles of a family for `fast`; other methods draw at most a hundred, in exact numbers three")
        ->check(CLI::Range(1, kMostCount))
        ->capture_default_str();
    app.add_option("--method", options->settings.method, "this one alone")->check(CLI::IsMember(ids));
    app.add_option("--family", options->family, "this one alone")->check(CLI::IsMember(names));
    app.add_option("-o,--output", options->output, "a CSV with every family, mode and number format; stdout if -");
    app.add_flag("--json", options->json, "every family, mode and number format as JSON Lines");
    return [options] { return run(*options); };
}

constexpr Subcommand kCommand{"stress", "draw hard input by every method and compare with exact arithmetic", define};
const RegisterCommand kRegistered(kCommand);

}  // namespace
}  // namespace texelscope::stress_command
