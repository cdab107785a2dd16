// texelscope list WHAT: lessons, methods, number formats, views, quirks.
#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "app/cli/command.h"
#include "app/cli/json_line.h"
#include "app/cli/output.h"
#include "app/shell/documents.h"
#include "app/views/view.h"
#include "core/method/method.h"
#include "core/scene/jelly_quirk.h"
#include "core/trace/listing.h"

namespace texelscope::list_command {
namespace {

/// What is listed: columns for people, and the same as an object for scripts.
struct Entry {
    std::vector<std::string> columns;
    JsonLine json;
};
using Entries = std::vector<Entry>;

std::string json_list(const std::vector<std::string>& items) { return fmt::format("[{}]", fmt::join(items, ",")); }

Entries lessons() {
    Entries entries;
    std::vector<Error> errors;
    for (const Lesson& lesson : built_in_lessons(errors)) {
        Entry e{{lesson.id, lesson.title, lesson.method}, {}};
        e.json.text("id", lesson.id)
            .text("title", lesson.title)
            .text("method", lesson.method)
            .text("summary", lesson.summary);
        entries.push_back(std::move(e));
    }
    for (const Error& error : errors) warn(error.text());
    return entries;
}

Entries method_entries() {
    Entries entries;
    for (const Method* method : methods()) {
        std::vector<std::string> variants, texts;
        for (const VariantInfo& v : method->variants) variants.emplace_back(v.id), texts.push_back(json_text(v.id));
        Entry e{{std::string(method->id), std::string(method->title), std::string(method->source),
                 fmt::format("{}", fmt::join(variants, " "))},
                {}};
        e.json.text("id", method->id).text("title", method->title).text("source", method->source);
        e.json.text("listing", method->listing)
            .raw("triangles", method->triangles ? "true" : "false")
            .raw("variants", json_list(texts));
        entries.push_back(std::move(e));
    }
    return entries;
}

Entries numbers() {
    Entries entries;
    for (const NumberFormatInfo& info : kNumberFormats) {
        Entry e{{std::string(info.id), std::string(info.title)}, {}};
        e.json.text("id", info.id).text("title", info.title);
        entries.push_back(std::move(e));
    }
    return entries;
}

Entries view_entries() {
    Entries entries;
    for (const View* view : views()) {
        Entry e{{std::string(view->name), std::string(view->title)}, {}};
        e.json.text("name", view->name).text("title", view->title);
        entries.push_back(std::move(e));
    }
    return entries;
}

/// @param of  the method's id, or what else has the quirk.
Entry quirk_entry(std::string_view of, const Listing& listing, const QuirkInfo& quirk) {
    Entry e{{std::string(of), std::string(quirk.id), std::string(quirk.field), std::string(quirk.sentence)}, {}};
    e.json.text("method", of).text("id", quirk.id).text("field", quirk.field).text("title", quirk.title);
    e.json.text("sentence", quirk.sentence).raw("form", quirk.kind == QuirkKind::form ? "true" : "false");
    if (const int line = guilty_line(listing, quirk); line > 0) {
        const std::string code = code_at(listing, line);
        e.columns.push_back(fmt::format("{}:{}: {}", listing.path, line, code));
        e.json.text("file", listing.path).number("line", line).text("code", code);
    }
    return e;
}

Entries quirks() {
    Entries entries;
    for (const Method* method : methods()) {
        const Listing listing = load_listing(method->listing);
        for (const QuirkInfo& quirk : method->quirks) entries.push_back(quirk_entry(method->id, listing, quirk));
    }
    entries.push_back(quirk_entry(kJellyCubes, load_listing(kJellyListing), kJellyQuirk));
    return entries;
}

struct Kind {
    std::string_view name;
    Entries (*entries)();
};
constexpr Kind kKinds[] = {{"lessons", lessons},
                           {"methods", method_entries},
                           {"numbers", numbers},
                           {"views", view_entries},
                           {"quirks", quirks}};

/// Letters, not bytes: columns hold Δ and ≤.
std::size_t letters(const std::string& text) {
    std::size_t count = 0;
    for (const char c : text) count += (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;
    return count;
}

std::string table(const Entries& entries) {
    std::vector<std::size_t> widths;
    for (const Entry& e : entries) {
        widths.resize(std::max(widths.size(), e.columns.size()));
        for (std::size_t n = 0; n < e.columns.size(); ++n) widths[n] = std::max(widths[n], letters(e.columns[n]));
    }
    std::string text;
    for (const Entry& e : entries) {
        for (std::size_t n = 0; n < e.columns.size(); ++n) {
            text += e.columns[n];
            if (n + 1 < e.columns.size()) text.append(widths[n] - letters(e.columns[n]) + 2, ' ');
        }
        text += '\n';
    }
    return text;
}

std::string json(const Entries& entries) {
    std::vector<std::string> objects;
    for (const Entry& e : entries) objects.push_back("  " + e.json.line());
    return fmt::format("[\n{}\n]\n", fmt::join(objects, ",\n"));
}

struct Options {
    std::string what, output;
    bool json = false;
};

int run(const Options& options) {
    for (const Kind& kind : kKinds) {
        if (kind.name != options.what) continue;
        auto output = Output::open(options.output);
        if (!output) return fail(output.error());
        const Entries entries = kind.entries();
        output->write(options.json ? json(entries) : table(entries));
        if (const auto error = output->finish()) return fail(*error);
    }
    return kExitDone;
}

std::function<int()> define(CLI::App& app) {
    const auto options = std::make_shared<Options>();
    std::vector<std::string> names;
    for (const Kind& kind : kKinds) names.emplace_back(kind.name);
    app.add_option("WHAT", options->what, "what to list")->required()->check(CLI::IsMember(names));
    app.add_option("-o,--output", options->output, "a file; stdout if absent or -");
    app.add_flag("--json", options->json, "as a JSON list");
    return [options] { return run(*options); };
}

constexpr Subcommand kCommand{"list", "list lessons, methods, numbers, views or quirks", define};
const RegisterCommand kRegistered(kCommand);

}  // namespace
}  // namespace texelscope::list_command
