#include "core/trace/recording.h"

#include <algorithm>

namespace texelscope {

Recording::Recording(Path target) {
    visit_.path = target.unit();
    visit_.units.resize(std::max<std::size_t>(visit_.path.parts.size(), 1));
    target_stage_ = visit_.path.parts.size() >= 2 ? static_cast<int>(visit_.path.parts[1].index) : -2;
}

void Recording::stage(const char* name) {
    if (writer_.muted > 0) return;
    ++stage_;
    depth_ = 2;
    visit_.stages.push_back({name});
    off_path_.emplace_back();
}

Unit& Recording::current() {
    const auto depth = static_cast<std::size_t>(depth_);
    if (on_path() && depth <= visit_.units.size()) return visit_.units[depth - 1];
    if (off_path_.empty()) off_path_.emplace_back();
    return off_path_.back();
}

void Recording::fate(Fate fate) {
    if (on_path()) current().fate = fate;
}

void Recording::name(std::int32_t operation, Name name, int line, bool loop_variable) {
    writer_.tape.names.push_back({operation, name, line, loop_variable});
    if (loop_variable) return;
    Unit& unit = current();
    unit.expressions.push_back(static_cast<std::int32_t>(writer_.tape.names.size()) - 1);
    if (!unit.loop) unit.before_loop = static_cast<int>(unit.expressions.size());
}

Recording::Plan Recording::plan(const Loop& loop, Carry carry) {
    const Plan none{loop.first, loop.first, 0, loop.step, false};
    const Integer end = loop.first + loop.count() * loop.step;
    const Plan whole{loop.first, end, 0, loop.step, false};
    if (writer_.muted > 0) return carry == Carry::whole_loop ? whole : none;
    if (stage_ != target_stage_) return carry == Carry::whole_loop && stage_ < target_stage_ ? whole : none;

    Unit& unit = current();
    if (!unit.loop) unit.loop = loop;
    const auto next = static_cast<std::size_t>(depth_);
    if (next >= visit_.path.parts.size()) return carry == Carry::whole_loop ? whole : none;
    const PathPart& part = visit_.path.parts[next];
    if (part.letter != loop.letter || !loop.contains(part.index)) {
        visit_.found = false;
        return none;
    }
    switch (carry) {
        case Carry::none: return {part.index, part.index + loop.step, part.index, loop.step, true};
        case Carry::rounds_before: return {loop.first, part.index + loop.step, part.index, loop.step, true};
        case Carry::whole_loop: break;
    }
    return {loop.first, end, part.index, loop.step, true};
}

Visit Recording::finish(Fate shape_fate) && {
    visit_.shape_fate = shape_fate;
    const auto depth = visit_.path.parts.size();
    if (depth >= 2 && (target_stage_ < 0 || target_stage_ > stage_)) visit_.found = false;
    // A deeper part that no loop asked for leads nowhere.
    for (std::size_t d = 2; d < depth; ++d) {
        if (!visit_.units[d - 1].loop) visit_.found = false;
    }
    visit_.tape = std::move(writer_.tape);
    return std::move(visit_);
}

Recorded<Integer> RecordedRange::enter(Integer at) {
    TapeWriter& writer = recording_->writer();
    static constexpr const char kLetters[] =
        "a\0b\0c\0d\0e\0f\0g\0h\0i\0j\0k\0l\0m\0n\0o\0p\0q\0r\0s\0t\0u\0v\0w\0x\0y\0z";
    const Name name(&kLetters[2 * (letter_ - 'a')]);
    if (plan_.has_target && at == plan_.target) {
        inside_ = Inside::target_round;
        recording_->enter_target();
        const std::int32_t leaf = writer.tape.push(Op::input, at);
        recording_->name(leaf, name, line_, true);
        return {at, &writer, leaf};
    }
    inside_ = Inside::muted_round;
    ++writer.muted;
    return Recorded<Integer>(at, &writer, -1).carried(name, line_);
}

void RecordedRange::leave() {
    if (inside_ == Inside::target_round) recording_->leave_target();
    if (inside_ == Inside::muted_round) --recording_->writer().muted;
    inside_ = Inside::nothing;
}

bool Listener::named(std::int32_t operation) const {
    const auto& names = recording->writer().tape.names;
    return std::any_of(names.rbegin(), names.rend(), [&](const Named& n) { return n.operation == operation; });
}

}  // namespace texelscope
