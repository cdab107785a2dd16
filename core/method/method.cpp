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

const Method& default_method() {
    const Method* const heart = find_method("edge-equations");
    return heart != nullptr ? *heart : *methods().front();
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

int guilty_line(const Listing& listing, const QuirkInfo& quirk) {
    const std::string mark = "// " + std::string(quirk.id);
    for (std::size_t n = 0; n < listing.lines.size(); ++n) {
        const std::string& line = listing.lines[n];
        if (line.size() > mark.size() && line.compare(line.size() - mark.size(), mark.size(), mark) == 0)
            return static_cast<int>(n) + 1;
    }
    return line_with(listing, "quirk." + std::string(quirk.field));
}

int find_line(const Method& method, const Listing& listing, std::string_view text) {
    const auto meant = std::find_if(method.quirks.begin(), method.quirks.end(), [&](const QuirkInfo& quirk) {
        return text == "quirk." + std::string(quirk.field);
    });
    return meant != method.quirks.end() ? guilty_line(listing, *meant) : line_with(listing, text);
}

}  // namespace texelscope
