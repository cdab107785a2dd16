#include "app/state/lesson_table.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace texelscope {
namespace {

struct Planned {
    std::string_view title, group, summary;
};

constexpr std::string_view kSampling = "Sampling", kTriangles = "Triangles", kPlanes = "Planes over the screen",
                           kLessonTablePerspective = "Perspective", kPolygons = "Polygons and solids",
                           kSpeed = "Speed and truth";

// clang-format off
constexpr std::array<Planned, kCurriculum> kPlanned{{
    {"A screen is an array", kSampling, "A picture is a list of numbers, and $y · w + x$ says which. A pixel has a centre."},
    {"Sampling ratio, in one dimension", kSampling, "Shrinking drops texels, growing repeats them. Where the first sample lies is a choice."},
    {"Forward or backward?", kSampling, "Whoever drives the loop decides what can go wrong. Forward mapping leaves holes."},
    {"Two passes", kSampling, "Two mappings of one dimension replace one of two. The buffer between them can lose detail."},
    {"Half-planes and the bounding box", kTriangles, "Inside is where three signs agree. Which sign it is depends on the winding."},
    {"Whose pixel is it?", kTriangles, "A sample on a shared edge needs exactly one owner. Without a rule it is drawn twice, or never."},
    {"Walking the edges", kTriangles, "Each edge moves by one addition a line. Flat bottoms and flat tops meet in the middle."},
    {"Texture on a span", kTriangles, "Every row of the screen is a straight line through the texture. At the apex, $0 / 0$ is born."},
    {"The u v plane by Cramer", kPlanes, "Two gradients are the whole triangle. Where $Δ = 0$ there are none."},
    {"Two additions per pixel", kPlanes, "Adding the gradient is cheaper than multiplying. What rounding adds up to depends on the numbers."},
    {"Barycentric weights", kPlanes, "Each corner weighs what the opposite area says. Weights are edge functions over twice the area."},
    {"The diagonal seam", kLessonTablePerspective, "Perspective needs $u / z$, $v / z$ and $1 / z$, then one division per pixel. Without it the two halves of a quad agree on the diagonal but not on either side of it."},
    {"Homogeneous inverse", kLessonTablePerspective, "Three additions and two divisions a pixel. Where the denominator is constant along a row, the divisions leave the loop."},
    {"Convex polygons in sections", kPolygons, "Two pointers walk down the ring of corners, left and right. Between two corners both sides are straight."},
    {"Solids and moving textures", kPolygons, "Rotate, project, cull, map. One mapper serves squares, pentagons and triangles."},
    {"Jelly cubes", kPolygons, "Rotate back, then cut at one. In the right frame a plane cut is a single comparison."},
    {"Random triangles: the race", kSpeed, "Small triangles pay for the set-up, large ones for the inner loop. See where the time goes."},
    {"Six mappers, one triangle", kSpeed, "Two methods side by side, and every pixel in which they differ. Each difference has a cause with a name."},
    {"What accuracy costs", kSpeed, "Run time against error: every method and number format is a point. What to give up, and for how much."},
    {"Texels one can trust", kSpeed, "A value and its bound against the texel's border. Exactness costs little where it is asked for only in doubt."},
    {"Work not done", kSpeed, "Every skip has a counter and a switch. The picture never changes; the bill does."},
}};
// clang-format on

void take_over(LessonEntry& entry, const Lesson& lesson) {
    entry.lesson = &lesson;
    entry.number = lesson.number;
    if (!lesson.title.empty()) entry.title = lesson.title;
    if (!lesson.group.empty()) entry.group = lesson.group;
    if (!lesson.summary.empty()) entry.summary = lesson.summary;
}

constexpr int kDigits = 9;

}  // namespace

std::vector<LessonEntry> lesson_entries(std::span<const Lesson> lessons) {
    std::vector<LessonEntry> entries;
    for (int n = 0; n < kCurriculum; ++n) {
        const Planned& planned = kPlanned[static_cast<std::size_t>(n)];
        entries.push_back(
            {n + 1, std::string(planned.title), std::string(planned.group), std::string(planned.summary)});
    }
    for (const Lesson& lesson : lessons) {
        if (lesson.number >= 1 && lesson.number <= kCurriculum) {
            take_over(entries[static_cast<std::size_t>(lesson.number - 1)], lesson);
        } else {
            take_over(entries.emplace_back(), lesson);
        }
    }
    std::stable_sort(entries.begin() + kCurriculum, entries.end(),
                     [](const LessonEntry& a, const LessonEntry& b) { return a.number < b.number; });
    return entries;
}

std::optional<ui::Key> key_of_lesson(int number) {
    if (number < 1 || number > kCurriculum) return std::nullopt;
    const auto offset = [](ui::Key key, int by) { return static_cast<ui::Key>(static_cast<int>(key) + by); };
    return number <= kDigits ? offset(ui::Key::n0, number) : offset(ui::Key::a, number - kDigits - 1);
}

std::string key_cap_of_lesson(int number) {
    if (number < 1 || number > kCurriculum) return {};
    return {static_cast<char>(number <= kDigits ? '0' + number : 'a' + number - kDigits - 1)};
}

std::optional<int> lesson_of_key(ui::Key key) {
    for (int n = 1; n <= kCurriculum; ++n) {
        if (key_of_lesson(n) == key) return n;
    }
    return std::nullopt;
}

}  // namespace texelscope
