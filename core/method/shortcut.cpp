#include "core/method/shortcut.h"

#include <algorithm>
#include <vector>

namespace texelscope {
namespace {

std::vector<const Shortcut*>& registry() {
    static std::vector<const Shortcut*> all;
    return all;
}

}  // namespace

RegisterShortcut::RegisterShortcut(const Shortcut& shortcut) { registry().push_back(&shortcut); }

const Shortcut* shortcut_of(const Method& method) {
    const auto& all = registry();
    const auto at = std::find_if(all.begin(), all.end(), [&](const Shortcut* s) { return s->method == &method; });
    return at == all.end() ? nullptr : *at;
}

}  // namespace texelscope
