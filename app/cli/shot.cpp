// `texelscope shot`: the whole window as a picture, needing neither display nor GPU.
#include <cstdio>
#include <optional>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "app/cli/command.h"
#include "app/shell/headless.h"
#include "app/state/lesson_cursor.h"
#include "core/base/file.h"
#include "core/image/load.h"

namespace texelscope::shot_command {
namespace {

constexpr int kSmallest = 320, kLargest = 8192;  ///< a side of the window [px]

struct ShotOptions {
    std::string target, size = "1280x720", theme = "dark", step, overlay, output;
    float scale = 1;
    std::optional<int> beat;  ///< counted from 1
    bool present = false;
};

/// "1280x720".
Result<glm::vec2> size_from(const std::string& text) {
    int width = 0, height = 0;
    char rest = 0;
    const bool read = std::sscanf(text.c_str(), "%5dx%5d%c", &width, &height, &rest) == 2;
    if (!read || width < kSmallest || height < kSmallest || width > kLargest || height > kLargest) {
        return Error{"--size", "'" + text + "', expected WIDTHxHEIGHT of 320 to 8192 pixels, such as 1280x720"};
    }
    return glm::vec2(static_cast<float>(width), static_cast<float>(height));
}

/// Goes to a beat as PgDn does.
std::optional<Error> go_to_beat(Store& store, int beat) {
    const int beats = beat_count(store.state());
    if (beats == 0) return Error{"--beat", fmt::format("{}, but a scene has no beats, expected a lesson", beat)};
    if (beat < 1 || beat > beats) return Error{"--beat", fmt::format("{}, expected 1 to {}", beat, beats)};
    store.dispatch(action::Advance{beat - 1 - store.state().cursor.beat});
    return std::nullopt;
}

int shoot(const ShotOptions& options) {
    const auto size = size_from(options.size);
    if (!size) return fail(size.error());
    Look look;
    look.theme = options.theme == "light" ? Theme::light : Theme::dark;
    look.scale = options.scale;
    look.presenting = options.present;
    look.reduced_motion = true;
    auto state = state_of(options.target, look);
    if (!state) return fail(state.error());
    auto app = Headless::start(*std::move(state), *size);
    if (!app) return fail(app.error());
    if (options.beat) {
        if (const auto error = go_to_beat((*app)->store(), *options.beat)) return fail(*error);
    }
    if (!options.step.empty()) {
        const auto path = parse_path(options.step);
        if (!path) return fail({"--step", "'" + options.step + "' is no step, expected one such as t0/s5/y11/x7/e2"});
        (*app)->store().dispatch(action::StepTo{*path});
    }
    if (options.overlay == "lessons") (*app)->store().dispatch(action::Show{Overlay::lessons});
    if (options.overlay == "keys") (*app)->store().dispatch(action::Show{Overlay::keys});
    (*app)->settle();
    const auto png = encode_png((*app)->picture());
    if (!png) return fail(png.error());
    if (const auto error = write_file_atomically(options.output, *png)) return fail(*error);
    return kExitDone;
}

std::function<int()> define(CLI::App& app) {
    auto options = std::make_shared<ShotOptions>();
    app.add_option("target", options->target, "A lesson (number, id or file), a scene file, or a state's line")
        ->required();
    app.add_option("--size", options->size, "Of the window [px]")->capture_default_str();
    app.add_option("--scale", options->scale, "Of text")->check(CLI::Range(1.0, 2.5))->capture_default_str();
    app.add_option("--theme", options->theme)->check(CLI::IsMember({"dark", "light"}))->capture_default_str();
    app.add_option("--beat", options->beat, "Go to this beat of the lesson first, counted from 1")->type_name("N");
    app.add_option("--step", options->step, "Go to this step first (after --beat), such as t0/s5/y11/x7");
    app.add_option("--show", options->overlay, "Open this panel")->check(CLI::IsMember({"lessons", "keys"}));
    app.add_flag("--present", options->present, "As for a projector");
    app.add_option("-o,--output", options->output, "The PNG file")->required();
    return [options] { return shoot(*options); };
}

const Subcommand kCommand{"shot", "The whole window as a picture", define};
const RegisterCommand kRegistered(kCommand);

}  // namespace
}  // namespace texelscope::shot_command
