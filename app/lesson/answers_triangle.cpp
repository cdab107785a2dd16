#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "app/lesson/answers.h"
#include "app/lesson/facts.h"

namespace texelscope::answers {
namespace {

constexpr std::array<std::string_view, 6> kCoefficients{"u_x", "u_y", "u_k", "v_x", "v_y", "v_k"};

/// The scene with a change, drawn the same way, and what a visit of one shape records outside of its loops.
struct Variation {
    Scene scene;
    Drawing drawing;
    Variation(Scene changed, const DrawSettings& settings) : scene(std::move(changed)), drawing(scene, settings) {}
    Variation(const Variation&) = delete;
    Variation& operator=(const Variation&) = delete;
    [[nodiscard]] Visit setup(int shape) const { return visit(drawing, Path{{{'t', shape}}}); }
};

[[nodiscard]] float& coordinate(Vertex& vertex, char name) {
    return name == 'x' ? vertex.x : name == 'y' ? vertex.y : name == 'u' ? vertex.u : vertex.v;
}

/// The vertex of the scene that corner `corner` of the shape was cut from; null where it has none.
[[nodiscard]] Vertex* corner_in(Scene& scene, const Drawing& drawing, int shape, int corner) {
    if (shape < 0 || corner < 0 || corner >= static_cast<int>(drawing.corners(shape).size())) return nullptr;
    auto& vertices = scene.polygons[static_cast<std::size_t>(drawing.polygon_of(shape))].vertices;
    return &vertices[static_cast<std::size_t>(drawing.vertex_of(shape, corner))];
}

[[nodiscard]] Integer count(const Grid<Coverage>& covered, Coverage least) {
    return std::count_if(covered.data(), covered.data() + covered.size(), [&](Coverage c) { return c >= least; });
}

}  // namespace

Accepted fate(const Asked& asked) {
    constexpr std::array<std::string_view, 5> kSays{
        "All three signs say inside.", "Side A says outside first; the others are not asked.",
        "Side B says outside first: A agreed, and C is not asked.", "A and B agree; side C says outside.",
        "The loops never come here, so no sign is computed."};
    const Integer x = asked.whole(0), y = asked.whole(1);
    Accepted a{.options = {4}, .step = asked.step, .sentence = std::string(kSays[4])};
    for (const auto& [shape, sample] : samples_at(asked.drawing, x, y)) {
        if (shape != asked.shape()) continue;
        const int side = static_cast<int>(sample.fate) - static_cast<int>(Fate::outside_edge_a);
        const int option = side >= 0 && side < 3 ? side + 1 : 0;
        a.options = {option};
        a.sentence = kSays[static_cast<std::size_t>(option)];
    }
    if (const auto step = pixel_step(asked.steps, asked.shape(), x, y))
        a.step = *step;
    else if (const auto box = expression_step(asked.steps, asked.shape(), "x_a"))
        a.step = *box;
    return a;
}

Accepted box_samples(const Asked& asked) {
    Accepted a{.number = 0, .step = asked.step, .sentence = "Nothing of it is visited."};
    const int shape = asked.shape();
    if (shape < 0) return a;
    if (const auto box = expression_step(asked.steps, shape, "x_a")) a.step = *box;
    const Visit setup = asked.steps.at(Path{{{'t', shape}}});
    const auto side = [&](const char* first, const char* last) {
        const auto low = value_named(setup, first), high = value_named(setup, last);
        return low && high ? std::max<Integer>(0, std::get<Integer>(*high) - std::get<Integer>(*low)) : 0;
    };
    const Integer columns = side("x_a", "x_b"), rows = side("y_a", "y_b");
    if (columns == 0 || rows == 0) return a;
    a.number = static_cast<double>(columns * rows);
    a.sentence = fmt::format("${} \\times {} = {}$ samples.", columns, rows, columns * rows);
    return a;
}

Accepted drawn_after_exchange(const Asked& asked) {
    constexpr std::array<std::string_view, 3> kSays{
        "All signs turn, and the set-up turns them back: inside is inside.",
        "All signs turn, so no sample has three that agree: a hole, not an error.", "Every sample of the box passes."};
    Accepted a{.step = asked.step};
    const int shape = asked.shape();
    Scene scene = asked.drawing.scene();
    Vertex* p = corner_in(scene, asked.drawing, shape, asked.whole(0));
    Vertex* q = corner_in(scene, asked.drawing, shape, asked.whole(1));
    if (p == nullptr || q == nullptr) return a.options = {0}, a.sentence = "There are no such corners.", a;
    std::swap(*p, *q);
    const Variation exchanged(std::move(scene), with_quirks(asked.drawing, asked.call.quirks));
    const Drawing standing(asked.drawing.scene(), exchanged.drawing.settings());
    const Grid<Coverage> before = coverage(standing, shape), after = coverage(exchanged.drawing, shape);
    const Integer written = count(after, Coverage::written);
    if (written == 0) a.options.push_back(1);
    if (written > 0 && written == count(after, Coverage::rejected)) a.options.push_back(2);
    const bool same =
        std::equal(before.data(), before.data() + before.size(), after.data(),
                   [](Coverage b, Coverage c) { return (b == Coverage::written) == (c == Coverage::written); });
    if (same || a.options.empty()) a.options.insert(a.options.begin(), 0);
    a.sentence = kSays[static_cast<std::size_t>(a.options.front())];
    if (const auto step = expression_step(asked.steps, shape, "n_x_A")) a.step = *step;
    return a;
}

Accepted changed_coefficients(const Asked& asked) {
    const std::string& corner = asked.call.words.front();
    const int shape = asked.shape(), number = corner[1] - '0';
    const auto with_value = [&](double value) {
        Scene scene = asked.drawing.scene();
        if (Vertex* p = corner_in(scene, asked.drawing, shape, number))
            coordinate(*p, corner[0]) = static_cast<float>(value);
        return Variation(std::move(scene), asked.drawing.settings()).setup(shape);
    };
    const Visit from = with_value(asked.call.numbers[0]), to = with_value(asked.call.numbers[1]);
    Accepted a{.step = asked.step};
    std::string names;
    for (std::size_t n = 0; n < kCoefficients.size(); ++n) {
        a.option_steps.push_back(expression_step(asked.steps, shape, kCoefficients[n]).value_or(asked.step));
        if (same_value(value_named(from, kCoefficients[n]), value_named(to, kCoefficients[n]))) continue;
        a.options.push_back(static_cast<int>(n));
        names += fmt::format("{}${}$", names.empty() ? "" : ", ", kCoefficients[n]);
    }
    a.sentence = a.options.empty() ? "None of them changes."
                                   : fmt::format("{} change{}: they are made from ${}_{}$.", names,
                                                 a.options.size() == 1 ? "s" : "", corner[0], corner[1]);
    return a;
}

}  // namespace texelscope::answers
