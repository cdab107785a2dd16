#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "app/lesson/answers.h"
#include "app/lesson/facts.h"

namespace texelscope::answers {
namespace {

constexpr std::string_view kNames = "abcdefghi";
constexpr int kNone = 9;        ///< the option behind the nine coefficients
constexpr double kSame = 1e-9;  ///< values of v so near are one [texels]

/// Whether a coefficient is 0 in exact numbers, of the shape's polygon drawn through one matrix; nothing without one.
[[nodiscard]] std::optional<std::array<bool, 9>> exact_zeros(const Asked& asked) {
    if (asked.shape() < 0) return std::nullopt;
    const Method* method = find_method("backward-projective");
    const Drawing exact(asked.drawing.scene(), {method, NumberFormat::exact, 0, {}});
    const int shape = exact.first_shape_of(asked.drawing.polygon_of(asked.shape()));
    if (shape >= exact.shape_count()) return std::nullopt;
    const Visit setup = visit(exact, Path{{{'t', shape}}});
    std::array<bool, 9> zeros{};
    for (std::size_t n = 0; n < zeros.size(); ++n) {
        const auto value = value_named(setup, kNames.substr(n, 1));
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
        if (column.low > wanted + kSame || column.high < wanted - kSame) continue;
        a.places.emplace_back(column.at.x, column.at.y);
        if (best == nullptr || column.nearest < best->nearest - kSame) best = &column;
    }
    if (best == nullptr) return a;
    if (const auto step = pixel_step(asked.steps, best->shape, best->at.x, best->at.y)) a.step = *step;
    a.sentence = fmt::format("In row {}: ${}$ there.", best->at.y, equation("v", best->at.v, 4));
    return a;
}

Accepted zero_coefficient(const Asked& asked) {
    constexpr std::array<std::string_view, 3> kOf{"u", "v", "W"};
    Accepted a{.options = {kNone}, .step = asked.step, .sentence = "The face has no matrix."};
    const auto zeros = exact_zeros(asked);
    const auto row = static_cast<std::size_t>(std::clamp(asked.whole(0), 0, 2));
    if (!zeros) return a;
    a.sentence =
        fmt::format("None of ${}$, ${}$, ${}$ is 0 here.", kNames[3 * row], kNames[3 * row + 1], kNames[3 * row + 2]);
    std::vector<int> found;
    for (std::size_t n = 3 * row; n < 3 * row + 3; ++n)
        if ((*zeros)[n]) found.push_back(static_cast<int>(n));
    const std::string_view name = kNames.substr(found.empty() ? 3 * row : static_cast<std::size_t>(found.front()), 1);
    if (const auto step = expression_step(asked.steps, asked.shape(), name)) a.step = *step;
    if (found.empty()) return a;
    a.options = found;
    const int term = found.front() % 3;
    a.sentence = term == 0   ? fmt::format("${} = 0$: ${}$ stays the same along a row.", name, kOf[row])
                 : term == 1 ? fmt::format("${} = 0$: ${}$ stays the same down a column.", name, kOf[row])
                             : fmt::format("${} = 0$: ${}$ is 0 at the screen's corner.", name, kOf[row]);
    return a;
}

}  // namespace texelscope::answers
