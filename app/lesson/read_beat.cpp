#include "app/lesson/read_beat.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "app/lesson/facts.h"
#include "app/lesson/names.h"
#include "app/lesson/prose.h"
#include "app/lesson/questions.h"
#include "app/lesson/random_text.h"
#include "app/state/compared_run.h"
#include "core/fast/raster.h"
#include "core/measure/rungs.h"
#include "core/number/format.h"
#include "core/scene/jelly_quirk.h"
#include "core/trace/listing.h"

namespace texelscope {
namespace {

constexpr const char* kBetweenParagraphs = "\n\n";  // as the lesson's panel divides them

/// Two whole numbers divided by a comma.
[[nodiscard]] bool is_place(std::string_view text) {
    const std::size_t comma = text.find(',');
    const auto whole = [](std::string_view digits) {
        if (!digits.empty() && digits[0] == '-') digits.remove_prefix(1);
        return !digits.empty() && digits.size() < 7 && digits.find_first_not_of("0123456789") == digits.npos;
    };
    return comma != text.npos && whole(text.substr(0, comma)) && whole(text.substr(comma + 1));
}

void demand_pin(Fields& fields, const std::string& pin, const Method& method) {
    constexpr std::string_view kForms = "'pixel X,Y', 'texel X,Y', 'name NAME' or 'line TEXT'";
    const std::size_t space = std::min(pin.find(' '), pin.size());
    const std::string kind = pin.substr(0, space), what = pin.substr(std::min(space + 1, pin.size()));
    if (kind == "pixel" || kind == "texel") {
        if (!is_place(what)) fields.fail("pin", fmt::format("is '{}', expected '{} X,Y'", pin, kind));
    } else if (kind == "line") {
        if (what.empty() || find_line(method, load_listing(method.listing), what) == 0) {
            fields.fail("pin", fmt::format("is '{}', which stands nowhere in {}", pin, method.listing));
        }
    } else if (kind != "name" || what.empty()) {
        fields.fail("pin", fmt::format("is '{}', expected {}", pin, kForms));
    }
}

void demand_skip(Fields& fields, std::string_view skip) {
    std::vector<std::string_view> ids;
    for (const RasterSkipInfo& info : kRasterSkips) ids.push_back(info.id);
    if (std::find(ids.begin(), ids.end(), skip) == ids.end())
        fields.fail("skips", fmt::format("has '{}', expected {}", skip, one_of(ids)));
}

/// Why parse_path does not read it.
[[nodiscard]] std::string fault_of_path(std::string_view text, std::string_view example) {
    const std::size_t slash = text.find('/');
    const auto shape = parse_path(text.substr(0, slash));
    const bool leaps = shape && slash != text.npos && text.substr(slash + 1, 1) != "s";
    return fmt::format("is '{}', expected a path such as {}{}", text, example,
                       leaps ? fmt::format(": a stage (/s0) must stand behind {}", shape->text()) : "");
}

/// @param words  from here on those of the method that the block sets.
Result<BeatSettings> read_settings(const std::vector<TomlEntry>& entries, const std::string& file, int line,
                                   Vocabulary& words) {
    Fields fields(entries, file, "the set block", line);
    BeatSettings set;
    std::vector<std::string_view> ids;
    for (const Method* method : methods()) ids.push_back(method->id);
    set.method = fields.name_among("method", ids);
    if (const Method* found = set.method ? find_method(*set.method) : nullptr) words.method = found;
    if (const auto step = fields.text("step")) {
        set.step = parse_path(*step);
        if (!set.step) fields.fail("step", fault_of_path(*step, "t0/s5/y11/x7/e2"));
    }
    std::vector<std::string_view> levels, numbers, variants;
    for (int n = 0; n < kLevels; ++n) levels.push_back(id_of(static_cast<Level>(n)));
    for (const NumberFormatInfo& info : kNumberFormats) numbers.push_back(info.id);
    for (const VariantInfo& variant : words.method->variants) variants.push_back(variant.id);
    if (const auto level = fields.name_among("level", levels)) set.level = level_from(*level);
    set.number = fields.name_among("number", numbers);
    set.variant = fields.name_among("variant", variants);
    set.quirks = fields.switches("quirks").value_or(TomlSwitches{});
    for (const auto& [quirk, on] : set.quirks)
        if (quirk != kJellyQuirk.field) demand_quirk(fields, "quirks", quirk, words);
    set.pin = fields.text("pin");
    if (set.pin) demand_pin(fields, *set.pin, *words.method);
    if (const auto random = fields.text("random")) {
        set.random = parse_random(*random);
        if (!set.random) fields.fail("random", fmt::format("is '{}', expected {}", *random, random_form()));
    }
    if (const auto rung = fields.text("rung")) {
        set.rung = *rung;
        if (find_rung(*rung) == nullptr)
            fields.fail("rung",
                        fmt::format("is '{}', expected the id of a rung, as `texelscope front` lists them", *rung));
    }
    set.skips = fields.switches("skips").value_or(TomlSwitches{});
    for (const auto& [skip, on] : set.skips) demand_skip(fields, skip);
    set.play = fields.truth("play");
    set.hits = fields.truth("hits");
    set.against = fields.text("against");
    if (set.against) {
        if (const auto run = parse_run(*set.against); !run) fields.fail("against", run.error().what);
    }
    if (const auto views = fields.texts("views")) set.views = *views, demand_views(fields, "views", set.views, words);
    fields.demand_known();
    if (fields.fault()) return *fields.fault();
    set.lines = fields.lines();
    return set;
}

void read_options(Fields& fields, Prediction& asked, const Question& question) {
    asked.options = fields.texts("options").value_or(std::vector<std::string>{});
    const int expected = option_count(question);
    if (static_cast<int>(asked.options.size()) != expected) {
        return fields.fail("options", fmt::format("has {} texts, but '{}' has {}: {}", asked.options.size(),
                                                  question.name, expected, question.options));
    }
    int all = 0;
    for (const std::string& option : asked.options) {
        if (const auto fault = fault_of_prose(option))
            fields.fail("options", fmt::format("cannot be shown: {}", *fault));
        const int length = visible_length(option);
        if (length == 0 || length > kMaxOption)
            fields.fail("options", fmt::format("has '{}', expected 1 to {} letters", option, kMaxOption));
        all += length;
    }
    if (all > kMaxAllOptions)
        fields.fail("options", fmt::format("are {} letters long together, expected at most {}", all, kMaxAllOptions));
}

Result<Prediction> read_prediction(const std::vector<TomlEntry>& entries, const std::string& file, int line,
                                   const Vocabulary& words) {
    Fields fields(entries, file, "the predict block", line);
    Prediction asked{.lines = fields.lines()};
    asked.ask = fields.prose("ask", kMaxAsk);
    const auto kind = fields.name_among("kind", {kKindNames.begin(), kKindNames.end()});
    const auto answer = fields.text("answer");
    if (!kind) fields.missing("kind");
    if (!answer) fields.missing("answer");
    if (fields.fault()) return *fields.fault();
    asked.kind =
        static_cast<Prediction::Kind>(std::find(kKindNames.begin(), kKindNames.end(), *kind) - kKindNames.begin());
    asked.answer = *answer;
    const auto call = parse_question(asked.answer, *words.method);
    if (!call) return fields.fail("answer", call.error().what), *fields.fault();
    const Question& question = *call->question;
    if (question.kind != asked.kind) {
        fields.fail("kind",
                    fmt::format("is '{}', but '{}' is answered by '{}'", *kind, question.name, name_of(question.kind)));
    }
    read_options(fields, asked, question);
    asked.explain = fields.text("explain").value_or("auto");
    if (asked.explain != "auto" && !parse_path(asked.explain)) {
        fields.fail("explain", fault_of_path(asked.explain, "t0/s5/y11/x7, or auto"));
    }
    fields.demand_known();
    if (fields.fault()) return *fields.fault();
    return asked;
}

class BeatsReader {
public:
    BeatsReader(const std::string& file, const Vocabulary& words) : file_(file), words_(words) {}

