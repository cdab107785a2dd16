#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "app/lesson/answers.h"
#include "app/lesson/facts.h"
#include "app/state/lockstep.h"
#include "core/method/two_pass_buffer.h"

namespace texelscope::answers {
namespace {

constexpr int kMostDigits = 15;   ///< of a number that people type
constexpr double kPercent = 2.5;  ///< of a share that is guessed
constexpr double kColumns = 0.5;  ///< of a width that is guessed
constexpr std::string_view kNoRow = "No row of the shape is drawn.";

/// A row of one shape: the index that each of its pixels takes, before wrapping.
struct Indices {
    std::optional<Integer> y;
    std::vector<std::pair<Integer, Integer>> of_pixels;  ///< x, index
};

/// The step's row, else the shape's first one.
[[nodiscard]] Indices indices_of(const Asked& asked, const Drawing& drawing) {
    Indices found{.y = asked.step.index_of('y'), .of_pixels = {}};
    const int shape = asked.shape();
    if (shape < 0) return found;
    each_sample(drawing, shape, shape + 1, {drawing.scene().framebuffer.rect(), 1}, [&](int, const Sample& s) {
        if (s.fate != Fate::written || !std::isfinite(s.u) || std::abs(s.u) > 1e9) return;
        if (!found.y) found.y = s.y;
        if (s.y == *found.y) found.of_pixels.emplace_back(s.x, static_cast<Integer>(std::floor(s.u)));
    });
    return found;
}

[[nodiscard]] Path pixel_or_own(const Asked& asked, Integer x, Integer y) {
    return pixel_step(asked.steps, asked.shape(), x, y).value_or(asked.step);
}

}  // namespace

Accepted indices(const Asked& asked) {
    const Drawing drawing(asked.drawing.scene(), with_quirks(asked.drawing, asked.call.quirks));
    const Indices row = indices_of(asked, drawing);
    Accepted a{.step = asked.step, .sentence = std::string(kNoRow)};
    if (!row.y || row.of_pixels.empty()) return a;
    a.step = pixel_or_own(asked, row.of_pixels.front().first, *row.y);
    std::string said, digits;
    for (const auto& [x, index] : row.of_pixels) {
        said += fmt::format("{}{}", said.empty() ? "" : " ", index);
        digits += fmt::format("{}", index);
    }
    const bool one_digit_each = std::all_of(row.of_pixels.begin(), row.of_pixels.end(),
                                            [](const auto& p) { return p.second >= 0 && p.second <= 9; });
    a.sentence = row.of_pixels.size() > 32 ? std::string("They are more than one can type.") : said + ".";
    if (!one_digit_each || digits.size() > kMostDigits) return a;
    a.number = typed_number(digits);
    return a;
}

Accepted index_beyond(const Asked& asked) {
    const Drawing drawing(asked.drawing.scene(), with_quirks(asked.drawing, asked.call.quirks));
    const Indices row = indices_of(asked, drawing);
    Accepted a{.step = asked.step, .sentence = std::string(kNoRow)};
    if (!row.y || row.of_pixels.empty()) return a;
    const int width = drawing.job(asked.shape()).texture->width();
    const auto beyond = std::find_if(row.of_pixels.begin(), row.of_pixels.end(),
                                     [&](const auto& p) { return p.second < 0 || p.second >= width; });
    if (beyond == row.of_pixels.end()) {
        a.step = pixel_or_own(asked, row.of_pixels.front().first, *row.y);
        a.sentence = "None is.";
        return a;
    }
    a.step = pixel_or_own(asked, beyond->first, *row.y);
    a.number = static_cast<double>(beyond->second);
    a.sentence = fmt::format("The texture has texels 0 to {}, and the row asks for {}.", width - 1, beyond->second);
    return a;
}

Accepted hole_share(const Asked& asked) {
    Accepted a{.step = asked.step, .sentence = "Nothing of the shape lies on the screen."};
    if (asked.shape() < 0) return a;
    const Lockstep both = make_lockstep(asked.drawing, asked.steps, asked.step.prefix(1));
    a.step = asked.step.prefix(1);
    if (both.inside == 0) return a;
    a.number = 100.0 * static_cast<double>(both.holes) / static_cast<double>(both.inside);
    a.tolerance = kPercent;
    a.sentence = fmt::format("{} of {} pixels stay empty: {:.1f} %.", both.holes, both.inside, *a.number);
    return a;
}

Accepted hole(const Asked& asked) {
    Accepted a{.step = asked.step.prefix(1), .sentence = "None stays empty."};
    if (asked.shape() < 0) return a;
    const Grid<std::uint8_t> holes = holes_of(asked.drawing, asked.shape());
    const Rect frame = asked.drawing.scene().framebuffer.rect();
    for (int y = 0; y < holes.height(); ++y)
        for (int x = 0; x < holes.width(); ++x)
            if (holes.at(x, y) != 0) a.places.emplace_back(frame.x0 + x, frame.y0 + y);
    if (a.places.empty()) return a;
    a.least = std::clamp(asked.whole(0), 1, static_cast<int>(std::min<std::size_t>(a.places.size(), 8)));
    a.sentence = fmt::format("No texel falls on {} of the shape's pixels, the first of them ({}, {}).", a.places.size(),
                             a.places.front().x, a.places.front().y);
    return a;
}

Accepted buffer_width(const Asked& asked) {
    Accepted a{.step = asked.step, .sentence = "There is no such shape."};
    const int shape = asked.whole(0);
    if (shape < 0 || shape >= asked.drawing.shape_count()) return a;
    a.step = Path{{{'t', shape}}};
    if (asked.drawing.refusal(shape) != Fate::written) return a.sentence = "The shape is not drawn.", a;
    const TwoPassBuffer tmp = two_pass_buffer(asked.drawing.settings().format, asked.drawing.job(shape));
    if (tmp.empty()) return a.sentence = "There is no buffer.", a;
    a.number = tmp.width;
    a.tolerance = kColumns;
    a.sentence = fmt::format("Its {:.4g} texels go into {:.1f} columns.", tmp.texels, tmp.width);
    return a;
}

}  // namespace texelscope::answers
