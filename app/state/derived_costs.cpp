// Operations of the methods that draw a polygon through one matrix, counted on their tapes.
#include <algorithm>
#include <array>
#include <set>

#include "app/state/derived_cache.h"

namespace texelscope {
namespace {

constexpr std::array<std::string_view, 3> kCompared{"backward-affine", "backward-projective", "constant-z"};

constexpr Integer kDerivedCostsMostCounted = 1 << 18;  ///< samples that a face may visit: more would hold up the step

/// Where on the tape the round of a loop begins: its variable's place. The tape's end where there is none.
[[nodiscard]] std::int32_t round_of(const Tape& tape, char letter, std::int32_t after) {
    for (const Named& named : tape.names) {
        if (named.loop_variable && named.operation > after && named.name.text() == std::string(1, letter))
            return named.operation;
    }
    return static_cast<std::int32_t>(tape.operations.size());
}

[[nodiscard]] std::vector<Sample> written_by(const Drawing& drawing, int shape) {
    std::vector<Sample> all;
    each_sample(drawing, shape, shape + 1, {drawing.scene().framebuffer.rect(), 1}, [&](int, const Sample& s) {
        if (s.fate == Fate::written) all.push_back(s);
    });
    return all;
}
/// The cursor's sample, else one in the middle. Requires samples.
[[nodiscard]] const Sample& looked_at(const std::vector<Sample>& all, std::optional<glm::ivec2> pixel) {
    const auto here = std::find_if(all.begin(), all.end(),
                                   [&](const Sample& s) { return pixel && s.x == pixel->x && s.y == pixel->y; });
    return here != all.end() ? *here : all[all.size() / 2];
}

[[nodiscard]] std::optional<MethodCost> cost_of(const Drawing& drawing, int shape, std::optional<glm::ivec2> pixel) {
    MethodCost cost{.method = drawing.settings().method};
    Steps steps(drawing);
    const std::vector<Sample> all = written_by(drawing, shape);
    if (all.empty()) return std::nullopt;
    const Sample& any = looked_at(all, pixel);
    const auto path = steps.at_pixel(shape, any.x, any.y);
    if (!path || path->parts.size() != 4) return std::nullopt;
    const char outer = path->parts[2].letter, inner = path->parts[3].letter;
    cost.columns = outer == 'x';
    const auto line_of = [&](const Sample& s) { return cost.columns ? s.x : s.y; };
    std::set<Integer> lines;
    for (const Sample& s : all) lines.insert(line_of(s)), cost.line_pixels += line_of(s) == line_of(any);
    cost.pixels = static_cast<Integer>(all.size());
    cost.lines = static_cast<Integer>(lines.size());

    const Tape& tape = steps.at(*path).tape;
    const std::int32_t line = round_of(tape, outer, -1), sample = round_of(tape, inner, line);
    cost.setup = operations_on(tape, 0, line);
    cost.line = operations_on(tape, line, sample);
    cost.pixel = operations_on(tape, sample, static_cast<std::int32_t>(tape.operations.size()));
    return cost;
}

}  // namespace

const std::vector<MethodCost>& Derived::costs() const {
    auto& costs = cache_->of_step.costs;
    if (costs) return *costs;
    costs.emplace();
    if (shape() < 0) return *costs;
    const Rect reach = drawing().reach(shape());
    if (Integer{reach.width()} * reach.height() > kDerivedCostsMostCounted) return *costs;
    const int polygon = drawing().polygon_of(shape());
    const auto add = [&](const Drawing& other, int n, bool current) {
        auto cost = cost_of(other, n, pixel());
        if (!cost) return;
        cost->current = current;
        costs->push_back(*cost);
    };
    bool own = false;
    for (const std::string_view id : kCompared) {
        const Method* compared = find_method(id);
        if (compared == &method()) {
            add(drawing(), shape(), true), own = true;
            continue;
        }
        DrawSettings settings = drawing().settings();
        settings.method = compared, settings.quirks = 0;
        const Drawing other(scene(), settings);
        if (other.first_shape_of(polygon) < other.shape_count()) add(other, other.first_shape_of(polygon), false);
    }
    if (!own) add(drawing(), shape(), true);
    return *costs;
}

}  // namespace texelscope
