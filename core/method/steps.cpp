#include "core/method/steps.h"

#include <algorithm>
#include <cmath>

namespace texelscope {
namespace {

constexpr std::size_t kRemembered = 12;

[[nodiscard]] int depth_of(Level level) { return static_cast<int>(level) + 1; }
[[nodiscard]] bool has_rounds(const Unit& unit) { return unit.loop && unit.loop->count() > 0; }
[[nodiscard]] Integer last_round(const Loop& loop) { return loop.first + (loop.count() - 1) * loop.step; }
[[nodiscard]] int expressions(const Unit& unit) { return static_cast<int>(unit.expressions.size()); }

}  // namespace

const Visit& Steps::at(const Path& path) {
    const Path unit = path.unit();
    const auto found =
        std::find_if(visits_.begin(), visits_.end(), [&](const auto& visit) { return visit->path == unit; });
    if (found != visits_.end()) {
        visits_.splice(visits_.begin(), visits_, found);
        return *visits_.front();
    }
    visits_.push_front(std::make_unique<Visit>(visit(*drawing_, unit)));
    if (visits_.size() > kRemembered) visits_.pop_back();
    return *visits_.front();
}

std::optional<Path> Steps::first(Level level) {
    if (drawing_->shape_count() == 0) return std::nullopt;
    return first_in(Path{{{'t', 0}}}, level);
}

std::optional<Path> Steps::last(Level level) {
    if (drawing_->shape_count() == 0) return std::nullopt;
    return last_in(Path{{{'t', drawing_->shape_count() - 1}}}, level);
}

Path Steps::first_in(const Path& unit, Level level) {
    const bool fine = level == Level::expression;
    if (!fine && unit.depth() >= depth_of(level)) return unit;
    const Visit& visit = at(unit);
    if (unit.depth() == 1) return visit.stages.empty() ? unit : first_in(unit.child('s', 0), level);
    const Unit& u = visit.unit();
    if (fine && u.before_loop > 0) return unit.child('e', 0);
    if (has_rounds(u)) return first_in(unit.child(u.loop->letter, u.loop->first), level);
    return fine && expressions(u) > 0 ? unit.child('e', 0) : unit;
}

Path Steps::last_in(const Path& unit, Level level) {
    const bool fine = level == Level::expression;
    if (!fine && unit.depth() >= depth_of(level)) return unit;
    const Visit& visit = at(unit);
    if (unit.depth() == 1) {
        const auto stages = static_cast<Integer>(visit.stages.size());
        return stages == 0 ? unit : last_in(unit.child('s', stages - 1), level);
    }
    const Unit& u = visit.unit();
    const bool tail = expressions(u) > u.before_loop;
    if (has_rounds(u) && !(fine && tail)) return last_in(unit.child(u.loop->letter, last_round(*u.loop)), level);
    return fine && expressions(u) > 0 ? unit.child('e', expressions(u) - 1) : unit;
}

std::optional<Path> Steps::after(const Path& unit, Level level) {
    const int depth = unit.depth();
    const Integer index = unit.parts.back().index;
    if (depth == 1) {
        if (index + 1 >= drawing_->shape_count()) return std::nullopt;
        return first_in(Path{{{'t', index + 1}}}, level);
    }
    const Path parent = unit.prefix(depth - 1);
    if (depth == 2) {
        const bool more = index + 1 < static_cast<Integer>(at(parent).stages.size());
        return more ? std::optional(first_in(parent.child('s', index + 1), level)) : after(parent, level);
    }
    const Unit& u = at(parent).unit();
    if (u.loop && u.loop->contains(index + u.loop->step)) {
        return first_in(parent.child(u.loop->letter, index + u.loop->step), level);
    }
    if (level == Level::expression && expressions(u) > u.before_loop) return parent.child('e', u.before_loop);
    return after(parent, level);
}

std::optional<Path> Steps::before(const Path& unit, Level level) {
    const int depth = unit.depth();
    const Integer index = unit.parts.back().index;
    if (depth == 1) {
        if (index <= 0) return std::nullopt;
        return last_in(Path{{{'t', index - 1}}}, level);
    }
    const Path parent = unit.prefix(depth - 1);
    if (depth == 2)
        return index > 0 ? std::optional(last_in(parent.child('s', index - 1), level)) : before(parent, level);
    const Unit& u = at(parent).unit();
    if (u.loop && u.loop->contains(index - u.loop->step)) {
        return last_in(parent.child(u.loop->letter, index - u.loop->step), level);
    }
    if (level == Level::expression && u.before_loop > 0) return parent.child('e', u.before_loop - 1);
    return before(parent, level);
}

std::optional<Path> Steps::next(const Path& path, Level level) {
    if (path.empty()) return first(level);
    if (level != Level::expression) return after(at_level(path, level), level);
    if (!path.at_expression()) {
        const Path inner = first_in(path, level);
        return inner == path ? after(path, level) : inner;
    }
    const Path unit = path.unit();
    const Unit& u = at(unit).unit();
    const Integer e = path.parts.back().index;
    if (e + 1 == u.before_loop && has_rounds(u)) return first_in(unit.child(u.loop->letter, u.loop->first), level);
    if (e + 1 < expressions(u)) return unit.child('e', e + 1);
    return after(unit, level);
}

std::optional<Path> Steps::previous(const Path& path, Level level) {
    if (path.empty()) return last(level);
    if (level != Level::expression || !path.at_expression())
        return before(level == Level::expression ? path : at_level(path, level), level);
    const Path unit = path.unit();
    const Unit& u = at(unit).unit();
    const Integer e = path.parts.back().index;
    if (e == u.before_loop && has_rounds(u)) return last_in(unit.child(u.loop->letter, last_round(*u.loop)), level);
    if (e > 0) return unit.child('e', e - 1);
    return before(unit, level);
}

Path Steps::at_level(const Path& path, Level level) {
    if (level == Level::expression && path.at_expression()) return path;
    return first_in(level == Level::expression ? path : path.unit().prefix(depth_of(level)), level);
}

std::optional<Path> Steps::at_pixel(int shape, Integer x, Integer y) {
    const Path whole{{{'t', shape}}};
    const auto coordinate = [&](char letter) { return letter == 'x' ? x : y; };
    const auto over_pixels = [](const std::optional<Loop>& loop) {
        return loop && (loop->letter == 'x' || loop->letter == 'y');
    };
    for (auto s = static_cast<Integer>(at(whole).stages.size()) - 1; s >= 0; --s) {
        const Path stage = whole.child('s', s);
        const std::optional<Loop> outer = at(stage).unit().loop;
        if (!outer) continue;
        if (!over_pixels(outer)) return by_texel(stage, x, y);
        if (!outer->contains(coordinate(outer->letter))) continue;
        const Path line = stage.child(outer->letter, coordinate(outer->letter));
        const std::optional<Loop> inner = at(line).unit().loop;
        if (!inner) continue;
        if (!over_pixels(inner)) return by_texel(stage, x, y);
        if (inner->contains(coordinate(inner->letter))) return line.child(inner->letter, coordinate(inner->letter));
    }
    return std::nullopt;
}

/// Where a method runs over texels, the last sample that came to the pixel says which texel's step it was.
std::optional<Path> Steps::by_texel(const Path& stage, Integer x, Integer y) {
    const int shape = static_cast<int>(stage.parts[0].index);
    const Rect pixel{static_cast<int>(x), static_cast<int>(y), static_cast<int>(x) + 1, static_cast<int>(y) + 1};
    std::optional<Sample> last;
    each_sample(*drawing_, shape, shape + 1, {pixel, 1}, [&](int, const Sample& s) { last = s; });
    if (!last) return std::nullopt;
    Path path = stage;
    while (path.depth() < 4) {
        const std::optional<Loop> loop = at(path).unit().loop;
        if (!loop) return std::nullopt;
        const double place = loop->letter == 'u' ? std::floor(last->u) : std::floor(last->v);
        const Integer index = loop->letter == 'x' ? x : loop->letter == 'y' ? y : static_cast<Integer>(place);
        if (!loop->contains(index)) return std::nullopt;
        path = path.child(loop->letter, index);
    }
    return path;
}

std::optional<Path> Steps::nearest(const Path& wanted, Level level) {
    if (drawing_->shape_count() == 0) return std::nullopt;
    if (wanted.empty()) return first(level);
    const Path path = level == Level::expression ? wanted : wanted.unit().prefix(depth_of(level));
    const Integer shape = std::clamp<Integer>(path.parts[0].index, 0, drawing_->shape_count() - 1);
    Path found{{{'t', shape}}};
    if (shape != path.parts[0].index) return shape == 0 ? first_in(found, level) : last_in(found, level);
    for (std::size_t depth = 1; depth < path.parts.size(); ++depth) {
        const PathPart& part = path.parts[depth];
        const Visit& visit = at(found);
        if (depth == 1) {
            const auto stages = static_cast<Integer>(visit.stages.size());
            if (stages == 0) return found;
            if (part.index < 0) return first_in(found, level);
            if (part.index >= stages) return last_in(found.child('s', stages - 1), level);
            found = found.child('s', part.index);
            continue;
        }
        const Unit& u = visit.unit();
        if (part.letter == 'e') {
            if (expressions(u) == 0) return first_in(found, level);
            return at_level(found.child('e', std::clamp<Integer>(part.index, 0, expressions(u) - 1)), level);
        }
        if (!has_rounds(u)) return last_in(found, level);
        const Loop& loop = *u.loop;
        if (part.letter != loop.letter || !loop.contains(part.index)) {
            const bool past = (part.index - loop.first) * loop.step > 0;
            if (part.letter == loop.letter && past) return last_in(found.child(loop.letter, last_round(loop)), level);
            return before(first_in(found.child(loop.letter, loop.first), level), level)
                .value_or(first_in(found, level));
        }
        found = found.child(part.letter, part.index);
    }
    return at_level(found, level);
}

}  // namespace texelscope
