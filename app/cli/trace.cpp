// texelscope trace SCENE: the steps of a drawing as JSON Lines.
#include <algorithm>
#include <charconv>
#include <memory>
#include <string>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "app/cli/command.h"
#include "app/cli/draw_options.h"
#include "app/cli/json_line.h"
#include "app/cli/operands.h"
#include "app/cli/output.h"
#include "app/cli/scene_stream.h"
#include "app/cli/trace_steps.h"
#include "core/trace/expression.h"

namespace texelscope::trace_command {
namespace {

struct Options {
    DrawOptions draw;
    std::string scene, output, pixel, level = "expression";
};

/// Reads "X,Y".
std::optional<Place> place_from(const std::string& text) {
    Place place;
    const char* const end = text.data() + text.size();
    const auto x = std::from_chars(text.data(), end, place.x);
    if (x.ec != std::errc() || x.ptr == end || *x.ptr != ',') return std::nullopt;
    const auto y = std::from_chars(x.ptr + 1, end, place.y);
    if (y.ec != std::errc() || y.ptr != end) return std::nullopt;
    return place;
}

/// The unit's own fate, and for a sample that the depth test decides, that.
std::optional<Fate> fate_of(const Drawing& drawing, const Visit& visit) {
    const int shape = static_cast<int>(visit.path.parts[0].index);
    if (visit.path.depth() == 1) return visit.shape_fate;
    std::optional<Fate> fate = visit.unit().fate;
    const auto place = place_of(visit);
    if (fate != Fate::written || !place || drawing.scene().depth == Depth::off) return fate;
    const Rect pixel{static_cast<int>(place->x), static_cast<int>(place->y), static_cast<int>(place->x) + 1,
                     static_cast<int>(place->y) + 1};
    each_sample(drawing, 0, shape + 1, {pixel, 1}, [&](int n, const Sample& s) {
        if (n == shape) fate = s.fate;
    });
    return fate;
}

class StepPrinter {
public:
    StepPrinter(Steps& steps, Output& output) : steps_(steps), output_(output) {}

    /// False once the output has failed.
    bool print(const Path& path) {
        const Visit& visit = steps_.at(path);
        JsonLine line;
        line.text("path", path.text()).text("level", id_of(level_of(path)));
        if (path.at_expression())
            add_expression(line, visit, visit.unit().expressions[static_cast<std::size_t>(path.parts.back().index)]);
        else if (path.depth() == 2)
            line.text("name", visit.stages[static_cast<std::size_t>(path.parts[1].index)].name);
        add_place(line, visit);
        output_.write(line.line() + '\n');
        return !output_.failed();
    }

private:
    static Level level_of(const Path& path) {
        return path.at_expression() ? Level::expression : static_cast<Level>(std::min(path.depth(), kLevels - 1) - 1);
    }
    static void add_expression(JsonLine& line, const Visit& visit, std::int32_t index) {
        const Named& named = visit.tape.names[static_cast<std::size_t>(index)];
        const Value& value = visit.tape.operations[static_cast<std::size_t>(named.operation)].value;
        line.text("name", named.name.text()).text("formula", formula(visit.tape, named));
        line.text("substituted", substituted(visit.tape, named)).raw("operands", operands_json(visit.tape, named));
        line.raw("value", value_json(value)).text("type", type_name(value));
        if (overflowed(value)) line.raw("overflow", "true");
        line.number("line", named.line);
    }
    void add_place(JsonLine& line, const Visit& visit) {
        if (visit.path != known_.path) {
            known_ = {visit.path, place_of(visit), fate_of(steps_.drawing(), visit), {}};
            const auto column = value_of(visit, "column"), row = value_of(visit, "row");
            if (column && row) known_.texel = fmt::format("[{},{}]", full_text(*column), full_text(*row));
        }
        if (known_.place) line.raw("pixel", fmt::format("[{},{}]", known_.place->x, known_.place->y));
        if (!known_.texel.empty()) line.raw("texel", known_.texel);
        if (known_.fate) line.text("fate", text_of(*known_.fate));
    }

    struct Known {
        Path path;
        std::optional<Place> place;
        std::optional<Fate> fate;
        std::string texel;
    };
    Steps& steps_;
    Output& output_;
    Known known_;  ///< of the last unit: its expressions share it
};

int run(const Options& options) {
    const auto settings = draw_settings(options.draw);
    if (!settings) return fail(settings.error());
    const auto level = level_from(options.level);
    if (!level)
        return fail({"", "--level '" + options.level + "', expected triangle, stage, scanline, pixel or expression"});
    const auto place = place_from(options.pixel);
    if (!options.pixel.empty() && !place)
        return fail({"", "--pixel '" + options.pixel + "', expected X,Y in whole pixels"});
    const auto scene = read_scene(options.scene, options.draw);
    if (!scene) return fail(scene.error());
    const Rect frame = scene->framebuffer.rect();
    if (place && !frame.contains(place->x, place->y))
        return fail({"", fmt::format("--pixel {},{} lies outside the picture, expected {} to {}, {} to {}", place->x,
                                     place->y, frame.x0, frame.x1 - 1, frame.y0, frame.y1 - 1)});
    auto output = Output::open(options.output);
    if (!output) return fail(output.error());
    const Drawing drawing(*scene, *settings);
    Steps steps(drawing);
    StepPrinter printer(steps, *output);
    const OnStep on_step = [&](const Path& path) { return printer.print(path); };
    if (place)
        each_step_at(steps, *level, *place, on_step);
    else
        each_step(steps, *level, on_step);
    if (const auto error = output->finish()) return fail(*error);
    return kExitDone;
}

std::function<int()> define(CLI::App& app) {
    const auto options = std::make_shared<Options>();
    app.add_option("SCENE", options->scene, "scene file, or - for stdin")->required();
    app.add_option("-o,--output", options->output, "the JSON Lines; stdout if absent or -");
    app.add_option("--pixel", options->pixel, "only the steps that lead to this pixel")->type_name("X,Y");
    app.add_option("--level", options->level, "triangle, stage, scanline, pixel or expression")->capture_default_str();
    add_draw_options(app, options->draw);
    return [options] { return run(*options); };
}

constexpr Subcommand kCommand{"trace", "print the steps of a drawing as JSON Lines", define};
const RegisterCommand kRegistered(kCommand);

}  // namespace
}  // namespace texelscope::trace_command
