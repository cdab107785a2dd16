#include "core/method/method.h"

#include <algorithm>

namespace texelscope {
namespace {

std::vector<const Method*>& registry() {
    static std::vector<const Method*> methods;
    return methods;
}

}  // namespace

RegisterMethod::RegisterMethod(const Method& method) {
    auto& all = registry();
    const auto place = std::find_if(all.begin(), all.end(), [&](const Method* m) { return m->id > method.id; });
    all.insert(place, &method);
}

std::span<const Method* const> methods() { return registry(); }

const Method* find_method(std::string_view id) {
    for (const Method* method : methods()) {
        if (method->id == id) return method;
    }
    return nullptr;
}

const VariantInfo* find_variant(const Method& method, std::string_view id) {
    for (const VariantInfo& variant : method.variants) {
        if (variant.id == id) return &variant;
    }
    return nullptr;
}

QuirkSet quirks_of(const Method& method, std::string_view variant) {
    const VariantInfo* found = find_variant(method, variant);
    return found != nullptr ? found->quirks : method.variants.back().quirks;
}

}  // namespace texelscope
