// Reads a lesson: +++ front matter +++, then beats in Markdown.
#include <algorithm>
#include <array>
#include <cctype>
#include <system_error>

#include <fmt/format.h>

#include "app/lesson/fields.h"
#include "app/lesson/lesson.h"
#include "app/lesson/markdown.h"
#include "app/lesson/names.h"
#include "app/lesson/prose.h"
#include "app/lesson/questions.h"
#include "app/lesson/read_beat.h"
#include "core/method/method.h"
#include "core/number/format.h"

namespace texelscope {
namespace {

constexpr std::string_view kFence = "+++";

/// The two parts of a lesson file.
struct Parts {
    std::string_view front, body;
    int body_line = 0;
};

/// The line that begins at the front of `text`, which then begins with the next one.
[[nodiscard]] std::string_view take_line(std::string_view& text) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    return line;
}

Result<Parts> split(std::string_view text, const std::string& file) {
    std::string_view rest = text;
    if (take_line(rest) != kFence)
        return Error{file + ":1", "the first line is not +++, which begins the front matter"};
    const std::string_view front = rest;
    for (int line = 2; !rest.empty(); ++line) {
        const std::string_view before = rest;
        if (take_line(rest) != kFence) continue;
        return Parts{front.substr(0, static_cast<std::size_t>(before.data() - front.data())), rest, line + 1};
    }
    return Error{file + ":1", "the front matter has no end, expected a second line +++"};
}

/// The text with plain line ends and no byte order mark, or the place of what is no text.
Result<std::string> plain_text(std::string_view text, const std::string& file) {
    if (text.size() > kMaxLessonBytes)
        return Error{file + ":1", fmt::format("is longer than {} bytes", kMaxLessonBytes)};
    constexpr std::string_view kMark = "\xEF\xBB\xBF";
    if (text.substr(0, kMark.size()) == kMark) text.remove_prefix(kMark.size());
    std::string plain;
    for (std::size_t n = 0; n < text.size(); ++n) {
        if (text[n] != '\r' || n + 1 == text.size() || text[n + 1] != '\n') plain += text[n];
    }
    const std::size_t bad = unreadable_at(plain);
    if (bad == std::string::npos) return plain;
    const auto line = 1 + std::count(plain.begin(), plain.begin() + static_cast<std::ptrdiff_t>(bad), '\n');
    return Error{fmt::format("{}:{}", file, line), "a byte that is not UTF-8 text"};
}

[[nodiscard]] bool is_file_name(std::string_view name) {
    return !name.empty() && name.size() <= 64 && name.find_first_of("/\\:") == name.npos && name != "." && name != "..";
}

/// 5 of "05-half-planes"; 0 where the folder has no number.
[[nodiscard]] int number_of(std::string_view id) {
    const auto digit = [&](std::size_t n) {
        return n < id.size() && std::isdigit(static_cast<unsigned char>(id[n])) != 0;
    };
    return digit(0) && digit(1) && id.size() > 3 && id[2] == '-' ? (id[0] - '0') * 10 + (id[1] - '0') : 0;
}

[[nodiscard]] bool are_levels(std::string_view levels) {
    constexpr std::string_view kLetters = "TGSPE";
    std::size_t from = 0;
    for (const char c : levels) {
        const std::size_t at = kLetters.find(c, from);
        if (at == kLetters.npos) return false;
        from = at + 1;
    }
    return !levels.empty();
}

void read_method(Fields& fields, Lesson& lesson, Vocabulary& words) {
    std::vector<std::string_view> ids, variants, numbers;
    for (const Method* method : methods()) ids.push_back(method->id);
    for (const NumberFormatInfo& info : kNumberFormats) numbers.push_back(info.id);
    const auto id = fields.name_among("method", ids);
    words.method = id ? find_method(*id) : nullptr;
    if (!id) fields.missing("method");
    if (words.method == nullptr) return;
    for (const VariantInfo& variant : words.method->variants) variants.push_back(variant.id);
    lesson.method = *id;
    lesson.variant = fields.name_among("variant", variants).value_or(std::string(variants.back()));
    lesson.format = fields.name_among("number", numbers).value_or(std::string(id_of(NumberFormat::f64)));
    lesson.quirks = fields.texts("quirks").value_or(std::vector<std::string>{});
    for (const std::string& quirk : lesson.quirks) demand_quirk(fields, "quirks", quirk, words);
}

std::optional<Error> read_front(const std::vector<TomlEntry>& entries, const std::string& file, Lesson& lesson,
                                Vocabulary& words) {
    Fields fields(entries, file, "the front matter", 1);
    lesson.title = fields.prose("title", kMaxTitle);
    lesson.group = fields.prose("group", kMaxGroup);
    lesson.summary = fields.prose("summary", kMaxSummary);
    lesson.icon = fields.name_among("icon", {kIconNames.begin(), kIconNames.end()}).value_or("");
    read_method(fields, lesson, words);
    if (words.method == nullptr) return fields.fault();
    lesson.scene = fields.text("scene").value_or("scene.json");
    if (!is_file_name(lesson.scene))
        fields.fail("scene", fmt::format("is '{}', expected a file beside the lesson", lesson.scene));
    if (const auto views = fields.texts("views"))
        lesson.views = *views, demand_views(fields, "views", lesson.views, words);
    else
        fields.missing("views");
    lesson.levels = fields.text("levels").value_or("TGSPE");
    if (!are_levels(lesson.levels))
        fields.fail("levels", fmt::format("is '{}', expected letters of TGSPE in this order", lesson.levels));
    lesson.drag = fields.name_among("drag", {"vertices", "screen", "texture", "none"}).value_or("vertices");
    fields.demand_known();
    lesson.lines = fields.lines();
    return fields.fault();
}

Result<Lesson> read_lesson(std::string_view text, const std::filesystem::path& path, Vocabulary words) {
    const std::string file = path.string();
    const auto plain = plain_text(text, file);
    if (!plain) return plain.error();
    const auto parts = split(*plain, file);
    if (!parts) return parts.error();
    Lesson lesson;
    lesson.file = path;
    std::error_code ignored;
    lesson.id = std::filesystem::absolute(path, ignored).lexically_normal().parent_path().filename().string();
    lesson.number = number_of(lesson.id);
    const auto front = parse_toml_table(parts->front, file, 2);
    if (!front) return front.error();
    if (const auto fault = read_front(*front, file, lesson, words)) return *fault;
    const auto blocks = parse_markdown(parts->body, file, parts->body_line);
    if (!blocks) return blocks.error();
    auto beats = read_beats(*blocks, file, parts->body_line, words);
    if (!beats) return beats.error();
    lesson.beats = *std::move(beats);
    return lesson;
}

}  // namespace

Result<Lesson> parse_lesson(std::string_view text, const std::filesystem::path& file,
                            std::span<const std::string_view> view_names) {
    return read_lesson(text, file, {nullptr, view_names});
}

}  // namespace texelscope
