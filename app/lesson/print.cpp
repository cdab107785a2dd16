// Writes a lesson as the text that parse_lesson reads.
#include <algorithm>

#include <fmt/format.h>

#include "app/lesson/lesson.h"
#include "app/lesson/names.h"
#include "app/lesson/random_text.h"
#include "app/ui/prose.h"

namespace texelscope {
namespace {

/// A TOML text on one line.
[[nodiscard]] std::string toml_text(std::string_view text) {
    std::string out = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') out += '\\';
        out += c;
    }
    return out + '"';
}

[[nodiscard]] std::string list(const std::vector<std::string>& texts) {
    std::string out = "[";
    for (std::size_t n = 0; n < texts.size(); ++n) out += (n == 0 ? "" : ", ") + toml_text(texts[n]);
    return out + ']';
}

[[nodiscard]] std::string pair(std::string_view key, std::string_view value) {
    return fmt::format("{} = {}\n", key, value);
}

/// Plain letters as Markdown that means just them.
[[nodiscard]] std::string escaped_words(std::string_view text) {
    std::string out;
    for (const char c : text) {
        if (std::string_view("\\$*`_[]<&#~!").find(c) != std::string_view::npos) out += '\\';
        out += c;
    }
    return out;
}

/// A paragraph as Markdown.
[[nodiscard]] std::string markdown(std::string_view prose) {
    std::string out;
    for (const ui::Span& span : ui::spans_of(prose)) {
        switch (span.kind) {
            case ui::Span::Kind::text: out += escaped_words(span.text); break;
            case ui::Span::Kind::strong: out += "**" + escaped_words(span.text) + "**"; break;
            case ui::Span::Kind::code: out += '`' + span.text + '`'; break;
            case ui::Span::Kind::math: out += '$' + span.text + '$'; break;
        }
    }
    // What would begin a list, a quotation or an underline of a heading.
    const std::size_t mark = out.find_first_not_of("0123456789");
    if (mark != std::string::npos && std::string_view("-+>=.)|:").find(out[mark]) != std::string_view::npos)
        out.insert(mark, "\\");
    return out;
}

/// "{ inclusive = true, Q6 = false }"; empty where there are none.
[[nodiscard]] std::string switches(const std::vector<std::pair<std::string, bool>>& all) {
    std::string text;
    for (const auto& [name, on] : all) text += fmt::format("{}{} = {}", text.empty() ? "" : ", ", name, on);
    return text.empty() ? text : fmt::format("{{ {} }}", text);
}

[[nodiscard]] std::string print(const BeatSettings& set) {
    std::string out;
    if (set.step) out += pair("step", toml_text(set.step->text()));
    if (set.level) out += pair("level", toml_text(id_of(*set.level)));
    if (set.method) out += pair("method", toml_text(*set.method));
    if (set.number) out += pair("number", toml_text(*set.number));
    if (set.variant) out += pair("variant", toml_text(*set.variant));
    if (const std::string quirks = switches(set.quirks); !quirks.empty()) out += pair("quirks", quirks);
    if (set.pin) out += pair("pin", toml_text(*set.pin));
    if (set.random) out += pair("random", toml_text(text_of(*set.random)));
    if (set.rung) out += pair("rung", toml_text(*set.rung));
    if (const std::string skips = switches(set.skips); !skips.empty()) out += pair("skips", skips);
    if (set.play) out += pair("play", *set.play ? "true" : "false");
    if (set.hits) out += pair("hits", *set.hits ? "true" : "false");
    if (set.against) out += pair("against", toml_text(*set.against));
    if (!set.views.empty()) out += pair("views", list(set.views));
    return out.empty() ? out : fmt::format("\n```set\n{}```\n", out);
}

[[nodiscard]] std::string print(const Prediction& asked) {
    std::string out = pair("ask", toml_text(asked.ask)) + pair("kind", toml_text(name_of(asked.kind)));
    if (!asked.options.empty()) out += pair("options", list(asked.options));
    out += pair("answer", toml_text(asked.answer));
    if (asked.explain != "auto") out += pair("explain", toml_text(asked.explain));
    return fmt::format("\n```predict\n{}```\n", out);
}

[[nodiscard]] std::string print(const Beat& beat) {
    std::string out = fmt::format("\n## {}\n", markdown(beat.lead));
    for (std::size_t at = 0; at < beat.prose.size();) {
        const std::size_t end = std::min(beat.prose.find('\n', at), beat.prose.size());
        if (end > at) out += fmt::format("\n{}\n", markdown(beat.prose.substr(at, end - at)));
        at = end + 1;
    }
    out += print(beat.set);
    return beat.prediction ? out + print(*beat.prediction) : out;
}

}  // namespace

std::string print_lesson(const Lesson& lesson) {
    std::string out = "+++\n";
    out += pair("title", toml_text(lesson.title)) + pair("group", toml_text(lesson.group));
    if (!lesson.icon.empty()) out += pair("icon", toml_text(lesson.icon));
    out += pair("summary", toml_text(lesson.summary));
    out += pair("method", toml_text(lesson.method)) + pair("variant", toml_text(lesson.variant));
    out += pair("number", toml_text(lesson.format)) + pair("scene", toml_text(lesson.scene));
    out += pair("views", list(lesson.views)) + pair("levels", toml_text(lesson.levels));
    out += pair("drag", toml_text(lesson.drag)) + pair("quirks", list(lesson.quirks)) + "+++\n";
    for (const Beat& beat : lesson.beats) out += print(beat);
    return out;
}

}  // namespace texelscope
