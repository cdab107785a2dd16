// The application on a host: reads input, draws the screen, dispatches actions, opens and saves files.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "app/platform/host.h"
#include "app/shell/documents.h"
#include "app/shell/measurer.h"
#include "app/shell/racer.h"
#include "app/state/request.h"
#include "app/state/store.h"
#include "app/ui/ui.h"

namespace texelscope {

struct ShellOptions {
    std::filesystem::path save_folder = ".";  ///< where Ctrl+S and Ctrl+E write
    ui::UiOptions ui;
    bool timed = false;  ///< as ViewContext's
};

class Shell {
public:
    /// Bakes the fonts that `state` asks for. Fails where a font is missing.
    static Result<std::unique_ptr<Shell>> start(Host& host, State state, std::vector<Lesson> lessons,
                                                ShellOptions options = {});

    /// One frame: draws the state, then dispatches what was done.
    void frame(const ui::Input& input);
    /// Reads changed files again; true where something new is to be drawn.
    bool poll();
    [[nodiscard]] Store& store() { return store_; }
    [[nodiscard]] const State& state() const { return store_.state(); }
    [[nodiscard]] const ui::FrameReport& report() const { return report_; }
    [[nodiscard]] ui::UiMemory& memory() { return memory_; }
    [[nodiscard]] const std::vector<Lesson>& lessons() const { return lessons_; }
    void dispatch(const Action& action) { store_.dispatch(action); }

private:
    Shell(Host& host, State state, std::vector<Lesson> lessons, ShellOptions options);
    [[nodiscard]] bool bake_fonts();
    void act(const ui::Input& input, const std::vector<Action>& actions, const std::vector<ShellRequest>& requests);
    void fulfil(const ShellRequest& request, const ui::Input& input);
    void drop(const std::string& file);
    void paste(const std::string& text);
    void save(const std::string& suffix, const std::string& bytes);
    void keep_time(const ui::Input& input, bool animated);
    void say(std::string text, bool error);
    /// Dispatches `action` if it is due, which it is `rate` times a second. @return when it is next [s].
    [[nodiscard]] double due(double now, double rate, double next, const Action& action);
    void remember_times();

    Host& host_;
    Store store_;
    std::vector<Lesson> lessons_;
    ShellOptions options_;
    ui::UiMemory memory_;
    ui::FrameReport report_;
    std::unique_ptr<ui::Fonts> fonts_, old_fonts_;
    std::string font_error_;
    glm::vec2 window_{1280, 720};  ///< of the last frame: while presenting type follows it
    std::vector<std::filesystem::file_time_type> times_;
    Racer racer_;
    Measurer measurer_;
    double next_step_ = 0;   ///< while playing [s]
    double next_frame_ = 0;  ///< while textures move [s]
    std::string title_;
};

}  // namespace texelscope
