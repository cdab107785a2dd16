// Runs a method as far as a step and no further: the picture as it stands there, and how often each line ran.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "core/trace/path.h"
#include "core/trace/trace.h"

namespace texelscope {

/// How often each line of the listing ran; index 0 is not used.
using LineCounts = std::vector<std::int64_t>;

/// How far a partial run has come. Shared by the copies of its trace.
struct Progress {
    static constexpr std::size_t kMostLines = 2048;  ///< of a listing; later ones are not counted

    Path target;  ///< the unit that runs last; empty: run everything
    LineCounts counts = LineCounts(kMostLines), uncounted = counts;
    std::int64_t* counting = counts.data();  ///< or `uncounted`, past the target's stage
    int stage = -1;
    std::size_t depth = 2;  ///< of the next loop on the way to the target
    bool at_edge = true;    ///< the rounds entered so far are the target's own

    void enter_stage() {
        ++stage, depth = 2, at_edge = true;
        if (stage > target_stage()) counting = uncounted.data();
    }
    [[nodiscard]] int target_stage() const {
        return target.parts.size() < 2 ? 1 << 20 : static_cast<int>(target.parts[1].index);
    }
    /// The last round of a loop that starts now, or nothing where all its rounds run.
    [[nodiscard]] const PathPart* last_round(char letter) const {
        if (stage != target_stage() || !at_edge || depth >= target.parts.size()) return nullptr;
        return target.parts[depth].letter == letter ? &target.parts[depth] : nullptr;
    }
};

/// A Range that tells a Progress when the target's own round is entered and left.
class PartialRange {
public:
    PartialRange(Progress& progress, Range range, const PathPart* last) : progress_(&progress), range_(range) {
        if (last != nullptr) limited_ = true, edge_ = last->index;
    }
    PartialRange(const PartialRange&) = delete;
    PartialRange& operator=(const PartialRange&) = delete;
    ~PartialRange() { leave(); }

    struct Iterator {
        PartialRange* range;
        Range::Iterator at;
        Integer operator*() const { return range->enter(*at); }
        Iterator& operator++() { return range->leave(), ++at, *this; }
        bool operator!=(const Iterator& other) const { return at != other.at; }
    };
    [[nodiscard]] Iterator begin() { return {this, range_.begin()}; }
    [[nodiscard]] Iterator end() { return {this, range_.end()}; }

private:
    Integer enter(Integer at) {
        inside_ = limited_;
        if (inside_ && at == edge_)
            ++progress_->depth, at_target_ = true;
        else if (inside_)
            progress_->at_edge = false;
        return at;
    }
    void leave() {
        if (!inside_) return;
        if (at_target_) --progress_->depth;
        progress_->at_edge = true;
        inside_ = at_target_ = false;
    }

    Progress* progress_;
    Range range_;
    Integer edge_ = 0;
    bool limited_ = false, inside_ = false, at_target_ = false;
};

struct PartialTrace {
    static constexpr bool kVisits = true;
    WindowTrace window;
    Progress* progress;

    template <class V>
    V operator()(Name, V value, int line = __builtin_LINE()) const {
        ++progress->counting[std::min(static_cast<std::size_t>(line), Progress::kMostLines - 1)];
        return value;
    }
    void stage(const char*) const { progress->enter_stage(); }
    Fate fate(Fate fate) const { return fate; }
    PartialRange each(char letter, Integer first, Integer last) const {
        return limited(letter, first, last, 1, [&](Integer end) { return window.each(letter, first, end); });
    }
    PartialRange stray(char letter, Integer first, Integer last) const {
        return limited(letter, first, last, 1, [&](Integer end) { return Range(first, end, 1); });
    }
    PartialRange walk(char letter, Integer first, Integer last) const {
        return limited(letter, first, last, 1, [&](Integer end) { return window.walk(letter, first, end); });
    }
    PartialRange fill(char letter, Integer first, Integer last) const {
        return limited(letter, first, last, 1, [&](Integer end) { return window.fill(letter, first, end); });
    }
    PartialRange toward(char letter, Integer first, Integer last) const {
        return limited(letter, first, last, first <= last ? 1 : -1,
                       [&](Integer end) { return window.toward(letter, first, end); });
    }
    bool wanted(char letter, Integer index) const { return window.wanted(letter, index); }
    auto quiet(auto&& stage) const { return stage(); }

private:
    PartialRange limited(char letter, Integer first, Integer last, int step, auto&& range) const {
        if (progress->stage > progress->target_stage()) return {*progress, Range(first, first, 1), nullptr};
        const PathPart* target = progress->last_round(letter);
        const bool inside =
            target != nullptr && (target->index - first) * step >= 0 && (last - target->index) * step > 0;
        return {*progress, range(inside ? target->index + step : last), target};
    }
};

}  // namespace texelscope
