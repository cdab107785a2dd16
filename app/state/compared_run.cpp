#include "app/state/compared_run.h"

#include <algorithm>

#include <fmt/format.h>

namespace texelscope {
namespace {

constexpr std::string_view kUsual = "barycentric", kUsualBeside = "edge-equations";

[[nodiscard]] Error unknown(std::string_view word, std::string_view expected) {
    return {"", fmt::format("has '{}', expected {}", word, expected)};
}

}  // namespace

Result<ComparedRun> parse_run(std::string_view words) {
    ComparedRun run;
    const Method* method = nullptr;
    while (!words.empty()) {
        const std::size_t end = std::min(words.find(' '), words.size());
        const std::string_view word = words.substr(0, end);
        words.remove_prefix(std::min(end + 1, words.size()));
        if (method == nullptr) {
            method = find_method(word);
            if (method == nullptr) return unknown(word, "the id of a method");
            run.method = word;
        } else if (run.variant.empty() && !run.format && find_variant(*method, word) != nullptr) {
            run.variant = word;
        } else if (const auto format = number_format(word); format && !run.format) {
            run.format = format;
        } else {
            return unknown(word, fmt::format("{} with a variant of it, then a number format", method->id));
        }
    }
    if (method == nullptr) return unknown("", "the id of a method");
    return run;
}

std::string text_of(const ComparedRun& run) {
    if (run.method.empty()) return {};
    std::string text = run.method;
    if (!run.variant.empty()) text += " " + run.variant;
    if (run.format) text += fmt::format(" {}", id_of(*run.format));
    return text;
}

DrawSettings settings_of(const ComparedRun& run, const DrawSettings& own) {
    DrawSettings settings = own;
    const std::string_view usual = own.method->id == kUsual ? kUsualBeside : kUsual;
    const Method* method = find_method(run.method);
    settings.method = method != nullptr ? method : find_method(usual);
    settings.quirks = quirks_of(*settings.method, run.variant);
    settings.format = run.format.value_or(own.format);
    return settings;
}

ComparedRun completed(const ComparedRun& run, const DrawSettings& own) {
    const DrawSettings settings = settings_of(run, own);
    const VariantInfo* variant = find_variant(*settings.method, run.variant);
    return {std::string(settings.method->id),
            std::string(variant != nullptr ? variant->id : settings.method->variants.back().id), settings.format};
}

}  // namespace texelscope
