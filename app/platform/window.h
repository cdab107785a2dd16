// The platform with a window: GLFW and OpenGL 3.3. It sleeps while nothing happens.
#pragma once

#include <functional>
#include <string>

#include "app/platform/host.h"
#include "app/ui/input.h"
#include "core/base/result.h"

namespace texelscope {

struct WindowOptions {
    std::string title = "Texelscope";
    int width = 1280, height = 720;  ///< [px], brought into [64, 16384]
    bool fullscreen = false;
};

struct WindowCallbacks {
    /// Draws a frame with ImGui. Called twice after each event, so that what a first frame changes is shown by a
    /// second. Sizes and positions are pixels of the framebuffer.
    std::function<void(const ui::Input&, Host&)> frame;
    /// Whether something outside has changed, such as a file; called only where Host::poll_every asks for it.
    std::function<bool()> poll = [] { return false; };
    /// Called once, before the first frame.
    std::function<void(Host&)> start = [](Host&) {};
};

/// Opens a window and runs until it is closed or Host::close is called. Returns the exit code, 0 for a closed window.
/// Fails  with no display, or no OpenGL 3.3: then there still is SoftwarePlatform.
Result<int> run_window(const WindowOptions& options, const WindowCallbacks& callbacks);

}  // namespace texelscope
