#include "app/state/link.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <limits>

#include <fmt/format.h>

#include "app/lesson/random_text.h"
#include "app/state/compared_run.h"
#include "app/state/lesson_cursor.h"
#include "core/measure/rungs.h"

namespace texelscope {
namespace {

constexpr std::string_view kPrefix = "texelscope:1:";
constexpr std::size_t kLongest = 1 << 16;

constexpr std::string_view kVerdicts = "orws";

[[nodiscard]] std::uint32_t checksum(std::string_view text) {
    std::uint32_t sum = 2166136261U;  // FNV-1a: enough to tell a slip of the hand
    for (const char c : text) sum = (sum ^ static_cast<unsigned char>(c)) * 16777619U;
    return sum;
}

/// Everything but letters, digits and a few marks as %XX, so that a line stays a line and fields stay apart.
[[nodiscard]] std::string escaped(std::string_view text) {
    std::string out;
    for (const char c : text) {
        const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' ||
                           c == '_' || c == '.' || c == '/';
        out += plain ? std::string(1, c) : fmt::format("%{:02X}", static_cast<unsigned char>(c));
    }
    return out;
}

[[nodiscard]] std::optional<std::string> unescaped(std::string_view text) {
    std::string out;
    for (std::size_t at = 0; at < text.size(); ++at) {
        if (text[at] != '%') {
            out += text[at];
            continue;
        }
        unsigned code = 0;
        if (at + 2 >= text.size() || std::from_chars(&text[at] + 1, &text[at] + 3, code, 16).ptr != &text[at] + 3 ||
            code == 0)
            return std::nullopt;
        out += static_cast<char>(code);
        at += 2;
    }
    return out;
}

[[nodiscard]] std::vector<std::string_view> split(std::string_view text, char separator) {
    std::vector<std::string_view> parts;
    for (;;) {
        const std::size_t end = text.find(separator);
        parts.push_back(text.substr(0, end));
        if (end == std::string_view::npos) return parts;
        text.remove_prefix(end + 1);
    }
}

template <class T>
[[nodiscard]] bool read(std::string_view text, T& value) {
    const char* end = text.data() + text.size();
    const auto [after, bad] = std::from_chars(text.data(), end, value);
    return bad == std::errc() && after == end;
}

[[nodiscard]] bool read_float(std::string_view text, float& value) {
    const std::string copy(text);
    char* end = nullptr;
    value = std::strtof(copy.c_str(), &end);
    return !copy.empty() && *end == '\0' && std::isfinite(value);
}

[[nodiscard]] std::string print_answer(const Answer& a) {
    std::string text = fmt::format("a={}{}:", a.beat, kVerdicts[static_cast<std::size_t>(a.verdict)]);
    for (std::size_t n = 0; n < a.chosen.size(); ++n) text += fmt::format("{}{}", n > 0 ? "." : "", a.chosen[n]);
    text += ":" + escaped(a.typed) + ":";
    for (std::size_t n = 0; n < a.places.size(); ++n)
        text += fmt::format("{}{}.{}", n > 0 ? "," : "", a.places[n].x, a.places[n].y);
    return text;
}

[[nodiscard]] bool read_answer(std::string_view text, Answer& a) {
    const auto parts = split(text, ':');
    if (parts.size() != 4 || parts[0].size() < 2) return false;
    const std::size_t verdict = kVerdicts.find(parts[0].back());
    if (verdict == std::string_view::npos || !read(parts[0].substr(0, parts[0].size() - 1), a.beat)) return false;
    a.verdict = static_cast<Answer::Verdict>(verdict);
    if (!parts[1].empty()) {
        for (const std::string_view option : split(parts[1], '.')) {
            if (!read(option, a.chosen.emplace_back())) return false;
        }
    }
    const auto typed = unescaped(parts[2]);
    if (!typed) return false;
    a.typed = *typed;
    if (parts[3].empty()) return true;
    for (const std::string_view place : split(parts[3], ',')) {
        const auto xy = split(place, '.');
        glm::ivec2& at = a.places.emplace_back();
        if (xy.size() != 2 || !read(xy[0], at.x) || !read(xy[1], at.y)) return false;
    }
    return true;
}

/// "mesh,x,y,z", of jelly cubes with ",x,y,z,ratio" behind it.
[[nodiscard]] bool read_mesh(std::string_view text, MeshEdit& edit) {
    const auto parts = split(text, ',');
    if ((parts.size() != 4 && parts.size() != 8) || !read(parts[0], edit.mesh)) return false;
    const auto read_three = [&](std::size_t first, glm::vec3& three) {
        return read_float(parts[first], three.x) && read_float(parts[first + 1], three.y) &&
               read_float(parts[first + 2], three.z);
    };
    if (!read_three(1, edit.rotate)) return false;
    return parts.size() == 4 || (read_three(4, edit.rotate2) && read_float(parts[7], edit.ratio) && edit.ratio > 0);
}

[[nodiscard]] std::string print_mesh(const MeshEdit& edit) {
    const auto three = [](const glm::vec3& v) { return fmt::format("{},{},{}", v.x, v.y, v.z); };
    std::string text = fmt::format(";r={},{}", edit.mesh, three(edit.rotate));
    if (MeshEdit{edit.mesh, edit.rotate} != edit) text += fmt::format(",{},{}", three(edit.rotate2), edit.ratio);
    return text;
}

[[nodiscard]] bool read_edit(std::string_view text, VertexEdit& edit) {
    const auto parts = split(text, ',');
    if (parts.size() != 8) return false;
    Vertex& v = edit.value;
    return read(parts[0], edit.polygon) && read(parts[1], edit.vertex) && read_float(parts[2], v.x) &&
           read_float(parts[3], v.y) && read_float(parts[4], v.z) && read_float(parts[5], v.w) &&
           read_float(parts[6], v.u) && read_float(parts[7], v.v);
}

/// One "key=value". Returns false where the value makes no sense.
[[nodiscard]] bool read_field(std::string_view key, std::string_view value, Link& link) {
    Work& work = link.work;
    if (key == "s") {
        const auto path = value.empty() ? std::optional(Path{}) : parse_path(value);
        if (path) link.cursor.step = *path;
        return path.has_value();
    }
    if (key == "l") {
        int level = 0;
        if (!read(value, level) || level < 0 || level >= kLevels) return false;
        link.cursor.level = static_cast<Level>(level);
        return true;
    }
    if (key == "b") return read(value, link.cursor.beat);
    if (key == "m") return work.method = value, find_method(value) != nullptr;
    if (key == "v") return work.variant = value, true;
    if (key == "q") return read(value, work.quirks);
    if (key == "n") {
        const auto format = number_format(value);
        if (format) work.format = *format;
        return format.has_value();
    }
    if (key == "o") {
        int overflow = 0;
        if (!read(value.substr(0, 1), overflow) || overflow < 0 || overflow > 2 || value.size() > 2) return false;
        work.mode = {static_cast<Overflow>(overflow), value.size() == 2};
        return true;
    }
    if (key == "e") return read_edit(value, work.edits.emplace_back());
    if (key == "r") return read_mesh(value, work.meshes.emplace_back());
    if (key == "c") return read_float(value, work.focal) && work.focal >= 0;
    if (key == "g")
        return work.random = parse_random(value, ',', std::numeric_limits<int>::max()), work.random.has_value();
    if (key == "f") return read(value, work.frame) && work.frame >= 0;
    if (key == "j") return work.size_twice = value == "1", value == "0" || value == "1";
    if (key == "a") return read_answer(value, work.answers.emplace_back());
    if (key == "d") {
        const auto words = unescaped(value);
        const auto run = parse_run(words.value_or(""));
        if (run) link.other = *run;
        return static_cast<bool>(run);
    }
    if (key == "u") {
        link.rung = unescaped(value).value_or("");
        return find_rung(link.rung) != nullptr;
    }
    if (key == "k") return read(value, link.skips) && link.skips <= kAllSkips;
    if (key == "D") return link.difference = true, value == "1";
    if (key == "t") {
        const auto file = unescaped(value);
        if (file) work.texture_file = *file;
        return file.has_value();
    }
    return false;
}

[[nodiscard]] Error damaged(std::string what) { return {"state", "this line is damaged: " + std::move(what)}; }

}  // namespace

std::string with_checksum(std::string_view fields) {
    return fmt::format("{}{};{:08x}", kPrefix, fields, checksum(fields));
}

bool looks_like_link(std::string_view text) { return text.starts_with("texelscope:"); }

std::string print_link(const State& state) {
    const Work& w = state.work;
    std::string text =
        fmt::format("{};s={};l={};b={};m={};v={};q={};n={}", escaped(state.document ? state.document->id : ""),
                    state.cursor.step.text(), static_cast<int>(state.cursor.level), state.cursor.beat, w.method,
                    w.variant, w.quirks, id_of(w.format));
    if (w.mode != NumberMode{})
        text += fmt::format(";o={}{}", static_cast<int>(w.mode.overflow), w.mode.floor_products ? "f" : "");
    for (const VertexEdit& e : w.edits) {
        const Vertex& v = e.value;
        text += fmt::format(";e={},{},{},{},{},{},{},{}", e.polygon, e.vertex, v.x, v.y, v.z, v.w, v.u, v.v);
    }
    for (const MeshEdit& e : w.meshes) text += print_mesh(e);
    if (w.focal > 0) text += fmt::format(";c={}", w.focal);
    if (w.frame != 0) text += fmt::format(";f={}", w.frame);
    if (w.random) text += ";g=" + text_of(*w.random, ',');
    if (w.size_twice) text += *w.size_twice ? ";j=1" : ";j=0";
    for (const Answer& a : w.answers) text += ";" + print_answer(a);
    if (const std::string run = text_of(state.look.other); !run.empty()) text += ";d=" + escaped(run);
    if (state.look.difference) text += ";D=1";
    if (!state.look.rung.empty()) text += ";u=" + escaped(state.look.rung);
    if ((state.look.skips & kAllSkips) != kAllSkips) text += fmt::format(";k={}", state.look.skips & kAllSkips);
    if (!w.texture_file.empty()) text += ";t=" + escaped(w.texture_file);
    return with_checksum(text);
}

Result<Link> parse_link(std::string_view text) {
    while (!text.empty() && static_cast<unsigned char>(text.back()) <= ' ') text.remove_suffix(1);
    if (!text.starts_with(kPrefix)) return damaged("it should begin with " + std::string(kPrefix));
    if (text.size() > kLongest) return damaged("it is too long");
    if (std::any_of(text.begin(), text.end(), [](unsigned char c) { return c < ' ' || c == 0x7F; }))
        return damaged("it has a character that cannot be printed");
    text.remove_prefix(kPrefix.size());
    const std::size_t end = text.rfind(';');
    std::uint32_t sum = 0;
    if (end == std::string_view::npos || text.size() - end != 9 ||
        std::from_chars(text.data() + end + 1, text.data() + text.size(), sum, 16).ptr != text.data() + text.size()) {
        return damaged("its end is missing");
    }
    text = text.substr(0, end);
    if (checksum(text) != sum) return damaged("its check sum does not fit");

    Link link;
    const auto fields = split(text, ';');
    const auto document = unescaped(fields[0]);
    if (!document) return damaged("the document's name cannot be read");
    link.document = *document;
    for (std::size_t n = 1; n < fields.size(); ++n) {
        const std::size_t equals = fields[n].find('=');
        if (equals == std::string_view::npos ||
            !read_field(fields[n].substr(0, equals), fields[n].substr(equals + 1), link)) {
            return damaged("'" + std::string(fields[n].substr(0, 40)) + "' makes no sense");
        }
    }
    if (find_method(link.work.method) == nullptr) return damaged("it names no method");
    return link;
}

}  // namespace texelscope
