// The application with no display: for `shot`, `check` and the tests. It is the window's own code on the software
// platform, driven by an Input that is written by hand.
#pragma once

#include <memory>
#include <string>

#include "app/platform/software.h"
#include "app/shell/shell.h"

namespace texelscope {

class Headless {
public:
    static Result<std::unique_ptr<Headless>> start(State state, glm::vec2 size, ShellOptions options = {});

    /// One frame with the input as it stands; what was only pressed in it is then released from the input.
    void frame();
    /// Frames until the screen no longer changes: fades over, new fonts in use.
    void settle();
    [[nodiscard]] Image picture() const { return platform_.picture(); }

    ui::Input input;
    [[nodiscard]] Shell& shell() { return *shell_; }
    [[nodiscard]] Store& store() { return shell_->store(); }
    [[nodiscard]] const State& state() const { return shell_->state(); }
    [[nodiscard]] SoftwarePlatform& platform() { return platform_; }

private:
    Headless() = default;
    SoftwarePlatform platform_;
    std::unique_ptr<Shell> shell_;
};

/// A state to begin with: what `target` names, looked at as `look` says.
Result<State> state_of(const std::string& target, const Look& look);

}  // namespace texelscope