    std::optional<Error> take(const MarkdownBlock& block) {
        if (block.kind == MarkdownBlock::Kind::heading) return begin(block);
        if (beats_.empty())
            return fault(block.line, "something before the first beat, expected a heading of level 2 (##)");
        if (block.kind == MarkdownBlock::Kind::paragraph) return paragraph(block);
        if (block.info == "set") return settings(block);
        if (block.info == "predict") return prediction(block);
        return fault(block.line, fmt::format("a block '{}', expected set or predict", block.info));
    }
    [[nodiscard]] std::vector<Beat>& beats() { return beats_; }
    [[nodiscard]] Error fault(int line, std::string what) const {
        return {fmt::format("{}:{}", file_, line), std::move(what)};
    }

private:
    std::optional<Error> begin(const MarkdownBlock& block) {
        if (beats_.size() == kMaxBeats) return fault(block.line, fmt::format("more than {} beats", kMaxBeats));
        const int length = visible_length(block.text);
        if (length == 0) return fault(block.line, "an empty heading, expected the beat's first sentence");
        if (length > kMaxLead)
            return fault(block.line,
                         fmt::format("a first sentence of {} letters, expected at most {}", length, kMaxLead));
        beats_.push_back({.lead = block.text, .prose = {}, .set = {}, .prediction = {}, .line = block.line});
        has_settings_ = false;
        return std::nullopt;
    }
    std::optional<Error> paragraph(const MarkdownBlock& block) {
        if (block.text.empty()) return std::nullopt;
        std::string& prose = beats_.back().prose;
        prose += (prose.empty() ? "" : kBetweenParagraphs) + block.text;
        const int length = visible_length(prose);
        if (length > kMaxProse)
            return fault(block.line,
                         fmt::format("the beat's prose is {} letters long, expected at most {}", length, kMaxProse));
        return std::nullopt;
    }
    std::optional<Error> settings(const MarkdownBlock& block) {
        if (has_settings_) return fault(block.line, "a second set block in this beat");
        const auto entries = parse_toml_table(block.text, file_, block.line + 1);
        if (!entries) return entries.error();
        auto set = read_settings(*entries, file_, block.line, words_);
        if (!set) return set.error();
        if (set->method && beats_.back().prediction)
            return fault(block.line, "sets a method behind the predict block, which is about it: expected before it");
        beats_.back().set = *std::move(set);
        has_settings_ = true;
        return std::nullopt;
    }
    std::optional<Error> prediction(const MarkdownBlock& block) {
        if (beats_.back().prediction) return fault(block.line, "a second predict block in this beat");
        const auto entries = parse_toml_table(block.text, file_, block.line + 1);
        if (!entries) return entries.error();
        auto asked = read_prediction(*entries, file_, block.line, words_);
        if (!asked) return asked.error();
        beats_.back().prediction = *std::move(asked);
        return std::nullopt;
    }

