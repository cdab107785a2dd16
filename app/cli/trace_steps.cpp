#include "app/cli/trace_steps.h"

#include <algorithm>

namespace texelscope {
namespace {

[[nodiscard]] int depth_of(Level level) { return static_cast<int>(level) + 1; }

[[nodiscard]] int shared_depth(const Path& a, const Path& b) {
    int depth = 0;
    while (depth < std::min(a.depth(), b.depth()) &&
           a.parts[static_cast<std::size_t>(depth)] == b.parts[static_cast<std::size_t>(depth)])
        ++depth;
    return depth;
}

/// Walks the chain to one pixel.
class Chain {
public:
    Chain(Steps& steps, Level level, Place place, const OnStep& on_step)
        : steps_(steps), level_(level), place_(place), on_step_(on_step) {}

    void run() {
        const DrawSettings& settings = steps_.drawing().settings();
        for (int shape = 0; shape < steps_.drawing().shape_count() && going_; ++shape) {
            const Rect pixel{static_cast<int>(place_.x), static_cast<int>(place_.y), static_cast<int>(place_.x) + 1,
                             static_cast<int>(place_.y) + 1};
            if (steps_.drawing().refusal(shape) != Fate::written || !steps_.drawing().touches(shape, pixel)) continue;
            at_ = Path{{{'t', shape}}};
            begun_ = false;
            straying_ = settings.method->may_stray(settings.quirks);
            const auto stages = static_cast<Integer>(steps_.at(at_).stages.size());
            const Path whole = at_;
            for (Integer s = 0; s < stages && going_; ++s) search(whole.child('s', s));
            if (begun_ && going_) leave_to(0);
        }
    }

private:
    /// Comes to each unit inside `unit` that visits the pixel, by the straight way where there is one.
    void search(const Path& unit) {
        const Visit& visit = steps_.at(unit);
        if (!visit.found) return;
        const std::optional<Loop> loop = visit.unit().loop;
        if (unit.depth() > 2 && place_of(visit) == place_ && !loop) return come_to(unit);
        if (!loop) return;
        const bool known = (loop->letter == 'x' || loop->letter == 'y') && !straying_;
        if (known) {
            const Integer round = loop->letter == 'x' ? place_.x : place_.y;
            if (loop->contains(round)) search(unit.child(loop->letter, round));
            return;
        }
        for (Integer n = loop->first; loop->contains(n) && going_; n += loop->step) search(unit.child(loop->letter, n));
    }

    /// Prints what lies between the last unit that was come to and this one, then this one.
    void come_to(const Path& unit) {
        if (!begun_) {
            begun_ = true;
            at_ = unit.prefix(1);
            if (level_ == Level::triangle) print(at_);
            for (Integer s = 0; s < unit.parts[1].index; ++s) pass(at_.child('s', s));
        } else {
            const int shared = shared_depth(at_, unit);
            leave_to(shared);
            if (shared == 1) {
                for (Integer s = at_.parts[1].index + 1; s < unit.parts[1].index; ++s)
                    pass(unit.prefix(1).child('s', s));
            }
        }
        const int from = std::max(1, shared_depth(at_, unit));
        for (int depth = from + 1; depth <= unit.depth(); ++depth) enter(unit.prefix(depth));
        at_ = unit;
    }

    /// A stage on the way that does not itself come to the pixel.
    void pass(const Path& stage) {
        enter(stage);
        tail(stage);
    }
    /// What a unit does before its loop, or the unit itself if the level is as coarse as it is.
    void enter(const Path& unit) {
        const Unit& u = steps_.at(unit).unit();
        if (level_ == Level::expression)
            return print_expressions(unit, 0, u.before_loop, u.expressions.empty() && !u.loop);
        if (unit.depth() == depth_of(level_) || (unit.depth() < depth_of(level_) && !u.loop)) print(unit);
    }
    /// What it does after its loop.
    void tail(const Path& unit) {
        const Unit& u = steps_.at(unit).unit();
        if (level_ == Level::expression)
            print_expressions(unit, u.before_loop, static_cast<int>(u.expressions.size()), false);
    }
    void leave_to(int depth) {
        for (int d = at_.depth(); d > std::max(depth, 1); --d) tail(at_.prefix(d));
    }

    void print_expressions(const Path& unit, int first, int last, bool itself) {
        if (itself) print(unit);
        for (int e = first; e < last; ++e) print(unit.child('e', e));
    }
    void print(const Path& path) {
        if (going_) going_ = on_step_(path);
    }

    Steps& steps_;
    Level level_;
    Place place_;
    const OnStep& on_step_;
    Path at_;                ///< the last unit that was come to
    bool begun_ = false;     ///< whether this shape came to the pixel
    bool straying_ = false;  ///< samples may lie elsewhere than their rounds say
    bool going_ = true;
};

}  // namespace

void each_step(Steps& steps, Level level, const OnStep& on_step) {
    for (auto path = steps.first(level); path && on_step(*path); path = steps.next(*path, level)) {
    }
}

void each_step_at(Steps& steps, Level level, Place place, const OnStep& on_step) {
    Chain(steps, level, place, on_step).run();
}

std::optional<Value> value_of(const Visit& visit, std::string_view name) {
    const Unit& unit = visit.unit();
    for (auto e = unit.expressions.rbegin(); e != unit.expressions.rend(); ++e) {
        const Named& named = visit.tape.names[static_cast<std::size_t>(*e)];
        if (named.name.text() == name) return visit.tape.operations[static_cast<std::size_t>(named.operation)].value;
    }
    return std::nullopt;
}

std::optional<Place> place_of(const Visit& visit) {
    // What it computed counts before the round that it runs in: methods that write forward compute where to.
    const auto along = [&](std::string_view name) -> std::optional<Integer> {
        const auto computed = value_of(visit, name);
        if (computed && std::holds_alternative<Integer>(*computed)) return std::get<Integer>(*computed);
        return visit.path.index_of(name[0]);
    };
    const auto column = along("x"), row = along("y");
    if (column && row) return Place{*column, *row};
    return std::nullopt;
}

}  // namespace texelscope
