#include <cctype>

#include <fmt/format.h>

#include "app/lesson/answers.h"
#include "app/lesson/facts.h"
#include "core/trace/listing.h"

namespace texelscope::answers {
namespace {

constexpr double kTwoDecimals = 0.01;  ///< answers rounded, or cut, to two decimals are right

/// Whether `word` stands in `text` by itself.
[[nodiscard]] bool has_word(std::string_view text, std::string_view word) {
    for (std::size_t at = text.find(word); at != text.npos; at = text.find(word, at + 1)) {
        const std::size_t end = at + word.size();
        const bool goes_on =
            end < text.size() && (std::isalnum(static_cast<unsigned char>(text[end])) != 0 || text[end] == '_');
        if (!goes_on) return true;
    }
    return false;
}

}  // namespace

Accepted value(const Asked& asked) {
    Accepted a{.step = asked.step, .sentence = "It has no value there."};
    const bool moved = asked.call.numbers.size() == 2;
    if (moved) {
        const auto x = asked.step.index_of('x'), y = asked.step.index_of('y');
        if (!x || !y) return a;
        const auto step = pixel_step(asked.steps, asked.shape(), *x + asked.whole(0), *y + asked.whole(1));
        if (!step) return a;
        a.step = *step;
    }
    if (a.step.empty()) return a;
    const std::string& name = asked.call.words.front();
    const auto value = value_named(asked.steps.at(a.step), name);
    if (!value || undefined(*value)) return a;
    const bool whole = std::holds_alternative<Integer>(*value) || std::holds_alternative<bool>(*value);
    a.number = approximate(*value);
    a.tolerance = whole ? 0 : kTwoDecimals;
    a.sentence = whole ? fmt::format("${} = {}$ there.", name, *a.number)
                       : fmt::format("${}$ there.", equation(name, *a.number, 4));
    return a;
}

Accepted row_pixels(const Asked& asked) {
    Accepted a{.step = asked.step, .sentence = "The step lies in no row."};
    const auto y = asked.step.index_of('y');
    if (!y) return a;
    a.step = asked.step.prefix(3);
    const Grid<Coverage> covered = coverage(asked.drawing, asked.shape());
    const Integer row = *y - asked.drawing.scene().framebuffer.rect().y0;
    Integer pixels = 0;
    for (int x = 0; row >= 0 && row < covered.height() && x < covered.width(); ++x) {
        pixels += covered.at(x, static_cast<int>(row)) == Coverage::written;
    }
    a.number = static_cast<double>(pixels);
    a.sentence = fmt::format("Row {} has {} of them.", *y, pixels);
    return a;
}

Accepted guilty_line(const Asked& asked) {
    const Method& method = *asked.drawing.settings().method;
    const Listing listing = load_listing(method.listing);
    Accepted a{.step = asked.step, .sentence = "No line asks for it."};
    const auto n = quirk_number(method, asked.call.words.front());
    if (!n) return a;
    const QuirkInfo& quirk = method.quirks[static_cast<std::size_t>(*n)];
    const std::string word = fmt::format("quirk.{}", quirk.field);
    for (std::size_t line = 0; line < listing.lines.size(); ++line) {
        if (has_word(listing.lines[line], word)) a.places.emplace_back(static_cast<int>(line) + 1, 0);
    }
    a.sentence = quirk.sentence;
    for (const glm::ivec2 place : a.places) {
        if (const auto step = line_step(asked.steps, asked.shape(), place.x)) return a.step = *step, a;
    }
    return a;
}

}  // namespace texelscope::answers
