#include "app/cli/draw_options.h"

#include <array>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "app/cli/suggestion.h"
#include "core/geometry/snap.h"

namespace texelscope {
namespace {

constexpr int kMaxThreads = 1024;
constexpr std::array<std::string_view, 3> kOverflows{"mark", "saturate", "wrap"};  // in the order of Overflow

/// "a, b or c".
std::string listed(const std::vector<std::string_view>& words) {
    std::string text;
    for (std::size_t n = 0; n < words.size(); ++n)
        text += fmt::format("{}{}", n == 0 ? "" : n + 1 < words.size() ? ", " : " or ", words[n]);
    return text;
}

struct Switch {
    std::string_view id;
    bool on = false;
};
/// Reads "ID=on" or "ID=off".
std::optional<Switch> switch_from(std::string_view text) {
    const std::size_t equals = text.rfind('=');
    if (equals == text.npos || equals == 0) return std::nullopt;
    const std::string_view state = text.substr(equals + 1);
    if (state != "on" && state != "off") return std::nullopt;
    return Switch{text.substr(0, equals), state == "on"};
}

Error unknown(std::string_view what, std::string_view word, const std::vector<std::string_view>& words) {
    const std::string_view near = nearest_word(word, words);
    return {"", fmt::format("{} '{}' is not known, expected {}{}", what, word, listed(words),
                            near.empty() ? "" : fmt::format("; did you mean {}?", near))};
}

/// The quirks of the variant with the switches applied.
Result<QuirkSet> switched_quirks(const Method& method, QuirkSet quirks, const std::vector<std::string>& switches) {
    for (const std::string& text : switches) {
        const auto s = switch_from(text);
        if (!s) return Error{"", fmt::format("--quirk '{}', expected ID=on or ID=off", text)};
        bool found = false;
        for (std::size_t n = 0; n < method.quirks.size() && !found; ++n) {
            if (s->id != method.quirks[n].id && s->id != method.quirks[n].field) continue;
            found = true;
            const QuirkSet bit = QuirkSet{1} << n;
            quirks = s->on ? quirks | bit : quirks & ~bit;
        }
        if (found) continue;
        std::vector<std::string> names;
        for (const QuirkInfo& quirk : method.quirks)
            names.push_back(quirk.id == quirk.field ? std::string(quirk.id)
                                                    : fmt::format("{} ({})", quirk.id, quirk.field));
        const std::string there_are =
            names.empty() ? "it has none" : fmt::format("expected {}", listed({names.begin(), names.end()}));
        return Error{"", fmt::format("--quirk '{}': {} has no such quirk, {}", s->id, method.id, there_are)};
    }
    return quirks;
}

std::optional<Error> check_skips(const Method& method, const std::vector<std::string>& switches) {
    if (switches.empty()) return std::nullopt;
    const auto s = switch_from(switches[0]);
    if (!s) return Error{"", fmt::format("--skip '{}', expected NAME=on or NAME=off", switches[0])};
    return Error{"", fmt::format("--skip '{}': {} has no such skip, it has none", s->id, method.id)};
}

}  // namespace

void add_draw_options(CLI::App& app, DrawOptions& options) {
    app.add_option("--method", options.method, "see `texelscope list methods`")->capture_default_str();
    app.add_option("--variant", options.variant, "as-printed, as-published where there is one, or corrected")
        ->capture_default_str();
    app.add_option("--number", options.number, "number format: f64, f32, fx16.16, fx8.8 or exact")
        ->capture_default_str();
    app.add_option("--overflow", options.overflow, "fixed point beyond its range: mark, saturate or wrap")
        ->check(CLI::IsMember(std::vector<std::string>(kOverflows.begin(), kOverflows.end())))
        ->capture_default_str();
    app.add_flag("--floor-products", options.floor_products, "fixed-point products round down, as a bare shift does");
    app.add_option("--snap", options.snap, "round x, y to multiples of 2^-B first")
        ->check(CLI::Range(0, kMaxSnapBits))
        ->type_name("B");
    app.add_option("--quirk", options.quirks, "switch a quirk, see `texelscope list quirks`; may be repeated")
        ->type_name("ID=on|off")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    app.add_option("--skip", options.skips, "switch a skip of the method; may be repeated")
        ->type_name("NAME=on|off")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    app.add_option("--target", options.target, "instruction set of the method `fast`")
        ->check(CLI::IsMember({"sse4", "avx2", "avx512"}));
    app.add_option("--threads", options.threads, "most threads; 0: as many as the machine has")
        ->check(CLI::Range(0, kMaxThreads));
}

Result<DrawSettings> draw_settings(const DrawOptions& options) {
    DrawSettings settings;
    settings.method = find_method(options.method);
    if (settings.method == nullptr) {
        std::vector<std::string_view> ids;
        for (const Method* method : methods()) ids.push_back(method->id);
        return unknown("method", options.method, ids);
    }
    const Method& method = *settings.method;
    const VariantInfo* variant = find_variant(method, options.variant);
    if (variant == nullptr) {
        std::vector<std::string_view> ids;
        for (const VariantInfo& v : method.variants) ids.push_back(v.id);
        return unknown(fmt::format("variant of {}", method.id), options.variant, ids);
    }
    const auto format = number_format(options.number);
    if (!format) {
        std::vector<std::string_view> ids;
        for (const NumberFormatInfo& info : kNumberFormats) ids.push_back(info.id);
        return unknown("number format", options.number, ids);
    }
    settings.format = *format;
    const auto quirks = switched_quirks(method, variant->quirks, options.quirks);
    if (!quirks) return quirks.error();
    settings.quirks = *quirks;
    if (const auto error = check_skips(method, options.skips)) return *error;
    if (!options.target.empty() && method.id != "fast")
        return Error{"", fmt::format("--target is for the method fast, not for {}", method.id)};
    for (std::size_t n = 0; n < kOverflows.size(); ++n) {
        if (kOverflows[n] == options.overflow) settings.mode.overflow = static_cast<Overflow>(n);
    }
    settings.mode.floor_products = options.floor_products;
    return settings;
}

void snap_scene(Scene& scene, const DrawOptions& options) {
    if (!options.snap) return;
    for (Polygon& polygon : scene.polygons) polygon = snapped(std::move(polygon), *options.snap);
}

}  // namespace texelscope
