#include "app/views/view.h"

#include <algorithm>

namespace texelscope {
namespace {

std::vector<const View*>& registry() {
    static std::vector<const View*> all;
    return all;
}

}  // namespace

std::span<const View* const> views() { return registry(); }

const View* find_view(std::string_view name) {
    const auto& all = registry();
    const auto at = std::find_if(all.begin(), all.end(), [name](const View* view) { return view->name == name; });
    return at == all.end() ? nullptr : *at;
}

RegisterView::RegisterView(const View& view) {
    auto& all = registry();
    const auto after = [&](const View* other) { return view.name < other->name; };
    all.insert(std::find_if(all.begin(), all.end(), after), &view);
}

}  // namespace texelscope
