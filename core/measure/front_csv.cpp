#include <array>
#include <charconv>
#include <string_view>

#include <fmt/format.h>

#include "core/measure/front.h"

namespace texelscope {
namespace {

constexpr std::string_view kHeader =
    "scene,rung,label,kind,numbers,triangles,pixels,median_ns,min_ns,missing,extra,wrong,checked,"
    "max_error,p99_error,mean_error,bound,dominated_by,behind";
constexpr std::size_t kColumns = 19;

/// The label alone may hold commas.
[[nodiscard]] std::string quoted(const std::string& text) {
    return text.find(',') == std::string::npos ? text : '"' + text + '"';
}

/// The fields of a line; false where they are not kColumns, or a quote is left open.
[[nodiscard]] bool split(std::string_view line, std::array<std::string_view, kColumns>& fields) {
    for (std::size_t n = 0; n < kColumns; ++n) {
        std::size_t end = 0;
        if (!line.empty() && line.front() == '"') {
            end = line.find('"', 1);
            if (end == std::string_view::npos) return false;
            fields[n] = line.substr(1, end - 1);
            line.remove_prefix(end + 1);
            end = 0;
            if (!line.empty() && line.front() != ',') return false;
        } else {
            end = std::min(line.find(','), line.size());
            fields[n] = line.substr(0, end);
        }
        const bool last = n + 1 == kColumns;
        if (last != (end == line.size())) return false;
        line.remove_prefix(last ? end : end + 1);
    }
    return true;
}

template <class T>
[[nodiscard]] bool read(std::string_view text, T& value) {
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    return error == std::errc() && end == text.data() + text.size();
}

}  // namespace

std::string print_front(std::span<const FrontPoint> points) {
    std::string csv = std::string(kHeader) + "\n";
    for (const FrontPoint& p : points)
        csv +=
            fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", p.scene, p.rung, quoted(p.label),
                        p.kind, p.numbers, p.triangles, p.pixels, p.median_ns, p.min_ns, p.missing, p.extra, p.wrong,
                        p.checked, p.max_error, p.p99_error, p.mean_error, p.bound, p.dominated_by, p.behind);
    return csv;
}

Result<std::vector<FrontPoint>> parse_front(std::string_view csv, const std::string& name) {
    std::vector<FrontPoint> points;
    for (int number = 1; !csv.empty(); ++number) {
        const std::size_t end = std::min(csv.find('\n'), csv.size());
        const std::string_view line = csv.substr(0, end);
        csv.remove_prefix(std::min(end + 1, csv.size()));
        const std::string where = fmt::format("{}:{}", name, number);
        if (number == 1) {
            if (line != kHeader) return Error{where, "not the first line of a front, expected " + std::string(kHeader)};
            continue;
        }
        std::array<std::string_view, kColumns> f;
        FrontPoint p;
        if (!split(line, f)) return Error{where, fmt::format("'{}', expected {} columns", line, kColumns)};
        p.scene = f[0], p.rung = f[1], p.label = f[2], p.kind = f[3], p.numbers = f[4], p.dominated_by = f[17],
        p.behind = f[18];
        const bool whole = read(f[5], p.triangles) && read(f[6], p.pixels) && read(f[9], p.missing) &&
                           read(f[10], p.extra) && read(f[11], p.wrong) && read(f[12], p.checked);
        const bool real = read(f[7], p.median_ns) && read(f[8], p.min_ns) && read(f[13], p.max_error) &&
                          read(f[14], p.p99_error) && read(f[15], p.mean_error) && read(f[16], p.bound);
        if (!whole || !real) return Error{where, fmt::format("'{}', expected numbers in columns 6 to 17", line)};
        points.push_back(std::move(p));
    }
    if (points.empty()) return Error{name, "holds no points, expected a front as `texelscope front` writes it"};
    return points;
}

}  // namespace texelscope
