// texelscope render SCENE -o OUT.png: the picture.
#include <array>
#include <cstdio>
#include <memory>
#include <string>

#include <CLI/CLI.hpp>

#include "app/cli/command.h"
#include "app/cli/draw_options.h"
#include "app/cli/json_line.h"
#include "app/cli/output.h"
#include "app/cli/scene_stream.h"
#include "core/image/load.h"
#include "core/image/reduce.h"

namespace texelscope::render_command {
namespace {

struct Options {
    DrawOptions draw;
    std::string scene, output;
    int reduce = 1;
    bool stats = false;
};

/// How many shapes ended how. The window is empty: only what comes before the loop over pixels is computed.
std::string stats_line(const Drawing& drawing) {
    std::array<int, static_cast<std::size_t>(Fate::undefined) + 1> counts{};
    for (int n = 0; n < drawing.shape_count(); ++n) {
        Fate fate = drawing.refusal(n);
        if (fate == Fate::written && !drawing.touches(n, drawing.scene().framebuffer.rect())) fate = Fate::off_screen;
        if (fate == Fate::written)
            fate =
                drawing.settings().method->samples(drawing.settings().format, drawing.job(n), {}, [](const Sample&) {});
        ++counts[static_cast<std::size_t>(fate)];
    }
    JsonLine line;
    line.number("shapes", drawing.shape_count()).number("drawn", counts[static_cast<std::size_t>(Fate::written)]);
    for (const Fate fate : {Fate::zero_area, Fate::culled, Fate::off_screen, Fate::not_finite, Fate::behind_eye})
        line.number(text_of(fate), counts[static_cast<std::size_t>(fate)]);
    return line.line();
}

int run(const Options& options) {
    const auto settings = draw_settings(options.draw);
    if (!settings) return fail(settings.error());
    const auto scene = read_scene(options.scene, options.draw);
    if (!scene) return fail(scene.error());
    const Drawing drawing(*scene, *settings);
    Image picture = render(drawing);
    if (options.reduce == 2) picture = reduced_by_2(picture);
    const auto png = encode_png(picture);
    if (!png) return fail(png.error());
    auto output = Output::open(options.output);
    if (!output) return fail(output.error());
    output->write({reinterpret_cast<const char*>(png->data()), png->size()});
    if (const auto error = output->finish()) return fail(*error);
    if (options.stats) std::fprintf(stderr, "%s\n", stats_line(drawing).c_str());
    return kExitDone;
}

std::function<int()> define(CLI::App& app) {
    const auto options = std::make_shared<Options>();
    app.add_option("SCENE", options->scene, "scene file, or - for stdin")->required();
    app.add_option("-o,--output", options->output, "the PNG; stdout if absent or -");
    app.add_option("--reduce", options->reduce, "draw, then make the picture half as large with a triangle filter")
        ->check(CLI::IsMember({2}));
    app.add_flag("--stats", options->stats, "print how many shapes were drawn and skipped, as JSON on stderr");
    add_draw_options(app, options->draw);
    return [options] { return run(*options); };
}

constexpr Subcommand kCommand{"render", "draw a scene's picture as a PNG", define};
const RegisterCommand kRegistered(kCommand);

}  // namespace
}  // namespace texelscope::render_command
