// texelscope front: run time against error for every method and number format.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <imgui.h>
#include <unistd.h>
#include <CLI/CLI.hpp>

#include "app/cli/command.h"
#include "app/cli/output.h"
#include "app/platform/software.h"
#include "app/shell/documents.h"
#include "app/state/front_key.h"
#include "app/state/lesson_cursor.h"
#include "app/state/store.h"
#include "app/views/front_plot.h"
#include "core/base/file.h"
#include "core/image/load.h"

namespace texelscope::front_command {
namespace {

constexpr int kLeastRounds = 5, kMostRounds = 1000;
constexpr std::size_t kMostCsv = 16U << 20U;  ///< the longest file that is read back [bytes]
constexpr double kSlice = 0.2;                ///< between two lines of progress [s]
constexpr glm::vec2 kPicture{1600, 1000};     ///< [px]
constexpr float kScale = 1.25F, kMargin = 18, kTitle = 34;
constexpr std::string_view kHeading = "Run time against error";
constexpr std::string_view kSubheading =
    "the same triangles drawn in every way, against exact arithmetic; below and left is better";

constexpr std::string_view kFootnote =
    "Errors are of the greater of u and v, in texels; wrong: owned samples with another texel; –: no bound published.\n"
    "Methods and kernels are definitions: scalar, one triangle after the other, into 24-bit pixels. `exact` and what\n"
    "computes with fractions draw a scene's first triangles only. `fast` takes the whole list, into 32-bit pixels.\n";

struct Options {
    std::vector<std::string> scenes, outputs;
    std::string from, target, theme = "dark";
    int rounds = 9;
    std::uint64_t seed = 1;
};

[[nodiscard]] std::string scene_ids() {
    std::string ids;
    for (const FrontSceneInfo& scene : front_scenes()) ids += (ids.empty() ? "" : ", ") + std::string(scene.id);
    return ids;
}

/// "csv" or "png"; empty for anything else.
[[nodiscard]] std::string kind_of(const std::string& file) {
    const std::string kind = std::filesystem::path(file).extension().string();
    return kind == ".csv" || kind == ".png" ? kind.substr(1) : std::string();
}

std::vector<FrontPoint> run_all(FrontOptions front) {
    FrontRun run(std::move(front));
    const bool live = isatty(fileno(stderr)) != 0;
    while (!run.advance(kSlice))
        if (live) std::fprintf(stderr, "\r\033[K%3.0f %%  %s", 100 * run.share(), run.doing().c_str());
    if (live) std::fprintf(stderr, "\r\033[K");
    return run.points();
}

/// The scene of a file, or those of a lesson's beats, each once.
Result<std::vector<FrontPoint>> measure_own(const Options& options) {
    const auto state = open_state(options.target, {});
    if (!state) return state.error();
    Store store(*state);
    std::vector<std::string> done;
    std::vector<FrontPoint> points;
    for (int beat = 0; beat < std::max(1, beat_count(*state)); ++beat) {
        if (beat > 0) store.dispatch(action::Advance{1});
        const Scene& scene = store.derived().scene();
        const std::string key = front_key(scene, store.state().work);
        if (std::find(done.begin(), done.end(), key) != done.end()) continue;
        done.push_back(key);
        FrontOptions front = default_front();
        front.rounds = options.rounds;
        front.own.emplace(key, front_scene_of(scene));
        const std::vector<FrontPoint> found = run_all(std::move(front));
        points.insert(points.end(), found.begin(), found.end());
    }
    return points;
}

Result<std::vector<FrontPoint>> measure(const Options& options) {
    if (!options.target.empty()) return measure_own(options);
    FrontOptions front = default_front();
    front.rounds = options.rounds, front.seed = options.seed;
    if (!options.scenes.empty()) front.scenes.clear();
    for (const std::string& id : options.scenes) {
        const FrontSceneInfo* const scene = find_front_scene(id);
        if (scene == nullptr) return Error{"--scenes", "'" + id + "', expected some of " + scene_ids()};
        if (std::find(front.scenes.begin(), front.scenes.end(), scene) != front.scenes.end())
            return Error{"--scenes", "'" + id + "' twice, expected each once"};
        front.scenes.push_back(scene);
    }
    return run_all(std::move(front));
}

/// The fastest first.
[[nodiscard]] std::string table_of(std::vector<FrontPoint> points) {
    std::string table;
    while (!points.empty()) {
        const std::string scene = points.front().scene;
        const auto rest =
            std::stable_partition(points.begin(), points.end(), [&](const FrontPoint& p) { return p.scene == scene; });
        std::sort(points.begin(), rest, [](const FrontPoint& a, const FrontPoint& b) { return a.min_ns < b.min_ns; });
        const FrontSceneInfo* const info = find_front_scene(scene);
        table += fmt::format("{}: {}\n{:<32}{:>11}{:>11}{:>9}{:>8}{:>10}{:>10}{:>10}{:>10}{:>10}  {}\n", scene,
                             info != nullptr ? info->summary : "", "rung", "ns a pixel", "least", "missing", "extra",
                             "wrong", "greatest", "99 %", "mean", "bound", "beaten by");
        for (auto p = points.begin(); p != rest; ++p)
            table += fmt::format("{:<32}{:>11.2f}{:>11.2f}{:>9}{:>8}{:>9.4f}%{:>10}{:>10}{:>10}{:>10}  {}\n", p->rung,
                                 p->median_ns, p->min_ns, p->missing, p->extra, 100 * p->wrong_rate(),
                                 front_number(p->max_error), front_number(p->p99_error), front_number(p->mean_error),
                                 front_number(p->bound), p->dominated_by.empty() ? "" : p->dominated_by);
        table += "\n";
        points.erase(points.begin(), rest);
    }
    table += kFootnote;
    return table;
}

Result<Image> picture_of(std::span<const FrontPoint> points, bool light) {
    auto fonts = ui::Fonts::bake({.scale = kScale});
    if (!fonts) return fonts.error();
    const ui::Theme theme = ui::make_theme(light ? ui::ThemeName::light : ui::ThemeName::dark);
    SoftwarePlatform platform;
    platform.set_fonts(fonts->atlas());
    ui::UiMemory memory;
    ui::Input input;
    input.size = kPicture;
    platform.frame(input, [&] {
        ui::Ui ui(memory, input, *fonts, theme, *ImGui::GetBackgroundDrawList());
        const ui::Area all{0, 0, kPicture.x, kPicture.y};
        ui::fill(ui.list(), all, theme.panel);
        ui.set_ground(theme.panel);
        ui::Area area = all.inset(ui.px(kMargin), ui.px(kMargin));
        const float width = ui.text(ui::Face::lesson_title, {area.x, area.y + ui.px(14)}, ui::Role::text, kHeading);
        ui.text(ui::Face::note, {area.x + width + ui.px(14), area.y + ui.px(14)}, ui::Role::muted, kSubheading);
        area.y += ui.px(kTitle), area.h -= ui.px(kTitle);
        (void)draw_front_plot(ui, area, points);
        ui.end();
    });
    return platform.picture();
}

std::optional<Error> save(const std::string& file, std::span<const FrontPoint> points, bool light) {
    if (kind_of(file) == "csv") {
        auto output = Output::open(file);
        if (!output) return output.error();
        output->write(print_front(points));
        return output->finish();
    }
    const auto picture = picture_of(points, light);
    if (!picture) return picture.error();
    const auto png = encode_png(*picture);
    if (!png) return png.error();
    return write_file_atomically(file, *png);
}

int run(const Options& options) {
    for (const std::string& file : options.outputs)
        if (kind_of(file).empty())
            return fail({"--output", "'" + file + "', expected a name that ends in .csv or .png"});
    if (!options.target.empty() && !(options.from.empty() && options.scenes.empty()))
        return fail({options.target, "given together with --scenes or --from, expected only one of them"});
    if (!options.from.empty() && !options.scenes.empty())
        return fail({"--from", "given together with --scenes, expected only one: its scenes are in the file"});
    Result<std::vector<FrontPoint>> points = Error{};
    if (options.from.empty()) {
        points = measure(options);
    } else {
        const auto text = read_file(options.from, kMostCsv);
        points = text ? parse_front(*text, options.from) : Result<std::vector<FrontPoint>>(text.error());
    }
    if (!points) return fail(points.error());
    auto output = Output::open("");
    if (!output) return fail(output.error());
    output->write(table_of(*points));
    if (const auto error = output->finish()) return fail(*error);
    for (const std::string& file : options.outputs)
        if (const auto error = save(file, *points, options.theme == "light")) return fail(*error);
    return kExitDone;
}

std::function<int()> define(CLI::App& app) {
    const auto options = std::make_shared<Options>();
    app.add_option("SCENE", options->target, "a lesson or a scene to measure in place of the built-in ones")
        ->type_name("LESSON or SCENE");
    app.add_option("--scenes", options->scenes, "some of " + scene_ids() + "; the first four if absent")
        ->delimiter(',');
    app.add_option("--reps", options->rounds, "rounds in which every rung is timed in turn")
        ->check(CLI::Range(kLeastRounds, kMostRounds))
        ->capture_default_str();
    app.add_option("--seed", options->seed, "of the scenes' triangles")
        ->check(CLI::NonNegativeNumber)
        ->capture_default_str();
    app.add_option("-o,--output", options->outputs, "a .csv with every figure, or a .png; may be given twice")
        ->type_name("FILE");
    app.add_option("--from", options->from, "draw what an earlier run wrote as .csv, in place of measuring")
        ->type_name("CSV");
    app.add_option("--theme", options->theme, "of the .png")
        ->check(CLI::IsMember({"dark", "light"}))
        ->capture_default_str();
    return [options] { return run(*options); };
}

constexpr Subcommand kCommand{"front", "run time against error for every method and number format", define};
const RegisterCommand kRegistered(kCommand);

}  // namespace
}  // namespace texelscope::front_command
