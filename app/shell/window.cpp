// Opens the window on what the command line asked for; without a display it leaves a picture instead.
#include <algorithm>
#include <cstdio>

#include "app/cli/command.h"
#include "app/cli/window_request.h"
#include "app/platform/window.h"
#include "app/shell/headless.h"
#include "core/base/file.h"
#include "core/image/load.h"

namespace texelscope {
namespace {

constexpr std::string_view kOpeningPicture = "texelscope.png";

[[nodiscard]] Look look_of(const WindowRequest& request) {
    Look look;
    look.scale = std::clamp(static_cast<float>(request.scale.value_or(1)), 1.0F, 2.5F);
    look.presenting = request.present;
    look.theme = request.theme == "light" ? Theme::light : Theme::dark;
    return look;
}

Result<State> state_of(const WindowRequest& request) {
    auto state = state_of(request.target.empty() ? request.lesson : request.target, look_of(request));
    if (!state || request.step.empty()) return state;
    const auto path = parse_path(request.step);
    if (!path) return Error{"--step", "'" + request.step + "' is no step, expected one such as t0/s5/y11/x7/e2"};
    Derived derived;
    derived.update(*state);
    return reduce(*state, action::StepTo{*path}, derived);
}

/// For machines without a display: the opening screen as a file.
int leave_picture(const State& state, const Error& why) {
    auto app = Headless::start(state, {1280, 720});
    if (!app) return fail(app.error());
    (*app)->settle();
    const auto png = encode_png((*app)->picture());
    if (!png) return fail(png.error());
    if (const auto error = write_file_atomically(kOpeningPicture, *png)) return fail(*error);
    std::fprintf(stderr, "texelscope: %s; the opening screen is in %s instead\n", why.text().c_str(),
                 kOpeningPicture.data());
    return kExitDone;
}

}  // namespace

int open_window(const WindowRequest& request) {
    auto state = state_of(request);
    if (!state) return fail(state.error());
    std::unique_ptr<Shell> shell;
    std::optional<Error> broken;
    const auto start = [&](Host& host) {
        std::vector<Error> faulty;
        auto started = Shell::start(host, *state, built_in_lessons(faulty), {.timed = true});
        for (const Error& fault : faulty) warn(fault.text());
        if (started) {
            shell = *std::move(started);
            return;
        }
        broken = started.error();
        host.close(kExitBadInput);
    };
    const auto frame = [&](const ui::Input& input, Host&) {
        if (shell) shell->frame(input);
    };
    const auto poll = [&] { return shell && shell->poll(); };
    const auto code = run_window({}, {frame, poll, start});
    if (broken) return fail(*broken);
    return code ? *code : leave_picture(*state, code.error());
}

}  // namespace texelscope
