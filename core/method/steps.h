// Walks the step tree of a drawing: any step is reached directly, forward and back alike. Nothing is stored but
// the last few visits; the tree's children are ranges that the method itself gives.
#pragma once

#include <cstddef>
#include <list>
#include <memory>
#include <optional>

#include "core/method/drawing.h"

namespace texelscope {

/// Steps at a level are its units, and those coarser ones that have no finer parts.
class Steps {
public:
    /// The drawing must outlive it.
    explicit Steps(const Drawing& drawing) : drawing_(&drawing) {}

    [[nodiscard]] std::optional<Path> first(Level level);
    [[nodiscard]] std::optional<Path> last(Level level);
    [[nodiscard]] std::optional<Path> next(const Path& path, Level level);
    [[nodiscard]] std::optional<Path> previous(const Path& path, Level level);
    /// The step at `level` that `path` lies in, or the first one inside it.
    [[nodiscard]] Path at_level(const Path& path, Level level);
    /// `path` itself where it exists, else the nearest earlier step there is.
    [[nodiscard]] std::optional<Path> nearest(const Path& path, Level level);
    /// The step in which shape `shape` comes to sample (x, y): the last of its passes that visits it. Nothing where
    /// none does.
    [[nodiscard]] std::optional<Path> at_pixel(int shape, Integer x, Integer y);
    /// The unit of a path, from memory where it was asked for lately.
    [[nodiscard]] const Visit& at(const Path& path);
    [[nodiscard]] const Drawing& drawing() const { return *drawing_; }

private:
    [[nodiscard]] std::optional<Path> by_texel(const Path& stage, Integer x, Integer y);
    [[nodiscard]] Path first_in(const Path& unit, Level level);
    [[nodiscard]] Path last_in(const Path& unit, Level level);
    [[nodiscard]] std::optional<Path> after(const Path& unit, Level level);
    [[nodiscard]] std::optional<Path> before(const Path& unit, Level level);

    const Drawing* drawing_;
    std::list<std::unique_ptr<Visit>> visits_;  ///< newest first
};

}  // namespace texelscope
