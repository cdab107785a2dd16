// Holds the state, its history and what is derived from it; takes actions.
#pragma once

#include <vector>

#include "app/state/action.h"
#include "app/state/derived.h"
#include "app/state/state.h"

namespace texelscope {

/// The next state. Pure but for what `derived` remembers: steps are looked up there. Undo and Redo are the Store's.
[[nodiscard]] State reduce(const State& state, const Action& action, Derived& derived);

/// After a change of the scene: what was measured is forgotten, and measured anew where it is live.
void measure_again(State& state, const Work& before);

class Store {
public:
    explicit Store(State state) : state_(std::move(state)) { derived_.update(state_); }

    void dispatch(const Action& action);
    [[nodiscard]] const State& state() const { return state_; }
    [[nodiscard]] Derived& derived() { return derived_; }
    [[nodiscard]] bool can_undo() const { return !past_.empty(); }
    [[nodiscard]] bool can_redo() const { return !future_.empty(); }

private:
    /// What undo restores.
    struct Entry {
        Work work;
        Cursor cursor;
        int gesture = 0;
    };
    void undo(std::vector<Entry>& from, std::vector<Entry>& to);

    State state_;
    Derived derived_;
    std::vector<Entry> past_, future_;
};

/// The state of a document just opened: its lesson's first beat, or the first step of the scene.
[[nodiscard]] State opened(std::shared_ptr<const Document> document, const State& before);

}  // namespace texelscope
