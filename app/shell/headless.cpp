#include "app/shell/headless.h"

#include "app/platform/scripted_input.h"

namespace texelscope {
namespace {

constexpr int kSettling = 12;  ///< frames that outlast any fade

}  // namespace

Result<std::unique_ptr<Headless>> Headless::start(State state, glm::vec2 size, ShellOptions options) {
    std::unique_ptr<Headless> app(new Headless);
    std::vector<Error> faulty;
    std::vector<Lesson> lessons = built_in_lessons(faulty);
    auto shell = Shell::start(app->platform_, std::move(state), std::move(lessons), std::move(options));
    if (!shell) return shell.error();
    app->shell_ = *std::move(shell);
    app->input.size = size;
    return app;
}

void Headless::frame() {
    platform_.frame(input, [&] { shell_->frame(input); });
    input = next_frame(input);
}

void Headless::settle() {
    for (int n = 0; n < kSettling; ++n) frame();
}

Result<State> state_of(const std::string& target, const Look& look) {
    State before;
    before.look = look;
    return open_state(target.empty() ? "1" : target, before);
}

}  // namespace texelscope
