#include "app/state/lockstep.h"

#include <algorithm>

#include "app/state/derived_cache.h"

namespace texelscope {
namespace {

/// How far a drawing's loop has come: so many whole rounds, and so many of the round under way.
struct LoopProgress {
    bool begun = false, done = false;
    Integer rows = 0;     ///< whole rounds of the outer loop
    Integer columns = 0;  ///< of the round after these; 0: none of it
};

/// The loop that puts samples: the shape's last stage that has one. Empty where there is none.
[[nodiscard]] Path loop_of(Steps& steps, int shape) {
    const Path whole{{{'t', shape}}};
    for (auto s = static_cast<Integer>(steps.at(whole).stages.size()) - 1; s >= 0; --s) {
        Path stage = whole.child('s', s);
        if (steps.at(stage).unit().loop) return stage;
    }
    return {};
}

[[nodiscard]] Integer round_of(const Loop& loop, Integer index) { return (index - loop.first) * loop.step; }

[[nodiscard]] LoopProgress progress_of(Steps& steps, const Path& stage, const Path& step) {
    const Path unit = step.unit();
    if (unit.depth() < 2) return {true, true};
    if (unit.parts[1].index != stage.parts[1].index) return {false, unit.parts[1].index > stage.parts[1].index};
    if (unit.depth() == 2) return {true, true};
    const Integer row = round_of(*steps.at(stage).unit().loop, unit.parts[2].index);
    if (unit.depth() == 3) return {true, false, row + 1};
    const std::optional<Loop> inner = steps.at(unit.prefix(3)).unit().loop;
    return {true, false, row, inner ? round_of(*inner, unit.parts[3].index) + 1 : 0};
}

/// The step that is as far in this drawing; the whole shape where it is done by then.
[[nodiscard]] Path step_at(Steps& steps, const Path& stage, const LoopProgress& at) {
    Path whole = stage.prefix(1);
    const std::optional<Loop> outer = steps.at(stage).unit().loop;
    const Integer row = at.columns > 0 ? at.rows : at.rows - 1;
    if (at.done || !outer || row >= outer->count()) return whole;
    Path line = stage.child(outer->letter, outer->first + row * outer->step);
    const std::optional<Loop> inner = steps.at(line).unit().loop;
    if (at.columns == 0 || !inner || at.columns > inner->count()) return line;
    return line.child(inner->letter, inner->first + (at.columns - 1) * inner->step);
}

/// The samples that the shape writes, up to a step or, where that is the shape itself, all.
void each_written(const Drawing& drawing, const Path& step, auto&& put) {
    const int shape = static_cast<int>(step.parts[0].index);
    const int first = drawing.scene().depth == Depth::less ? 0 : shape;
    const auto take = [&](int n, const Sample& s) {
        if (n == shape && s.fate == Fate::written) put(s);
    };
    const Window frame{drawing.scene().framebuffer.rect(), 1};
    if (step.depth() > 1)
        each_sample_until(drawing, first, step, frame, take);
    else
        each_sample(drawing, first, shape + 1, frame, take);
}

[[nodiscard]] Drawing other_way(const Drawing& drawing, std::string_view method) {
    DrawSettings settings = drawing.settings();
    settings.method = find_method(method);
    settings.quirks = settings.method->variants.back().quirks;
    return {drawing.scene(), settings};
}

void raise(std::uint8_t& count) {
    if (count < 255) ++count;
}

void count_up(Lockstep& made) {
    for (std::size_t n = 0; n < made.cells.size(); ++n) {
        const LockstepCell& cell = made.cells.data()[n];
        made.inside += cell.inside;
        made.holes += cell.inside && cell.writes_in_all == 0;
        made.again += cell.writes_in_all > 1;
        made.outside += !cell.inside && cell.writes_in_all > 0;
    }
}

}  // namespace

bool has_directions(const Method& method) {
    return method.id == kForward || method.id == kBackward || method.id == "backward-affine";
}

Lockstep make_lockstep(const Drawing& drawing, Steps& steps, const Path& step) {
    Lockstep made;
    if (step.empty() || drawing.shape_count() == 0 || !has_directions(*drawing.settings().method)) return made;
    const int shape = static_cast<int>(std::clamp<Integer>(step.parts[0].index, 0, drawing.shape_count() - 1));
    const bool scatters = drawing.settings().method->scatters;
    const Drawing other = other_way(drawing, scatters ? kBackward : kForward);
    Steps other_steps(other);
    const Drawing &forward = scatters ? drawing : other, &backward = scatters ? other : drawing;

    made.rect = backward.reach(shape);
    if (made.rect.empty()) return made;
    made.cells = Grid<LockstepCell>(made.rect.width(), made.rect.height());
    const auto at = [&](const Sample& s, auto&& change) {
        if (made.rect.contains(s.x, s.y))
            change(made.cells.at(static_cast<int>(s.x) - made.rect.x0, static_cast<int>(s.y) - made.rect.y0));
    };
    const Path whole{{{'t', shape}}};
    each_written(forward, whole, [&](const Sample& s) { at(s, [](LockstepCell& c) { raise(c.writes_in_all); }); });
    each_written(backward, whole, [&](const Sample& s) {
        at(s, [&](LockstepCell& c) {
            made.backward_again += c.inside;
            c.inside = true;
        });
    });
    count_up(made);

    const Path own = loop_of(steps, shape), others = loop_of(other_steps, shape);
    if (own.empty() || others.empty()) return made;
    const Integer own_rows = steps.at(own).unit().loop->count(), rows = other_steps.at(others).unit().loop->count();
    made.forward_rows = scatters ? own_rows : rows, made.backward_rows = scatters ? rows : own_rows;
    const LoopProgress progress = progress_of(steps, own, step);
    made.begun = progress.begun || progress.done, made.done = progress.done;
    made.rows = progress.done ? std::max(own_rows, rows) : progress.rows + (progress.columns > 0);
    if (!made.begun) return made;
    const Path own_step = progress.done ? whole : step.unit(), other_step = step_at(other_steps, others, progress);
    each_written(forward, scatters ? own_step : other_step, [&](const Sample& s) {
        at(s, [&](LockstepCell& c) { raise(c.writes), c.forward = s.colour; });
        made.forward_last = {static_cast<int>(s.x), static_cast<int>(s.y)};
    });
    each_written(backward, scatters ? other_step : own_step, [&](const Sample& s) {
        at(s, [&](LockstepCell& c) { c.drawn = true, c.backward = s.colour; });
        made.backward_last = {static_cast<int>(s.x), static_cast<int>(s.y)};
    });
    return made;
}

Grid<std::uint8_t> holes_of(const Drawing& drawing, int shape) {
    const Drawing forward = other_way(drawing, kForward), backward = other_way(drawing, kBackward);
    const Rect frame = drawing.scene().framebuffer.rect();
    Grid<std::uint8_t> holes(frame.width(), frame.height());
    const Path whole{{{'t', shape}}};
    const auto set = [&](const Sample& s, std::uint8_t to) {
        if (frame.contains(s.x, s.y)) holes.at(static_cast<int>(s.x) - frame.x0, static_cast<int>(s.y) - frame.y0) = to;
    };
    each_written(backward, whole, [&](const Sample& s) { set(s, 1); });
    each_written(forward, whole, [&](const Sample& s) { set(s, 0); });
    return holes;
}

const Lockstep& Derived::lockstep() const {
    auto& found = cache_->of_step.lockstep;
    if (!found) found = make_lockstep(drawing(), steps(), cache_->state.cursor.step);
    return *found;
}

const TwoPassBuffer& Derived::two_pass_buffer() const {
    auto& found = cache_->of_drawing.buffer;
    if (found && found->first == shape()) return found->second;
    found.emplace(shape(), TwoPassBuffer{});
    if (shape() >= 0 && method().id == "two-pass" && drawing().refusal(shape()) == Fate::written)
        found->second = texelscope::two_pass_buffer(drawing().settings().format, drawing().job(shape()));
    return found->second;
}

}  // namespace texelscope
