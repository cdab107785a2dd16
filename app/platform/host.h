// What the application may ask of whatever runs it: a window, a test without a display, a browser.
#pragma once

#include <string>

#include "app/platform/texture_store.h"

namespace texelscope {

class Host {
public:
    Host() = default;
    Host(const Host&) = delete;
    Host& operator=(const Host&) = delete;
    virtual ~Host() = default;

    [[nodiscard]] virtual TextureStore& textures() = 0;

    /// Uses `atlas`, which is built or ready to be, from the next frame on. It must outlive its use; the one before may
    /// go as soon as the frame in progress has ended.
    virtual void set_fonts(ImFontAtlas& atlas) = 0;
    /// How much larger than usual the screen wants text [1 = 96 dots an inch].
    [[nodiscard]] virtual float content_scale() const = 0;

    /// Draws without pause until Input::time reaches `time`; else a frame is drawn only when something happens.
    virtual void wants_frames_until(double time) = 0;
    /// Draws a frame at `time`; replaces an earlier wish.
    virtual void wake_at(double time) = 0;
    /// Calls the platform's poll callback at this interval [s], and draws where it says so; 0 stops.
    virtual void poll_every(double seconds) = 0;

    [[nodiscard]] virtual bool fullscreen() const = 0;
    virtual void set_fullscreen(bool on) = 0;
    virtual void set_title(const std::string& title) = 0;
    [[nodiscard]] virtual std::string clipboard() = 0;
    virtual void set_clipboard(const std::string& text) = 0;
    /// Ends the run after this frame.
    virtual void close(int exit_code) = 0;
};

}  // namespace texelscope
