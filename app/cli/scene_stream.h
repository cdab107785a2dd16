// Reads SCENE, a file or `-` for stdin: one scene, or JSON Lines of which only one is held at a time.
#pragma once

#include <cstdio>
#include <memory>
#include <optional>
#include <string>

#include "app/cli/draw_options.h"
#include "core/base/result.h"
#include "core/scene/json.h"

namespace texelscope {

class SceneStream {
public:
    enum class Lines { never, if_there, always };
    /// @param lines  whether the file may hold, or holds, one scene a line.
    static Result<SceneStream> open(const std::string& target, Lines lines);

    /// Whether it is JSON Lines.
    [[nodiscard]] bool has_lines() const { return has_lines_; }
    struct Item {
        int number = 0;  ///< the line, from 0
        LoadedScene loaded;
    };
    /// The next scene; nothing after the last.
    Result<std::optional<Item>> next();

private:
    struct Closer {
        void operator()(std::FILE* file) const {
            if (file != stdin) std::fclose(file);
        }
    };
    struct Line {
        int number = 0;
        std::string text;
    };
    SceneStream() = default;
    /// The next line that is not blank; nothing at the end.
    Result<std::optional<Line>> line();
    /// Appends to `text` up to the end of the line; false at the end of the file.
    Result<bool> read_line(std::string& text);
    std::optional<Error> read_rest(std::string& text);
    [[nodiscard]] Error failure() const;

    std::unique_ptr<std::FILE, Closer> file_;
    std::string name_;
    SceneFiles files_;
    bool has_lines_ = false, done_ = false;
    std::string whole_;                   ///< of a single scene
    std::optional<Line> first_, second_;  ///< read ahead
    int lines_read_ = 0;
};

/// The one scene in a file or on stdin, snapped as asked; warnings go to stderr.
Result<Scene> read_scene(const std::string& target, const DrawOptions& options);
void print_warnings(const LoadedScene& loaded);

}  // namespace texelscope
