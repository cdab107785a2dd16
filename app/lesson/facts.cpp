#include "app/lesson/facts.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace texelscope {
namespace {

[[nodiscard]] Path shape_path(int shape) { return {{{'t', shape}}}; }

[[nodiscard]] bool loops_over(const Unit& unit, char letter, Integer index) {
    return unit.loop && unit.loop->letter == letter && unit.loop->contains(index);
}

constexpr int kAllDigits = 15;  ///< that every double has

/// "e0 to e14".
[[nodiscard]] std::string range(char letter, Integer first, Integer last) {
    return first == last ? fmt::format("only {}{}", letter, first)
                         : fmt::format("{}{} to {}{}", letter, first, letter, last);
}

}  // namespace

std::optional<Path> pixel_step(Steps& steps, int shape, Integer x, Integer y) {
    if (shape < 0) return std::nullopt;
    const Path whole = shape_path(shape);
    const std::size_t stages = steps.at(whole).stages.size();
    for (std::size_t n = 0; n < stages; ++n) {
        const Path stage = whole.child('s', static_cast<Integer>(n));
        if (!loops_over(steps.at(stage).unit(), 'y', y)) continue;
        const Path row = stage.child('y', y);
        if (loops_over(steps.at(row).unit(), 'x', x)) return row.child('x', x);
    }
    return std::nullopt;
}

std::optional<Path> expression_step(Steps& steps, int shape, std::string_view name) {
    if (shape < 0) return std::nullopt;
    const Path whole = shape_path(shape);
    const std::size_t stages = steps.at(whole).stages.size();
    for (std::size_t n = 0; n < stages; ++n) {
        const Path stage = whole.child('s', static_cast<Integer>(n));
        const Visit& visit = steps.at(stage);
        const auto& expressions = visit.unit().expressions;
        for (std::size_t e = 0; e < expressions.size(); ++e) {
            if (visit.tape.names[static_cast<std::size_t>(expressions[e])].name.text() == name) {
                return stage.child('e', static_cast<Integer>(e));
            }
        }
    }
    return std::nullopt;
}

std::optional<Path> line_step(Steps& steps, int shape, int line) {
    if (shape < 0) return std::nullopt;
    const Path whole = shape_path(shape);
    const std::size_t stages = steps.at(whole).stages.size();
    for (std::size_t n = 0; n < stages; ++n) {
        Path unit = whole.child('s', static_cast<Integer>(n));
        for (bool deeper = true; deeper;) {
            const Visit& visit = steps.at(unit);
            for (const std::int32_t index : visit.unit().expressions) {
                if (visit.tape.names[static_cast<std::size_t>(index)].line == line) return unit;
            }
            const auto& loop = visit.unit().loop;
            deeper = loop && loop->count() > 0;
            if (deeper) unit = unit.child(loop->letter, loop->first);
        }
    }
    return std::nullopt;
}

std::optional<Value> value_named(const Visit& visit, std::string_view name) {
    const auto& names = visit.tape.names;
    const auto value_of = [&](const Named& named) {
        return visit.tape.operations[static_cast<std::size_t>(named.operation)].value;
    };
    const auto& own = visit.unit().expressions;
    for (auto index = own.rbegin(); index != own.rend(); ++index) {
        const Named& named = names[static_cast<std::size_t>(*index)];
        if (named.name.text() == name) return value_of(named);
    }
    for (auto named = names.rbegin(); named != names.rend(); ++named) {
        if (named->name.text() == name) return value_of(*named);
    }
    return std::nullopt;
}

bool same_value(const std::optional<Value>& a, const std::optional<Value>& b) {
    if (!a || !b) return a.has_value() == b.has_value();
    const double x = approximate(*a), y = approximate(*b);
    if (std::isnan(x) || std::isnan(y)) return std::isnan(x) && std::isnan(y);
    return x == 0 ? y == 0 : full_text(*a) == full_text(*b);
}

