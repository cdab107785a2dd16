#include <array>

#include <fmt/format.h>

#include "app/lesson/answers.h"
#include "app/lesson/facts.h"

namespace texelscope::answers {
namespace {

constexpr std::array<std::string_view, 3> kChannels{"red", "green", "blue"};
constexpr std::string_view kNoByte = "The picture has {} bytes, so there is no byte {}.";
constexpr std::string_view kNoPixel = "Pixel ({}, {}) lies outside of the picture.";
constexpr std::string_view kNoDouble = "None is: every sample has one owner.";
constexpr std::string_view kDoubles = "The first of {} lies at ({}, {}): the second shape writes there again.";
constexpr std::string_view kNoTexel = "No texel is read for this pixel.";

constexpr std::size_t kBytesPerPixel = 3;

/// Where the pixel lies in the array; nothing outside of the frame.
[[nodiscard]] std::optional<Integer> address(const Rect& frame, Integer x, Integer y) {
    if (x < frame.x0 || x >= frame.x1 || y < frame.y0 || y >= frame.y1) return std::nullopt;
    return (y - frame.y0) * frame.width() + (x - frame.x0);
}

/// The first step of any shape that visits the pixel; else the cursor's.
[[nodiscard]] Path step_at(const Asked& asked, Integer x, Integer y) {
    for (const auto& [shape, sample] : samples_at(asked.drawing, x, y)) {
        if (const auto step = pixel_step(asked.steps, shape, x, y)) return *step;
    }
    return asked.step;
}

/// The pixel that arguments 0 and 1 name, and its address in `a`; false where it lies outside.
[[nodiscard]] bool pixel_asked(const Asked& asked, Accepted& a, Integer& at) {
    const Integer x = asked.whole(0), y = asked.whole(1);
    const auto found = address(asked.drawing.scene().framebuffer.rect(), x, y);
    a.step = step_at(asked, x, y);
    if (!found) return a.sentence = fmt::format(kNoPixel, x, y), false;
    at = *found;
    return true;
}

}  // namespace

Accepted pixel_of_byte(const Asked& asked) {
    const Rect frame = asked.drawing.scene().framebuffer.rect();
    const Integer byte = asked.whole(0), bytes = Integer{kBytesPerPixel} * frame.width() * frame.height();
    Accepted a{.step = asked.step};
    if (byte < 0 || byte >= bytes) return a.sentence = fmt::format(kNoByte, bytes, byte), a;
    const Integer pixel = byte / Integer{kBytesPerPixel}, column = pixel % frame.width(), row = pixel / frame.width();
    a.places = {{frame.x0 + column, frame.y0 + row}};
    a.step = step_at(asked, frame.x0 + column, frame.y0 + row);
    a.sentence = fmt::format("Byte {} is the {} of pixel {}, and ${} = {} \\cdot {} + {}$.", byte,
                             kChannels[static_cast<std::size_t>(byte) % kBytesPerPixel], pixel, pixel, row,
                             frame.width(), column);
    return a;
}

Accepted byte_of_pixel(const Asked& asked) {
    Accepted a;
    Integer at = 0;
    if (!pixel_asked(asked, a, at)) return a;
    const Integer channel = asked.whole(2);
    if (channel < 0 || channel >= Integer{kBytesPerPixel}) return a.sentence = "A pixel has channels 0, 1 and 2.", a;
    a.number = static_cast<double>(Integer{kBytesPerPixel} * at + channel);
    a.sentence = fmt::format("It is pixel {}, and $3 \\cdot {} + {} = {}$.", at, at, channel, *a.number);
    return a;
}

Accepted address_of(const Asked& asked) {
    Accepted a;
    Integer at = 0;
    if (!pixel_asked(asked, a, at)) return a;
    const Rect frame = asked.drawing.scene().framebuffer.rect();
    a.number = static_cast<double>(at);
    a.sentence = fmt::format("${} \\cdot {} + {} = {}$: whole rows above it, then the column.",
                             asked.whole(1) - frame.y0, frame.width(), asked.whole(0) - frame.x0, at);
    return a;
}

Accepted doubles(const Asked& asked) {
    const Drawing drawing(asked.drawing.scene(), with_quirks(asked.drawing, asked.call.quirks));
    const Grid<std::uint8_t> counts = write_counts(drawing);
    const Rect frame = drawing.scene().framebuffer.rect();
    Accepted a{.number = 0, .step = asked.step, .sentence = std::string(kNoDouble)};
    for (int y = 0; y < counts.height(); ++y) {
        for (int x = 0; x < counts.width(); ++x) {
            if (counts.at(x, y) < 2) continue;
            if (*a.number == 0) a.places = {{frame.x0 + x, frame.y0 + y}};
            *a.number += 1;
        }
    }
    if (a.places.empty()) return a;
    const glm::ivec2 first = a.places.front();
    a.places.clear();
    a.sentence = fmt::format(kDoubles, *a.number, first.x, first.y);
    int writes = 0;
    for (const auto& [shape, sample] : samples_at(drawing, first.x, first.y)) {
        if (sample.fate != Fate::written || ++writes != 2) continue;
        if (const auto step = pixel_step(asked.steps, shape, first.x, first.y)) a.step = *step;
    }
    return a;
}

Accepted drawn(const Asked& asked) {
    const Drawing drawing(asked.drawing.scene(), with_quirks(asked.drawing, asked.call.quirks));
    const Grid<std::uint8_t> counts = write_counts(drawing);
    Integer pixels = 0;
    for (std::size_t n = 0; n < counts.size(); ++n) pixels += counts.data()[n] > 0;
    return {.number = static_cast<double>(pixels),
            .step = asked.step,
            .sentence = fmt::format("{} pixels are drawn.", pixels)};
}

Accepted owner(const Asked& asked) {
    constexpr std::array<std::string_view, 4> kSays{
        "Only the first accepts the sample.", "Only the second accepts the sample.",
        "Both accept the sample: it is drawn twice.", "Neither accepts the sample: nothing is drawn there."};
    Accepted a{.options = {3}, .step = asked.step, .sentence = std::string(kSays[3])};
    if (asked.shape() < 0) return a;
    const Drawing drawing(asked.drawing.scene(), with_quirks(asked.drawing, asked.call.quirks));
    const Integer x = asked.whole(0), y = asked.whole(1);
    const int first = drawing.first_shape_of(drawing.polygon_of(asked.shape()));
    const int polygon = drawing.polygon_of(first);
    std::array<bool, 2> written{};
    for (const auto& [shape, sample] : samples_at(drawing, x, y)) {
        if (sample.fate != Fate::written || shape < first || shape > first + 1 || drawing.polygon_of(shape) != polygon)
            continue;
        written[static_cast<std::size_t>(shape - first)] = true;
    }
    const int option = written[0] ? (written[1] ? 2 : 0) : written[1] ? 1 : 3;
    const int shape = option == 1 || option == 2 ? first + 1 : first;
    a.options = {option};
    a.sentence = kSays[static_cast<std::size_t>(option)];
    if (const auto step = pixel_step(asked.steps, shape, x, y)) a.step = *step;
    return a;
}

Accepted texel_of(const Asked& asked) {
    const Integer x = asked.whole(0), y = asked.whole(1);
    Accepted a{.step = asked.step, .sentence = std::string(kNoTexel)};
    for (const auto& [shape, sample] : samples_at(asked.drawing, x, y)) {
        if (shape != asked.shape()) continue;
        if (const auto step = pixel_step(asked.steps, shape, x, y)) a.step = *step;
        if (sample.fate != Fate::written) continue;
        a.places = {{sample.column, sample.row}};
        a.sentence = fmt::format("${}$ and ${}$: column {}, row {}.", equation("u", sample.u, 2),
                                 equation("v", sample.v, 2), sample.column, sample.row);
    }
    return a;
}

}  // namespace texelscope::answers
