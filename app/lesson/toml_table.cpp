#include "app/lesson/toml_table.h"

#include <algorithm>
#include <cctype>

#include <fmt/format.h>
#include <toml++/toml.h>

namespace texelscope {
namespace {

constexpr std::string_view kKinds = "a text, true or false, a list of texts, or a table of switches";

/// One line, whatever the parser quotes.
[[nodiscard]] std::string one_line(std::string_view text) {
    std::string line(text);
    for (char& c : line) {
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) c = ' ';
    }
    return line;
}

/// Whether line `number` of `text`, counted from 1, gives a key a word without quotes.
[[nodiscard]] bool has_bare_word(std::string_view text, std::size_t number) {
    for (; number > 1; --number) text.remove_prefix(std::min(text.find('\n'), text.size() - 1) + 1);
    const std::string_view line = text.substr(0, text.find('\n'));
    const std::size_t equals = line.find('=');
    if (equals == line.npos) return false;
    const std::string_view value = line.substr(std::min(line.find_first_not_of(" \t", equals + 1), line.size()));
    const std::string_view word = value.substr(0, value.find_first_of(" \t#"));
    return !word.empty() && std::isalpha(static_cast<unsigned char>(word[0])) != 0 && word != "true" && word != "false";
}

class TableReader {
public:
    TableReader(const std::string& file, int first_line) : file_(file), before_(first_line - 1) {}

    Result<std::vector<TomlEntry>> read(std::string_view text) {
        try {
            const toml::table table = toml::parse(text);
            return entries(table);
        } catch (const toml::parse_error& fault) {
            const bool bare = has_bare_word(text, static_cast<std::size_t>(fault.source().begin.line));
            return Error{place(fault.source()),
                         one_line(fault.description()) + (bare ? ": a text needs quotes, as in key = \"text\"" : "")};
        }
    }

private:
    [[nodiscard]] int line(const toml::source_region& region) const {
        return before_ + std::max(1, static_cast<int>(region.begin.line));
    }
    [[nodiscard]] std::string place(const toml::source_region& region) const {
        return fmt::format("{}:{}", file_, line(region));
    }
    [[nodiscard]] Error wrong(const toml::node& node, std::string_view key, std::string_view expected) const {
        return {place(node.source()), fmt::format("'{}' is not {}", one_line(key), expected)};
    }

    Result<std::vector<TomlEntry>> entries(const toml::table& table) const {
        std::vector<std::pair<toml::source_position, TomlEntry>> found;
        for (const auto& [key, node] : table) {
            TomlEntry entry{.key = std::string(key.str()), .line = line(key.source()), .value = {}};
            if (const auto fault = take(key.str(), node, entry)) return *fault;
            found.emplace_back(key.source().begin, std::move(entry));
        }
        std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
        std::vector<TomlEntry> out;
        for (auto& [at, entry] : found) out.push_back(std::move(entry));
        return out;
    }
    std::optional<Error> take(std::string_view key, const toml::node& node, TomlEntry& entry) const {
        if (const auto* text = node.as_string()) return entry.value = text->get(), std::nullopt;
        if (const auto* truth = node.as_boolean()) return entry.value = truth->get(), std::nullopt;
        if (const auto* list = node.as_array()) {
            std::vector<std::string> texts;
            for (const toml::node& item : *list) {
                if (!item.is_string()) return wrong(item, key, "a list of texts");
                texts.push_back(item.as_string()->get());
            }
            return entry.value = std::move(texts), std::nullopt;
        }
        const auto* table = node.as_table();
        if (table == nullptr) return wrong(node, key, kKinds);
        std::vector<std::pair<toml::source_position, std::pair<std::string, bool>>> switches;
        for (const auto& [name, on] : *table) {
            if (!on.is_boolean()) return wrong(on, key, "a table of switches: name = true or false");
            switches.emplace_back(name.source().begin, std::pair(std::string(name.str()), on.as_boolean()->get()));
        }
        std::stable_sort(switches.begin(), switches.end(),
                         [](const auto& a, const auto& b) { return a.first < b.first; });
        TomlSwitches out;
        for (auto& [at, one] : switches) out.push_back(std::move(one));
        return entry.value = std::move(out), std::nullopt;
    }

    const std::string& file_;
    int before_;
};

}  // namespace

Result<std::vector<TomlEntry>> parse_toml_table(std::string_view text, const std::string& file, int first_line) {
    return TableReader(file, first_line).read(text);
}

}  // namespace texelscope