std::string equation(std::string_view name, double value, int decimals) {
    const double scaled = std::ldexp(value, decimals);  // n decimals say all of a number just if n bits do
    if (scaled == std::floor(scaled)) return fmt::format("{} = {:.{}g}", name, value, kAllDigits);
    return fmt::format("{} \\approx {:.{}f}", name, value, decimals);
}

std::optional<std::string> missing_part(Steps& steps, const Path& path) {
    if (path.empty()) return std::nullopt;
    const int shapes = steps.drawing().shape_count();
    if (shapes == 0) return "the scene has no shape";
    if (path.parts[0].index < 0 || path.parts[0].index >= shapes) return "the scene has " + range('t', 0, shapes - 1);
    for (std::size_t depth = 1; depth < path.parts.size(); ++depth) {
        const Path unit{{path.parts.begin(), path.parts.begin() + static_cast<std::ptrdiff_t>(depth)}};
        const Visit& visit = steps.at(unit);
        const auto [letter, index] = path.parts[depth];
        const auto listed = static_cast<Integer>(depth == 1 ? visit.stages.size() : visit.unit().expressions.size());
        const char list = depth == 1 ? 's' : 'e';
        if (letter == list && index >= 0 && index < listed) continue;
        if (loops_over(visit.unit(), letter, index)) continue;
        std::string parts = listed > 0 ? range(list, 0, listed - 1) : "";
        if (const auto& loop = visit.unit().loop; loop && loop->count() > 0)
            parts += (parts.empty() ? "" : " and ") + range(loop->letter, loop->first, loop->last - loop->step);
        return unit.text() + " has " + (parts.empty() ? "no parts" : parts);
    }
    return std::nullopt;
}

Grid<Coverage> coverage(const Drawing& drawing, int shape) {
    const Rect frame = drawing.scene().framebuffer.rect();
    Grid<Coverage> covered(frame.width(), frame.height());
    each_sample(drawing, 0, shape + 1, {frame}, [&](int n, const Sample& sample) {
        if (n != shape) return;
        Coverage& here = covered.at(static_cast<int>(sample.x) - frame.x0, static_cast<int>(sample.y) - frame.y0);
        here = sample.fate == Fate::written ? Coverage::written : std::max(here, Coverage::rejected);
    });
    return covered;
}

std::vector<std::pair<int, Sample>> samples_at(const Drawing& drawing, Integer x, Integer y) {
    std::vector<std::pair<int, Sample>> samples;
    const Rect frame = drawing.scene().framebuffer.rect();
    if (x < frame.x0 || x >= frame.x1 || y < frame.y0 || y >= frame.y1) return samples;
    const int left = static_cast<int>(x), top = static_cast<int>(y);
    each_sample(drawing, 0, drawing.shape_count(), {{left, top, left + 1, top + 1}},
                [&](int n, const Sample& sample) { samples.emplace_back(n, sample); });
    return samples;
}

Grid<std::uint8_t> write_counts(const Drawing& drawing) {
    const Rect frame = drawing.scene().framebuffer.rect();
    Grid<std::uint8_t> counts(frame.width(), frame.height());
    each_sample(drawing, 0, drawing.shape_count(), {frame}, [&](int, const Sample& sample) {
        if (sample.fate != Fate::written) return;
        std::uint8_t& count = counts.at(static_cast<int>(sample.x) - frame.x0, static_cast<int>(sample.y) - frame.y0);
        if (count < 255) ++count;
    });
    return counts;
}

DrawSettings with_quirks(const Drawing& drawing, const std::vector<std::pair<std::string, bool>>& quirks) {
    DrawSettings settings = drawing.settings();
    for (const auto& [id, on] : quirks) {
        const auto n = quirk_number(*settings.method, id);
        if (!n) continue;
        const QuirkSet bit = QuirkSet{1} << *n;
        settings.quirks = on ? settings.quirks | bit : settings.quirks & ~bit;
    }
    return settings;
}

std::optional<int> quirk_number(const Method& method, std::string_view id) {
    for (std::size_t n = 0; n < method.quirks.size(); ++n) {
        if (method.quirks[n].id == id || method.quirks[n].field == id) return static_cast<int>(n);
    }
    return std::nullopt;
}

}  // namespace texelscope
