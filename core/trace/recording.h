// Records one unit of a run: the tape of everything computed on the way to it, and the shape of the step tree
// along the path. The method's own code runs; only its loops are narrowed to the unit.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/number/recorded.h"
#include "core/trace/path.h"
#include "core/trace/trace.h"

namespace texelscope {

/// The loop of a unit: its children, as a range and never as a list.
struct Loop {
    char letter = 'x';
    Integer first = 0, last = 0;  ///< the rounds first, first + step, … without last
    int step = 1;

    [[nodiscard]] Integer count() const { return (last - first) * step > 0 ? (last - first) * step : 0; }
    [[nodiscard]] bool contains(Integer index) const {
        return (index - first) * step >= 0 && (last - index) * step > 0;
    }
    friend bool operator==(const Loop&, const Loop&) = default;
};

/// One unit on the way to a step.
struct Unit {
    std::vector<std::int32_t> expressions;  ///< its own expressions, as indices of Tape::names, in order
    int before_loop = 0;                    ///< how many of them come before its loop
    std::optional<Loop> loop;
    std::optional<Fate> fate;
};

/// A shape's stage.
struct Stage {
    std::string name;
};

/// All that is known of one step.
struct Visit {
    Path path;  ///< of the unit; no expression
    Tape tape;
    std::vector<Unit> units;    ///< units[0] the shape, units[1] the stage, … one for each part of the path
    std::vector<Stage> stages;  ///< of the shape
    Fate shape_fate = Fate::written;
    bool found = true;  ///< false where the path leads nowhere

    [[nodiscard]] const Unit& unit() const { return units.back(); }
};

class Recording {
public:
    explicit Recording(Path target);

    void stage(const char* name);
    void fate(Fate fate);
    void name(std::int32_t operation, Name name, int line, bool loop_variable);
    [[nodiscard]] TapeWriter& writer() { return writer_; }
    [[nodiscard]] Visit finish(Fate shape_fate) &&;

    /// How much of a loop is needed to compute one of its rounds, or what comes after it.
    enum class Carry { none, rounds_before, whole_loop };
    struct Plan {
        Integer first = 0, last = 0, target = 0;
        int step = 1;
        bool has_target = false;  ///< round `target` is recorded, others pass muted
    };
    [[nodiscard]] Plan plan(const Loop& loop, Carry carry);
    void enter_target() { ++depth_; }
    void leave_target() { --depth_; }
    [[nodiscard]] bool muted() const { return writer_.muted > 0; }

private:
    [[nodiscard]] bool on_path() const { return stage_ == target_stage_ && writer_.muted == 0; }
    [[nodiscard]] Unit& current();

    Visit visit_;
    TapeWriter writer_;
    int target_stage_ = -1;
    int stage_ = -1;
    int depth_ = 2;  ///< of the unit that runs now: 2 the stage itself, 3 a round of its loop, …
    std::vector<Unit> off_path_;
};

/// The rounds of a loop as a Recording wants them; hands out the loop variable as a named leaf.
class RecordedRange {
public:
    RecordedRange(Recording& recording, const Loop& loop, Recording::Carry carry, int line)
        : recording_(&recording), plan_(recording.plan(loop, carry)), letter_(loop.letter), line_(line) {}
    RecordedRange(const RecordedRange&) = delete;
    RecordedRange& operator=(const RecordedRange&) = delete;
    ~RecordedRange() { leave(); }

    struct Iterator {
        RecordedRange* range;
        Integer at;
        Recorded<Integer> operator*() const { return range->enter(at); }
        Iterator& operator++() { return range->leave(), at += range->plan_.step, *this; }
        bool operator!=(const Iterator& other) const { return at != other.at; }
    };
    [[nodiscard]] Iterator begin() { return {this, plan_.first}; }
    [[nodiscard]] Iterator end() { return {this, plan_.last}; }

private:
    [[nodiscard]] Recorded<Integer> enter(Integer at);
    void leave();

    Recording* recording_;
    Recording::Plan plan_;
    char letter_;
    int line_;
    enum class Inside { nothing, muted_round, target_round } inside_ = Inside::nothing;
};

/// The trace that writes to a Recording.
struct Listener {
    static constexpr bool kVisits = true;
    Recording* recording;

    template <class V>
    Recorded<V> operator()(Name name, const Recorded<V>& value, int line = __builtin_LINE()) const {
        if (recording->muted()) return value.carried(name, line);
        Tape& tape = recording->writer().tape;
        const bool leaf = value.operation() < 0 && value.name().empty();
        std::int32_t operation = leaf ? tape.push(Op::input, value.value()) : value.on_tape(recording->writer());
        if (!leaf && named(operation)) operation = tape.push(Op::same, value.value(), operation);
        recording->name(operation, name, line, false);
        return Recorded<V>(value.value(), &recording->writer(), operation);
    }
    /// Plain values become leaves, so that they have a name on the tape.
    template <class V>
    requires std::integral<V>
    auto operator()(Name name, V value, int line = __builtin_LINE()) const {
        using Kind = std::conditional_t<std::same_as<V, bool>, bool, Integer>;
        return (*this)(name, Recorded<Kind>(static_cast<Kind>(value)), line);
    }
    void stage(const char* name) const { recording->stage(name); }
    Fate fate(Fate fate) const { return recording->fate(fate), fate; }
    RecordedRange each(char letter, const auto& first, const auto& last, int line = __builtin_LINE()) const {
        return {*recording, {letter, whole(first), whole(last), 1}, Recording::Carry::none, line};
    }
    RecordedRange stray(char letter, const auto& first, const auto& last, int line = __builtin_LINE()) const {
        return each(letter, first, last, line);
    }
    RecordedRange walk(char letter, const auto& first, const auto& last, int line = __builtin_LINE()) const {
        return {*recording, {letter, whole(first), whole(last), 1}, Recording::Carry::rounds_before, line};
    }
    RecordedRange fill(char letter, const auto& first, const auto& last, int line = __builtin_LINE()) const {
        return {*recording, {letter, whole(first), whole(last), 1}, Recording::Carry::whole_loop, line};
    }
    RecordedRange toward(char letter, const auto& first, const auto& last, int line = __builtin_LINE()) const {
        const int step = whole(first) <= whole(last) ? 1 : -1;
        return {*recording, {letter, whole(first), whole(last), step}, Recording::Carry::none, line};
    }
    bool wanted(char, const auto&) const { return !recording->muted(); }
    /// Computes without a mark: what an earlier pass has shown already. Its results keep their names.
    auto quiet(auto&& stage) const {
        ++recording->writer().muted;
        auto result = stage();
        --recording->writer().muted;
        return result;
    }

private:
    [[nodiscard]] static Integer whole(const Recorded<Integer>& i) { return i.value(); }
    [[nodiscard]] static Integer whole(Integer i) { return i; }
    [[nodiscard]] bool named(std::int32_t operation) const;
};

}  // namespace texelscope
