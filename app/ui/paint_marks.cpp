// Marks, arrows and icons of paint.h.
#include <array>
#include <cmath>

#include <glm/geometric.hpp>

#include "app/ui/paint.h"

namespace texelscope::ui {
namespace {

void triangle(ImDrawList& list, glm::vec2 a, glm::vec2 b, glm::vec2 c, Color color) {
    const std::array<glm::vec2, 3> corners{a, b, c};
    fill_convex(list, corners, color);
}

void polyline(ImDrawList& list, std::span<const glm::vec2> points, float width, Color color) {
    for (const glm::vec2 p : points) list.PathLineTo(to_im(p));
    list.PathStroke(color, 0, width);
}

}  // namespace

void line(ImDrawList& list, glm::vec2 from, glm::vec2 to, float width, Color color) {
    // ImDrawList::AddLine moves both ends by half a pixel; the path does not.
    const std::array<glm::vec2, 2> ends{from, to};
    polyline(list, ends, width, color);
}

void arrow(ImDrawList& list, glm::vec2 from, glm::vec2 to, float width, Color color, float head) {
    const float length = glm::distance(from, to);
    if (!(length > 0)) return;
    const glm::vec2 way = (to - from) / length, across{-way.y, way.x};
    const float h = std::min(head, length);
    line(list, from, to - way * (h * 0.8F), width, color);
    triangle(list, to, to - way * h + across * (h * 0.45F), to - way * h - across * (h * 0.45F), color);
}

void vertex_ring(ImDrawList& list, glm::vec2 centre, float radius, Color color, Color ground) {
    list.AddCircleFilled(to_im(centre), radius + 1.5F, ground);
    list.AddCircle(to_im(centre), radius - 0.9F, color, 0, 1.8F);
    list.AddCircleFilled(to_im(centre), radius * 0.3F, color);
}

void edge_mark(ImDrawList& list, int edge, glm::vec2 centre, float radius, Color color) {
    if (edge == 0) {
        list.AddCircleFilled(to_im(centre), radius, color);
    } else if (edge == 1) {
        fill(list,
             {std::round(centre.x - radius), std::round(centre.y - radius), std::round(2 * radius),
              std::round(2 * radius)},
             color);
    } else {
        triangle(list, centre + glm::vec2(0, -1.1F * radius), centre + glm::vec2(1.1F * radius, 0.9F * radius),
                 centre + glm::vec2(-1.1F * radius, 0.9F * radius), color);
    }
}

void cross(ImDrawList& list, glm::vec2 centre, float radius, float width, Color color) {
    line(list, centre - glm::vec2(radius), centre + glm::vec2(radius), width, color);
    line(list, centre + glm::vec2(-radius, radius), centre + glm::vec2(radius, -radius), width, color);
}

void draw_icon(ImDrawList& list, Icon icon, const Area& area, Color color) {
    const glm::vec2 c = area.centre();
    const float s = std::min(area.w, area.h) / 32, stroke = std::max(1.5F, 1.8F * s);
    const auto at = [&](float x, float y) { return c + glm::vec2(x, y) * s; };
    const auto bar = [&](float x) {
        fill(list,
             {std::round(c.x + x * s), std::round(c.y - 6 * s), std::max(2.0F, std::round(2 * s)), std::round(12 * s)},
             color);
    };
    switch (icon) {
        case Icon::first:
            bar(-7), bar(-3);
            triangle(list, at(7, -6), at(7, 6), at(0, 0), color);
            break;
        case Icon::previous:
            bar(-5);
            triangle(list, at(5, -6), at(5, 6), at(-2, 0), color);
            break;
        case Icon::play: triangle(list, at(-5, -7), at(7, 0), at(-5, 7), color); break;
        case Icon::pause: bar(-5), bar(3); break;
        case Icon::next:
            bar(3);
            triangle(list, at(-5, -6), at(2, 0), at(-5, 6), color);
            break;
        case Icon::last:
            bar(1), bar(5);
            triangle(list, at(-7, -6), at(0, 0), at(-7, 6), color);
            break;
        case Icon::tick: polyline(list, std::array{at(-7, 0), at(-2, 5), at(8, -6)}, stroke, color); break;
        case Icon::arrow_right: arrow(list, at(-8, 0), at(8, 0), stroke * 1.2F, color, 8 * s); break;
        case Icon::chevron: polyline(list, std::array{at(-3, -6), at(3, 0), at(-3, 6)}, stroke, color); break;
        case Icon::close: cross(list, c, 6 * s, stroke, color); break;
    }
}

}  // namespace texelscope::ui
