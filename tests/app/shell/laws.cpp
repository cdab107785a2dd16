#include "tests/app/shell/laws.h"

#include "app/state/lesson_cursor.h"
#include "app/state/link.h"

namespace texelscope {
namespace {

[[nodiscard]] bool same_picture(const CanvasPicture& a, const CanvasPicture& b) {
    if (a.cells.size() != b.cells.size()) return false;
    for (std::size_t n = 0; n < a.cells.size(); ++n) {
        const CanvasCell &x = a.cells.data()[n], &y = b.cells.data()[n];
        if (!(x.now == y.now && x.later == y.later && x.written == y.written && x.visited == y.visited)) return false;
    }
    return true;
}

[[nodiscard]] Window whole(Store& store) { return {store.derived().scene().framebuffer.rect(), 1}; }

[[nodiscard]] Store copy_of(const Headless& app) { return Store(app.state()); }

[[nodiscard]] std::string broken_step_law(Store store, int count) {
    const Cursor before = store.state().cursor;
    const CanvasPicture picture = store.derived().canvas(whole(store));
    int done = 0;
    while (done < count && store.derived().steps().next(store.state().cursor.step, store.state().cursor.level)) {
        store.dispatch(action::Step{1});
        ++done;
    }
    for (int n = 0; n < done; ++n) store.dispatch(action::Step{-1});
    if (store.state().cursor != before)
        return "N steps forward and N back end at another step than " + before.step.text();
    if (!same_picture(picture, store.derived().canvas(whole(store))))
        return "N steps forward and N back show another picture";
    return {};
}

[[nodiscard]] std::string broken_end_law(Store store) {
    store.dispatch(action::StepEnd{true});
    if (store.state().cursor.step.empty()) return {};
    const CanvasPicture& picture = store.derived().canvas(whole(store));
    const Image& final_picture = store.derived().final_picture();
    for (std::size_t n = 0; n < final_picture.size(); ++n) {
        if (!(picture.cells.data()[n].now == final_picture.data()[n]))
            return "the picture after the last step is not the untraced run's";
    }
    return {};
}

}  // namespace

std::string broken_law(Headless& app) {
    const State& state = app.state();
    Store probe = copy_of(app);
    if (!state.cursor.step.empty() &&
        probe.derived().steps().nearest(state.cursor.step, state.cursor.level) != state.cursor.step) {
        return "the cursor stands on no step: " + state.cursor.step.text();
    }
    const auto link = parse_link(print_link(state));
    if (!link || link->work.edits != state.work.edits || link->cursor != state.cursor ||
        link->work.quirks != state.work.quirks || link->work.meshes != state.work.meshes ||
        link->work.focal != state.work.focal || link->work.frame != state.work.frame ||
        link->work.random != state.work.random || link->work.size_twice != state.work.size_twice ||
        link->other != state.look.other || link->difference != state.look.difference || link->rung != state.look.rung ||
        link->skips != state.look.skips) {
        return "the state does not survive being copied and pasted";
    }
    if (std::string law = broken_step_law(copy_of(app), 5); !law.empty()) return law;
    return broken_end_law(copy_of(app));
}

}  // namespace texelscope
