// Small drawings for the lessons, each a line of strokes on a grid of 22 by 22.
#include <array>
#include <cmath>

#include "app/views/screen_parts.h"

namespace texelscope {
namespace {

using ui::Area;
using ui::Role;

constexpr float kGrid = 22;

// A capital is drawn in `now`, a small letter in the text's quiet colour.
// l x0 y0 x1 y1: line; p n x y …: outline; f n x y …: filled; d x y: dot; s x y a: square; r x y w h: frame.
constexpr std::array<std::string_view, kCurriculum> kDrawings{
    "s 2 2 4 s 7 2 4 s 12 2 4 s 17 2 4 s 2 7 4 s 7 7 4 S 12 7 4 s 17 7 4 s 2 12 4 s 7 12 4 s 12 12 4 s 17 12 4 "
    "s 2 17 4 s 7 17 4 s 12 17 4 s 17 17 4",
    "s 1 2 4 s 6 2 4 s 11 2 4 s 16 2 4 l 3 7 2 15 l 8 7 7 15 L 13 7 12 15 l 18 7 17 15 s 1 16 3 s 5 16 3 S 10 16 3 "
    "s 15 16 3 s 19 16 3",
    "s 7 2 4 s 12 2 4 s 2 7 4 s 7 7 4 s 17 7 4 R 7 12 5 5 s 2 17 4 s 17 12 4 s 12 17 4",
    "s 1 4 8 L 10 8 14 8 l 12 13 14 13 p 4 13 6 20 9 20 20 13 16",
    "r 2 2 18 18 P 3 6 5 18 11 9 17",
    "r 2 2 18 18 l 2 20 20 2 D 11 11",
    "p 3 11 2 20 19 2 19 L 6 12 16 12 D 6 12 D 16 12",
    "r 2 2 18 18 L 3 7 19 15 D 5 8 D 9 10 D 13 12 D 17 14",
    "p 4 8 4 21 8 14 18 1 13 L 1 17 14 21 L 14 21 21 12",
    "L 2 19 2 15 L 2 15 7 15 L 7 15 7 11 L 7 11 12 11 L 12 11 12 7 L 12 7 17 7 L 17 7 17 3 L 17 3 21 3",
    "p 3 11 2 20 19 2 19 l 11 2 11 13 l 20 19 11 13 l 2 19 11 13 D 11 13",
    "p 4 7 4 14 4 20 19 2 19 L 7 4 20 19",
    "p 4 8 3 14 3 20 19 2 19 l 6 8 16 8 l 4 13 18 13 L 11 3 11 19",
    "f 4 3 9 19 9 17 15 5 15 p 5 11 2 20 9 17 19 5 19 2 9 L 3 9 19 9",
    "p 6 11 2 19 6 19 16 11 20 3 16 3 6 l 11 11 11 20 l 11 11 19 6 L 11 11 3 6",
    "p 6 11 2 19 6 19 16 11 20 3 16 3 6 F 3 11 6 16 9 11 13",
    "p 3 5 2 9 9 2 9 p 3 14 6 20 8 15 12 p 3 4 13 8 20 2 19 P 3 13 14 20 20 11 20",
    "r 2 4 6 6 r 8 4 6 6 r 14 4 6 6 r 2 11 6 6 R 8 11 6 6 r 14 11 6 6",
    "l 3 2 3 19 l 3 19 20 19 L 5 4 8 12 L 8 12 18 16 D 5 4 D 8 12 D 13 14 D 18 16",
    "r 2 3 18 16 L 6 7 6 15 L 16 7 16 15 l 6 11 16 11 D 11 11",
    "S 2 17 4 s 7 17 4 s 12 17 4 s 17 17 4 s 2 12 4 S 7 12 4 s 12 12 4 s 12 7 4 S 17 2 4 S 12 7 4 s 17 7 4 s 7 7 4",
};

/// Reads one drawing; every number is small and not negative.
class Strokes {
public:
    Strokes(std::string_view text, const Area& place) : text_(text), place_(place) {}

    [[nodiscard]] char letter() {
        while (at_ < text_.size() && text_[at_] == ' ') ++at_;
        return at_ < text_.size() ? text_[at_++] : '\0';
    }
    [[nodiscard]] float number() {
        while (at_ < text_.size() && text_[at_] == ' ') ++at_;
        int n = 0;
        while (at_ < text_.size() && text_[at_] >= '0' && text_[at_] <= '9') n = 10 * n + (text_[at_++] - '0');
        return static_cast<float>(n);
    }
    [[nodiscard]] float length() { return number() * place_.w / kGrid; }
    [[nodiscard]] glm::vec2 point() {
        const float x = length(), y = length();
        return {place_.x + x, place_.y + y};
    }
    [[nodiscard]] std::vector<glm::vec2> polygon() {
        std::vector<glm::vec2> points(static_cast<std::size_t>(number()));
        for (glm::vec2& p : points) p = point();
        return points;
    }

private:
    std::string_view text_;
    Area place_;
    std::size_t at_ = 0;
};

void draw_stroke(ImDrawList& list, Strokes& in, char small, ui::Color color, float width) {
    switch (small) {
        case 'l': {
            const glm::vec2 from = in.point(), to = in.point();
            ui::line(list, from, to, width, color);
            break;
        }
        case 'p': {
            const std::vector<glm::vec2> points = in.polygon();
            for (std::size_t i = 0; i < points.size(); ++i)
                ui::line(list, points[i], points[(i + 1) % points.size()], width, color);
            break;
        }
        case 'f': ui::fill_convex(list, in.polygon(), ui::with_alpha(color, .5F)); break;
        case 'd': list.AddCircleFilled(ui::to_im(in.point()), 1.6F * width, color); break;
        case 's': {
            const glm::vec2 at = in.point();
            const float side = in.length();
            ui::fill(list, {std::round(at.x), std::round(at.y), std::round(side), std::round(side)}, color);
            break;
        }
        default: {
            const glm::vec2 at = in.point();
            const float w = in.length(), h = in.length();
            ui::frame(list, {std::round(at.x), std::round(at.y), std::round(w), std::round(h)}, color,
                      std::round(width));
        }
    }
}

}  // namespace

void draw_lesson_icon(ui::Ui& ui, int number, const Area& place, bool muted) {
    const ui::Color quiet = ui.theme()[muted ? Role::faint : Role::muted];
    const ui::Color strong = muted ? quiet : ui.theme()[Role::now];
    const bool known = number >= 1 && number <= kCurriculum;
    Strokes in(known ? kDrawings[static_cast<std::size_t>(number - 1)] : std::string_view("r 3 3 16 16"), place);
    for (char letter = in.letter(); letter != '\0'; letter = in.letter()) {
        const bool capital = letter >= 'A' && letter <= 'Z';
        const char small = capital ? static_cast<char>(letter - 'A' + 'a') : letter;
        const bool area = small == 's' || small == 'f';
        const ui::Color color = capital ? strong : area ? ui::with_alpha(quiet, .6F) : quiet;
        draw_stroke(ui.list(), in, small, color, std::max(1.0F, 1.3F * place.w / kGrid));
    }
}

}  // namespace texelscope
