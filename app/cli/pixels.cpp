// texelscope pixels SCENE: one CSV row for every sample drawn, in drawing order.
#include <cmath>
#include <iterator>
#include <memory>
#include <string>

#include <fmt/compile.h>
#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "app/cli/command.h"
#include "app/cli/draw_options.h"
#include "app/cli/output.h"
#include "app/cli/scene_stream.h"

namespace texelscope::pixels_command {
namespace {

constexpr std::size_t kBlock = 1 << 16;  ///< written at once [bytes]

struct Options {
    DrawOptions draw;
    std::string scene, output;
    bool lines = false;
};

class Rows {
public:
    Rows(Output& output, bool numbered) : output_(&output), numbered_(numbered) {
        if (numbered) block_.append(std::string_view("scene,"));
        block_.append(std::string_view("polygon,x,y,u,v,texel_x,texel_y,r,g,b,note\n"));
    }
    void sample(int scene, int polygon, const Sample& s) {
        if (s.fate != Fate::written) return;
        auto at = std::back_inserter(block_);
        if (numbered_) fmt::format_to(at, FMT_COMPILE("{},"), scene);
        // The sign of a NaN is nobody's: processors differ in it.
        const double u = std::isnan(s.u) ? std::abs(s.u) : s.u, v = std::isnan(s.v) ? std::abs(s.v) : s.v;
        fmt::format_to(at, FMT_COMPILE("{},{},{},{:.17g},{:.17g},{},{},{},{},{},{}\n"), polygon, s.x, s.y, u, v,
                       s.column, s.row, s.colour.r, s.colour.g, s.colour.b, text_of(s.note));
        if (block_.size() >= kBlock) flush();
    }
    void flush() {
        output_->write({block_.data(), block_.size()});
        block_.clear();
    }

private:
    Output* output_;
    bool numbered_;
    fmt::memory_buffer block_;
};

int run(const Options& options) {
    const auto settings = draw_settings(options.draw);
    if (!settings) return fail(settings.error());
    auto scenes =
        SceneStream::open(options.scene, options.lines ? SceneStream::Lines::always : SceneStream::Lines::if_there);
    if (!scenes) return fail(scenes.error());
    auto output = Output::open(options.output);
    if (!output) return fail(output.error());
    Rows rows(*output, scenes->has_lines());
    bool begun = false;
    while (!output->failed()) {
        auto item = scenes->next();
        if (!item) {
            if (begun) rows.flush();
            return fail(item.error());
        }
        if (!*item) break;
        begun = true;
        print_warnings((*item)->loaded);
        Scene& scene = (*item)->loaded.scene;
        snap_scene(scene, options.draw);
        const Drawing drawing(scene, *settings);
        each_sample(drawing, 0, drawing.shape_count(), {scene.framebuffer.rect(), 1},
                    [&](int shape, const Sample& s) { rows.sample((*item)->number, drawing.polygon_of(shape), s); });
    }
    rows.flush();
    if (const auto error = output->finish()) return fail(*error);
    return kExitDone;
}

std::function<int()> define(CLI::App& app) {
    const auto options = std::make_shared<Options>();
    app.add_option("SCENE", options->scene, "scene file, or JSON Lines with one scene a line; - for stdin")->required();
    app.add_option("-o,--output", options->output, "the CSV; stdout if absent or -");
    app.add_flag("--lines", options->lines, "JSON Lines even if it is a single line");
    add_draw_options(app, options->draw);
    return [options] { return run(*options); };
}

constexpr Subcommand kCommand{"pixels", "print every sample drawn as CSV", define};
const RegisterCommand kRegistered(kCommand);

}  // namespace
}  // namespace texelscope::pixels_command
