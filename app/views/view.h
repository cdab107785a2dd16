// What a view is: a function that draws a part of the state into its place and returns what the person did there.
// One file a view; it registers itself under the name that lessons use.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "app/platform/texture_store.h"
#include "app/state/action.h"
#include "app/state/derived.h"
#include "app/state/request.h"
#include "app/ui/ui.h"

namespace texelscope {

/// All that a view may look at. It computes nothing of the method's: numbers come from `derived`.
struct ViewContext {
    ui::Ui& ui;
    const State& state;
    Derived& derived;
    TextureStore& textures;
    std::span<const Lesson> lessons;  ///< all, for the list
    std::vector<Action>& actions;     ///< what was done; the shell dispatches it after the frame
    bool can_undo = false, can_redo = false;
    bool timed = false;       ///< how long frames take is shown: never in pictures of the window, which are all alike
    Highlight hover, pinned;  ///< resolved once a frame
    std::vector<ShellRequest>* requests = nullptr;  ///< what only the shell can do; may be null

    void act(Action action) const { actions.push_back(std::move(action)); }
    void request(const ShellRequest& what) const {
        if (requests != nullptr) requests->push_back(what);
    }
};

struct View {
    std::string_view name;   ///< "canvas", "texels", "formula", "ring" …: what a lesson's `views` says
    std::string_view title;  ///< of the tab
    void (*draw)(const ViewContext&, const ui::Area& place);
};

/// In order of their names. Filled before main by RegisterView.
[[nodiscard]] std::span<const View* const> views();
[[nodiscard]] const View* find_view(std::string_view name);

struct RegisterView {
    explicit RegisterView(const View& view);
};

}  // namespace texelscope
