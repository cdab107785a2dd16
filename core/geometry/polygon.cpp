#include "core/geometry/polygon.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace texelscope {
namespace {

struct Coordinate {
    const char* name;
    float Vertex::*value;
};
constexpr std::array<Coordinate, 6> kCoordinates{
    {{"x", &Vertex::x}, {"y", &Vertex::y}, {"z", &Vertex::z}, {"w", &Vertex::w}, {"u", &Vertex::u}, {"v", &Vertex::v}}};

/// Counts how often a sequence of numbers changes sign; zeros do not count.
class SignChanges {
public:
    void next(double value) {
        const int sign = (value > 0) - (value < 0);
        if (sign == 0) return;
        if (last_ != 0 && sign != last_) ++count_;
        last_ = sign;
    }
    [[nodiscard]] int count() const { return count_; }

private:
    int last_ = 0, count_ = 0;
};

}  // namespace

bool is_finite(const Vertex& vertex) noexcept {
    for (const Coordinate& coordinate : kCoordinates)
        if (!std::isfinite(vertex.*coordinate.value)) return false;
    return true;
}

bool is_drawable(const Vertex& vertex) noexcept { return is_finite(vertex) && vertex.w > 0; }

bool is_drawable(const Polygon& polygon) noexcept {
    if (polygon.vertices.size() < 3 || !std::isfinite(polygon.light)) return false;
    return std::all_of(polygon.vertices.begin(), polygon.vertices.end(),
                       [](const Vertex& v) { return is_drawable(v); });
}

std::string polygon_fault(const Polygon& polygon) {
    if (polygon.vertices.size() < 3) return "it has fewer than three vertices";
    if (!std::isfinite(polygon.light)) return "its light is not finite";
    for (std::size_t i = 0; i < polygon.vertices.size(); ++i) {
        const Vertex& vertex = polygon.vertices[i];
        for (const Coordinate& coordinate : kCoordinates)
            if (!std::isfinite(vertex.*coordinate.value))
                return std::string(coordinate.name) + " of its vertex " + std::to_string(i) + " is not finite";
        if (vertex.w <= 0) return "w of its vertex " + std::to_string(i) + " is not above 0";
    }
    return {};
}

double doubled_area(std::span<const Vertex> corners) noexcept {
    double area = 0;
    for (std::size_t i = 2; i < corners.size(); ++i) {
        const double ax = double{corners[i - 1].x} - corners[0].x, ay = double{corners[i - 1].y} - corners[0].y;
        const double bx = double{corners[i].x} - corners[0].x, by = double{corners[i].y} - corners[0].y;
        area += ax * by - bx * ay;
    }
    return area;
}

bool is_convex(std::span<const Vertex> corners) noexcept {
    constexpr double kStraight = 0x1p-40;  // sine of a bend that counts as straight
    SignChanges turns, right, down;
    const std::size_t count = corners.size();
    double last_x = 0, last_y = 0;                 // the last side that has a length
    for (std::size_t i = 0; i < 2 * count; ++i) {  // twice round: the bend at the first corner counts too
        const Vertex &a = corners[i % count], &b = corners[(i + 1) % count];
        const double x = double{b.x} - a.x, y = double{b.y} - a.y;
        if (x == 0 && y == 0) continue;
        const double bend = last_x * y - last_y * x;
        if (std::fabs(bend) > kStraight * std::hypot(last_x, last_y) * std::hypot(x, y)) turns.next(bend);
        right.next(x);
        down.next(y);
        last_x = x, last_y = y;
    }
    // Round once, a direction's sign changes twice; twice round adds at most four.
    return turns.count() == 0 && right.count() <= 4 && down.count() <= 4;
}

}  // namespace texelscope
