// The five lanes of the timeline: each shows the children of the unit above.
#include <algorithm>

#include "app/state/derived_cache.h"

namespace texelscope {
namespace {

constexpr Integer kCheapSamples = 1 << 18;  ///< of a shape whose rows are looked through for their kinds

[[nodiscard]] Lane loop_lane(Level level, const std::optional<Loop>& loop, std::optional<Integer> index) {
    Lane lane{.level = level, .letter = 'x'};
    if (!loop) return lane;
    lane.letter = loop->letter, lane.first = loop->first, lane.count = loop->count(), lane.step = loop->step;
    if (index && loop->contains(*index)) lane.current = (*index - loop->first) * loop->step;
    return lane;
}

[[nodiscard]] std::optional<Integer> part_at(const Path& path, std::size_t depth) {
    if (path.parts.size() <= depth || path.parts[depth].letter == 'e') return std::nullopt;
    return path.parts[depth].index;
}

[[nodiscard]] Lane shapes_lane(const Drawing& drawing, int current) {
    Lane lane{.level = Level::triangle, .letter = 't', .count = drawing.shape_count(), .current = current};
    if (lane.count > kMaxTicks) return lane;
    for (int n = 0; n < drawing.shape_count(); ++n) {
        lane.kinds.push_back(drawing.refusal(n) == Fate::written ? TickKind::covered : TickKind::empty);
    }
    return lane;
}

[[nodiscard]] Lane stages_lane(const Visit& visit, const Path& step) {
    Lane lane{.level = Level::stage, .letter = 's', .count = static_cast<Integer>(visit.stages.size())};
    lane.current = part_at(step, 1).value_or(-1);
    int repeated = 0;
    for (std::size_t n = 0; n < visit.stages.size(); ++n) {
        const std::string& name = visit.stages[n].name;
        const bool again =
            std::count_if(visit.stages.begin(), visit.stages.end(), [&](const Stage& s) { return s.name == name; }) > 1;
        lane.labels.push_back(again ? name + " " + std::to_string(++repeated) : name);
    }
    return lane;
}

[[nodiscard]] Lane expressions_lane(const Visit& visit, const Path& step) {
    const Unit& unit = visit.unit();
    Lane lane{.level = Level::expression, .letter = 'e', .count = static_cast<Integer>(unit.expressions.size())};
    if (step.at_expression()) lane.current = step.parts.back().index;
    for (const std::int32_t n : unit.expressions) {
        const Named& named = visit.tape.names[static_cast<std::size_t>(n)];
        const Operation& operation = visit.tape.operations[static_cast<std::size_t>(named.operation)];
        const bool trivial = operation.op == Op::input || operation.op == Op::constant || operation.op == Op::same;
        lane.labels.push_back(named.name.text());
        lane.folded.push_back(trivial);
        lane.kinds.push_back(undefined(operation.value) || overflowed(operation.value) ? TickKind::mark
                                                                                       : TickKind::covered);
    }
    return lane;
}

}  // namespace

std::vector<Lane> Derived::lanes() const {
    auto& found = cache_->of_step.lanes;
    if (found) return *found;
    const Path& step = cache_->state.cursor.step;
    std::vector<Lane> lanes{shapes_lane(drawing(), shape())};
    if (step.empty()) {
        lanes.insert(lanes.end(),
                     {Lane{Level::stage}, Lane{Level::scanline}, Lane{Level::pixel}, Lane{Level::expression}});
        return *(found = lanes);
    }
    const Path unit = step.unit();
    lanes.push_back(stages_lane(steps().at(unit.prefix(1)), step));
    lanes.push_back(unit.depth() < 2
                        ? Lane{Level::scanline}
                        : loop_lane(Level::scanline, steps().at(unit.prefix(2)).unit().loop, part_at(step, 2)));
    lanes.push_back(unit.depth() < 3
                        ? Lane{Level::pixel}
                        : loop_lane(Level::pixel, steps().at(unit.prefix(3)).unit().loop, part_at(step, 3)));
    lanes.push_back(expressions_lane(visit(), step));

    Lane& rows = lanes[2];
    const Rect frame = scene().framebuffer.rect();
    if (rows.count > 0 && rows.letter == 'y' && rows.count <= kMaxTicks &&
        rows.count * frame.width() <= kCheapSamples) {
        auto& kinds = cache_->of_drawing.rows[{shape(), part_at(step, 1).value_or(0)}];
        if (kinds.empty()) {
            kinds.assign(static_cast<std::size_t>(rows.count), TickKind::rejected);
            const auto cover = [&](Integer y) {
                const Integer at = (y - rows.first) * rows.step;
                if (at >= 0 && at < rows.count) kinds[static_cast<std::size_t>(at)] = TickKind::covered;
            };
            const CanvasPicture* const all = whole_frame_in_view();
            if (all != nullptr && scene().depth == Depth::off && !method().may_stray(drawing().settings().quirks)) {
                const Rect reach = drawing().reach(shape());
                for (int y = reach.y0; y < reach.y1; ++y)
                    for (int x = reach.x0; x < reach.x1; ++x)
                        if (all->cells.at(x - frame.x0, y - frame.y0).fate == Fate::written) {
                            cover(y);
                            break;
                        }
            } else {
                each_sample(drawing(), shape(), shape() + 1, {frame, 1}, [&](int, const Sample& s) {
                    if (s.fate == Fate::written) cover(s.y);
                });
            }
        }
        rows.kinds = kinds;
    }
    Lane& pixels = lanes[3];
    if (pixels.count > 0 && pixels.letter == 'x' && pixels.count <= kMaxTicks) {
        pixels.kinds.assign(static_cast<std::size_t>(pixels.count), TickKind::empty);
        for (const Sample& s : row_samples()) {
            const Integer at = (s.x - pixels.first) * pixels.step;
            if (at < 0 || at >= pixels.count) continue;
            pixels.kinds[static_cast<std::size_t>(at)] = s.note != Note::none      ? TickKind::mark
                                                         : s.fate == Fate::written ? TickKind::covered
                                                                                   : TickKind::rejected;
        }
    }
    return *(found = lanes);
}

}  // namespace texelscope
