#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "app/lesson/answers.h"
#include "app/lesson/facts.h"

namespace texelscope::answers {
namespace {

constexpr std::array<std::string_view, 3> kNames{"g", "h", "i"};
constexpr int kAnswersPerspectiveNone = 3;        ///< the option behind the three coefficients
constexpr double kAnswersPerspectiveSame = 1e-9;  ///< values of v so near are one [texels]

/// Which of g, h and i are 0 in exact numbers, for the shape's polygon drawn through one matrix; nothing without one.
[[nodiscard]] std::optional<std::array<bool, 3>> exact_zeros(const Asked& asked) {
    if (asked.shape() < 0) return std::nullopt;
    const Method* method = find_method("backward-projective");
    const Drawing exact(asked.drawing.scene(), {method, NumberFormat::exact, 0, {}});
    const int polygon = asked.drawing.polygon_of(asked.shape()), shape = exact.first_shape_of(polygon);
    if (shape >= exact.shape_count()) return std::nullopt;
    const Visit setup = visit(exact, Path{{{'t', shape}}});
    std::array<bool, 3> zeros{};
    for (std::size_t n = 0; n < zeros.size(); ++n) {
        const auto value = value_named(setup, kNames[n]);
        if (!value || undefined(*value)) return std::nullopt;
        zeros[n] = std::get<Exact>(*value) == Exact(Integer{0});
    }
    return zeros;
}

}  // namespace

Accepted row_of_v(const Asked& asked) {
    const double wanted = asked.call.numbers.front();
    Accepted a{.step = asked.step, .sentence = fmt::format("$v$ is nowhere {} on this polygon.", wanted)};
    if (asked.shape() < 0) return a;
    struct Column {
        double low = INFINITY, high = -INFINITY, nearest = INFINITY;
        Sample at;
        int shape = 0;
    };
    std::map<Integer, Column> columns;
    const int polygon = asked.drawing.polygon_of(asked.shape());
    const Window all{asked.drawing.scene().framebuffer.rect()};
    each_sample(asked.drawing, 0, asked.drawing.shape_count(), all, [&](int shape, const Sample& s) {
        if (s.fate != Fate::written || asked.drawing.polygon_of(shape) != polygon || !std::isfinite(s.v)) return;
        Column& column = columns[s.x];
        column.low = std::min(column.low, s.v), column.high = std::max(column.high, s.v);
        if (!(std::abs(s.v - wanted) < column.nearest)) return;
        column.nearest = std::abs(s.v - wanted), column.at = s, column.shape = shape;
    });
    const Column* best = nullptr;
    for (const auto& [x, column] : columns) {
        if (column.low > wanted + kAnswersPerspectiveSame || column.high < wanted - kAnswersPerspectiveSame) continue;
        a.places.emplace_back(column.at.x, column.at.y);
        if (best == nullptr || column.nearest < best->nearest - kAnswersPerspectiveSame) best = &column;
    }
    if (best == nullptr) return a;
    if (const auto step = pixel_step(asked.steps, best->shape, best->at.x, best->at.y)) a.step = *step;
    a.sentence = fmt::format("In row {}: ${}$ there.", best->at.y, equation("v", best->at.v, 4));
    return a;
}

Accepted zero_in_denominator(const Asked& asked) {
    constexpr std::array<std::string_view, 3> kSays{"$g = 0$: $W$ stays the same along a row.",
                                                    "$h = 0$: $W$ stays the same down a column.",
                                                    "$i = 0$: $W$ is 0 at the screen's corner."};
    Accepted a{.options = {kAnswersPerspectiveNone}, .step = asked.step, .sentence = "The face has no matrix."};
    const auto zeros = exact_zeros(asked);
    if (!zeros) return a;
    a.sentence = "None of $g$, $h$, $i$ is 0 here.";
    std::vector<int> found;
    for (int n = 0; n < kAnswersPerspectiveNone; ++n)
        if ((*zeros)[static_cast<std::size_t>(n)]) found.push_back(n);
    const auto first = static_cast<std::size_t>(found.empty() ? 0 : found.front());
    if (const auto step = expression_step(asked.steps, asked.shape(), kNames[first])) a.step = *step;
    if (found.empty()) return a;
    a.options = found;
    a.sentence = kSays[first];
    return a;
}

}  // namespace texelscope::answers
