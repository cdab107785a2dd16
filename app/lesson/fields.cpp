#include "app/lesson/fields.h"

#include <algorithm>

#include <fmt/format.h>

#include "app/lesson/prose.h"

namespace texelscope {

bool KeyLines::has(std::string_view key) const {
    return std::any_of(keys.begin(), keys.end(), [&](const auto& entry) { return entry.first == key; });
}

int KeyLines::of(std::string_view key) const {
    const auto found = std::find_if(keys.begin(), keys.end(), [&](const auto& entry) { return entry.first == key; });
    return found == keys.end() ? block : found->second;
}

std::string one_of(const std::vector<std::string_view>& names) {
    std::string out;
    for (std::size_t n = 0; n < names.size(); ++n) {
        out += n == 0 ? "" : n + 1 == names.size() ? " or " : ", ";
        out += names[n];
    }
    return out;
}

void Fields::fail_at(int line, std::string what) {
    if (!fault_) fault_ = Error{fmt::format("{}:{}", file_, line), std::move(what)};
}

int Fields::line_of(std::string_view key) const {
    for (const TomlEntry& entry : entries_) {
        if (entry.key == key) return entry.line;
    }
    return line_;
}

KeyLines Fields::lines() const {
    KeyLines lines{line_};
    for (const TomlEntry& entry : entries_) lines.keys.emplace_back(entry.key, entry.line);
    return lines;
}

void Fields::fail(std::string_view key, std::string_view what) {
    fail_at(line_of(key), fmt::format("{} {}", key, what));
}

void Fields::missing(std::string_view key) { fail_at(line_, fmt::format("{} has no '{}'", what_, key)); }

template <class T>
std::optional<T> Fields::take(std::string_view key, std::string_view kind) {
    asked_.push_back(key);
    for (const TomlEntry& entry : entries_) {
        if (entry.key != key) continue;
        if (const T* value = std::get_if<T>(&entry.value)) return *value;
        fail(key, fmt::format("is of another type, expected {}", kind));
    }
    return std::nullopt;
}

std::optional<std::string> Fields::text(std::string_view key) {
    auto text = take<std::string>(key, "a text");
    if (text && unreadable_at(*text) != std::string::npos) fail(key, "holds a control character");
    if (text && text->find_first_of("\n\t") != std::string::npos)
        fail(key, "holds a line break or a tab, expected one line");
    return text;
}

std::optional<bool> Fields::truth(std::string_view key) { return take<bool>(key, "true or false"); }

std::optional<std::vector<std::string>> Fields::texts(std::string_view key) {
    auto texts = take<std::vector<std::string>>(key, "a list of texts");
    for (const std::string& text : texts.value_or(std::vector<std::string>{})) {
        if (unreadable_at(text) != std::string::npos) fail(key, "holds a control character");
        if (text.find_first_of("\n\t") != std::string::npos) fail(key, "holds a line break or a tab");
    }
    return texts;
}

std::optional<TomlSwitches> Fields::switches(std::string_view key) {
    return take<TomlSwitches>(key, "a table of switches: { name = true }");
}

std::string Fields::prose(std::string_view key, int longest) {
    const auto text = this->text(key);
    if (!text) return missing(key), std::string{};
    if (const auto fault = fault_of_prose(*text)) fail(key, fmt::format("cannot be shown: {}", *fault));
    const int length = visible_length(*text);
    if (length == 0) fail(key, "is empty");
    if (length > longest) fail(key, fmt::format("is {} letters long, expected at most {}", length, longest));
    return *text;
}

std::optional<std::string> Fields::name_among(std::string_view key, const std::vector<std::string_view>& names) {
    auto name = text(key);
    if (name && std::find(names.begin(), names.end(), *name) == names.end()) {
        fail(key, fmt::format("is '{}', expected {}", *name, one_of(names)));
    }
    return name;
}

void Fields::demand_known() {
    for (const TomlEntry& entry : entries_) {
        if (std::find(asked_.begin(), asked_.end(), entry.key) != asked_.end()) continue;
        const std::string key = unreadable_at(entry.key) == std::string::npos ? entry.key : std::string("?");
        fail_at(entry.line,
                fmt::format("{} has no key '{}', expected {}", what_, key.substr(0, key.find('\n')), one_of(asked_)));
    }
}

}  // namespace texelscope