    const std::string& file_;
    Vocabulary words_;  ///< those of the beat's method
    std::vector<Beat> beats_;
    bool has_settings_ = false;
};

}  // namespace

void demand_quirk(Fields& fields, std::string_view key, std::string_view quirk, const Vocabulary& words) {
    if (quirk_number(*words.method, quirk)) return;
    std::vector<std::string_view> names;
    for (const QuirkInfo& info : words.method->quirks) names.push_back(info.field);
    const std::string found = unreadable_at(quirk) == quirk.npos ? std::string(quirk.substr(0, quirk.find('\n'))) : "?";
    fields.fail(key, fmt::format("has '{}', expected {}", found, one_of(names)));
}

void demand_views(Fields& fields, std::string_view key, const std::vector<std::string>& views,
                  const Vocabulary& words) {
    if (views.empty() || views.size() > kMaxViews)
        fields.fail(key, fmt::format("has {} names, expected 1 to {}", views.size(), kMaxViews));
    for (auto view = views.begin(); view != views.end(); ++view) {
        if (std::find(views.begin(), view, *view) != view) fields.fail(key, fmt::format("has '{}' twice", *view));
    }
    for (const std::string& view : views) {
        const bool formed =
            !view.empty() && view.find_first_not_of("abcdefghijklmnopqrstuvwxyz-0123456789") == view.npos;
        const bool known =
            words.views.empty() ? formed : std::find(words.views.begin(), words.views.end(), view) != words.views.end();
        if (known) continue;
        const std::vector<std::string_view> names(words.views.begin(), words.views.end());
        fields.fail(key,
                    fmt::format("has '{}', expected {}", view, names.empty() ? "the name of a view" : one_of(names)));
    }
}

Result<std::vector<Beat>> read_beats(const std::vector<MarkdownBlock>& blocks, const std::string& file, int line,
                                     const Vocabulary& words) {
    BeatsReader reader(file, words);
    for (const MarkdownBlock& block : blocks) {
        if (const auto fault = reader.take(block)) return *fault;
    }
    if (reader.beats().empty()) return reader.fault(line, "no beats, expected a heading of level 2 (##)");
    return std::move(reader.beats());
}

}  // namespace texelscope
