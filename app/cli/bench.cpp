// texelscope bench FILE.tri: how long drawing takes, drawing alone.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "app/cli/bench_racer.h"
#include "app/cli/command.h"
#include "app/cli/draw_options.h"
#include "app/cli/output.h"
#include "app/cli/suggestion.h"
#include "core/base/file.h"
#include "core/geometry/snap.h"
#include "core/image/load.h"
#include "core/measure/timing.h"
#include "core/measure/workloads.h"
#include "core/scene/triangles_scene.h"

namespace texelscope::bench_command {
namespace {

constexpr int kLeastReps = 5, kMostReps = 1'000'000;
constexpr double kEnough = 0.5;     ///< of drawing each file, where nobody says how often [s]
constexpr double kSilence = 2;      ///< between two messages on stderr [s]
constexpr double kWarm = 0.05;      ///< so long each file is drawn first: until then threads may share a core [s]
constexpr std::uint64_t kSeed = 1;  ///< of workloads that are drawn by name

struct Options {
    DrawOptions draw;
    std::vector<std::string> files;
    std::string texture, output;
    int reps = 0;  ///< 0: until the median is stable
    bool stats = false, no_certificates = false;
};

[[nodiscard]] double seconds() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// The triangles in a file, or those of a workload's name where there is no such file.
Result<TrianglesFile> triangles_of(const std::string& target) {
    std::error_code ignored;
    if (std::filesystem::exists(target, ignored)) {
        const auto bytes = read_file(target, kMaxFileBytes);
        if (!bytes) return bytes.error();
        return parse_triangles(*bytes, target);
    }
    if (const Workload* workload = find_workload(target)) return workload->make(kSeed);
    std::vector<std::string_view> names;
    for (const Workload& workload : workloads()) names.push_back(workload.name);
    const std::string_view near = nearest_word(target, names);
    return Error{target, fmt::format("there is no such file, nor a workload of that name{}",
                                     near.empty() ? "" : fmt::format("; did you mean {}?", near))};
}

/// One file on its way.
struct Lane {
    std::string name;  ///< its stem
    std::size_t triangles = 0;
    std::unique_ptr<BenchRacer> racer;
    std::vector<double> times;  ///< [ms]
};

Result<Lane> lane_of(const std::string& target, const Options& options) {
    auto file = triangles_of(target);
    if (!file) return file.error();
    if (options.draw.snap) {
        for (Vertex& v : file->vertices) v.x = snap(v.x, *options.draw.snap), v.y = snap(v.y, *options.draw.snap);
        file->covered = 0;
    }
    Image texels;
    if (!options.texture.empty()) {
        auto image = load_image(options.texture);
        if (!image) return image.error();
        texels = *std::move(image);
    } else {
        texels = default_texels(*file);
    }
    Lane lane{.name = std::filesystem::path(target).stem().string(), .triangles = file->vertices.size() / 3};
    auto racer = make_racer(*std::move(file), std::move(texels), options.draw, !options.no_certificates, target);
    if (!racer) return racer.error();
    lane.racer = *std::move(racer);
    return lane;
}

/// What is done once is not measured.
void warm_up(Lane& lane) {
    const double start = seconds();
    do lane.racer->clear(), lane.racer->draw();
    while (seconds() - start < kWarm);
}

/// The lanes take turns, so that what disturbs the machine for a while disturbs all of them.
void race(std::vector<Lane>& lanes, int reps) {
    double drawing = 0, spoken = seconds();
    const auto is_over = [&](int round) {
        if (reps > 0) return round >= reps;
        return round >= kLeastReps && (drawing >= kEnough * static_cast<double>(lanes.size()) || round >= kMostReps);
    };
    for (int round = 0; !is_over(round); ++round)
        for (Lane& lane : lanes) {
            lane.racer->clear();
            const double start = seconds();
            lane.racer->draw();
            const double end = seconds();
            lane.times.push_back((end - start) * 1e3);
            drawing += end - start;
            if (end - spoken < kSilence) continue;
            spoken = end;
            std::fprintf(stderr, "texelscope: bench: %s, round %d of %d: %.4g ms\n", lane.name.c_str(), round + 1,
                         reps > 0 ? reps : kLeastReps, lane.times.back());
        }
}

std::optional<Error> write_picture(const Image& picture, const std::string& target) {
    const auto png = encode_png(picture);
    if (!png) return png.error();
    auto output = Output::open(target);
    if (!output) return output.error();
    output->write({reinterpret_cast<const char*>(png->data()), png->size()});
    return output->finish();
}

int run(const Options& options) {
    if (!options.output.empty() && options.files.size() > 1)
        return fail({"", fmt::format("-o with {} files, expected one file", options.files.size())});
    std::vector<Lane> lanes;
    for (const std::string& target : options.files) {
        auto lane = lane_of(target, options);
        if (!lane) return fail(lane.error());
        lanes.push_back(*std::move(lane));
    }
    for (Lane& lane : lanes) warm_up(lane);
    race(lanes, options.reps);
    auto lines = Output::open("");
    if (!lines) return fail(lines.error());
    for (const Lane& lane : lanes) {
        const TimedWork work{.method = options.draw.method,
                             .name = lane.name,
                             .threads = lane.racer->threads(),
                             .samples = lane.racer->samples(),
                             .triangles = lane.triangles};
        if (options.stats) std::fprintf(stderr, "%s\n", lane.racer->stats().c_str());
        lines->write(timing_line(work, timing_of(lane.times)) + "\n");
    }
    if (const auto error = lines->finish()) return fail(*error);
    if (options.output.empty()) return kExitDone;
    const auto error = write_picture(lanes[0].racer->picture(), options.output);
    return error ? fail(*error) : kExitDone;
}

std::function<int()> define(CLI::App& app) {
    const auto options = std::make_shared<Options>();
    options->draw.method = kFastMethod, options->draw.threads = 1;
    app.add_option("FILE", options->files, "triangles (.tri), or the name of a workload, see `texelscope workload`")
        ->required();
    app.add_option("--texture", options->texture, "an image; a pattern of the file's size if absent");
    app.add_option("--reps", options->reps, "how often each file is drawn; if absent, for half a second")
        ->check(CLI::Range(1, kMostReps))
        ->type_name("R");
    app.add_option("-o,--output", options->output, "what was drawn, as a PNG");
    app.add_flag("--stats", options->stats, "print how often fast made each decision, as JSON on stderr");
    app.add_flag("--no-certificates", options->no_certificates,
                 "let fast leave what lies in doubt as it is, to time what deciding costs; nothing else");
    add_draw_options(app, options->draw);
    return [options] { return run(*options); };
}

constexpr Subcommand kCommand{"bench", "time the drawing of triangles", define};
const RegisterCommand kRegistered(kCommand);

}  // namespace
}  // namespace texelscope::bench_command
