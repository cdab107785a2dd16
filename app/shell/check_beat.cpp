#include "app/shell/check_beat.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "app/lesson/facts.h"
#include "app/lesson/questions.h"
#include "app/state/lesson_cursor.h"
#include "app/views/screen.h"

namespace texelscope {
namespace {

constexpr std::string_view kLetters = "TGSPE";  ///< of the levels, as a lesson's `levels` has them

/// Views that look for what only some methods compute: a row for each of these.
struct Special {
    std::string_view view, method;
};
constexpr auto kSpecials = std::to_array<Special>({
    {"signs", "edge-equations"},
    {"passes", "edge-equations"},
    {"face", "sections"},
    {"ring", "sections"},
    {"matrix", "backward-affine"},
    {"matrix", "backward-projective"},
    {"matrix", "constant-z"},
    {"walk", "edge-walk"},
    {"weights", "barycentric"},
    {"strip", "sampling-1d"},
    {"lockstep", "forward"},
    {"lockstep", "backward-affine"},
    {"lockstep", "backward-projective"},
    {"buffer", "two-pass"},
});

/// Views that show a part of the scene that not every scene has.
struct Needed {
    std::string_view view, what;
    bool (*has)(const Scene&);
};
[[nodiscard]] bool has_jelly_cubes(const Scene& scene) {
    return std::any_of(scene.meshes.begin(), scene.meshes.end(),
                       [](const MeshPlacement& mesh) { return mesh.shape == Shape3d::jelly_cubes; });
}
[[nodiscard]] bool has_palette(const Scene& scene) {
    return std::any_of(scene.textures.begin(), scene.textures.end(),
                       [](const auto& texture) { return !texture->palette.empty(); });
}
constexpr std::array<Needed, 7> kNeeded{
    {{"race", "random triangles", [](const Scene& s) { return s.random.has_value(); }},
     {"front", "random triangles", [](const Scene& s) { return s.random.has_value(); }},
     {"skips", "random triangles", [](const Scene& s) { return s.random.has_value(); }},
     {"palette", "a texture with a palette", has_palette},
     {"solids", "a solid", [](const Scene& s) { return !s.meshes.empty(); }},
     {"frames", "a texture with frames", [](const Scene& s) { return !s.animations.empty(); }},
     {"cut", "jelly cubes", has_jelly_cubes}}};

class BeatChecker {
public:
    explicit BeatChecker(Store& store)
        : store_(store),
          state_(store.state()),
          lesson_(*state_.document->lesson),
          beat_(lesson_.beats[static_cast<std::size_t>(state_.cursor.beat)]) {}

    std::vector<BeatFault> run() {
        if (beat_.set.step) check_path("step", *beat_.set.step, beat_.set.lines);
        check_level();
        if (beat_.set.random && !derived().scene().random)
            fault(beat_.set.lines.of("random"), "sets random triangles, but the scene has none");
        if (beat_.set.pin) check_pin();
        if (beat_.prediction) check_prediction(*beat_.prediction);
        return std::move(faults_);
    }

private:
    [[nodiscard]] Derived& derived() { return store_.derived(); }
    void fault(int line, std::string what) { faults_.push_back({line, std::move(what)}); }

    void check_path(std::string_view key, const Path& path, const KeyLines& lines) {
        if (const auto missing = missing_part(derived().steps(), path))
            fault(lines.of(key), fmt::format("there is no {} {}: {}", key == "step" ? "step" : "step to explain it,",
                                             path.text(), *missing));
    }

    void check_level() {
        const KeyLines& lines = beat_.set.lines;
        if (state_.cursor.beat > 0 && !beat_.set.step && !beat_.set.level) return;  // said where it was set
        const char letter = kLetters[static_cast<std::size_t>(state_.cursor.level)];
        if (lesson_.levels.find(letter) != std::string::npos) return;
        const int line = beat_.set.level ? lines.of("level") : beat_.set.step ? lines.of("step") : beat_.line;
        fault(line, fmt::format("the level here is '{}', but levels = \"{}\" leaves {} out", id_of(state_.cursor.level),
                                lesson_.levels, letter));
    }

    void check_pin() {
        const Selection& pin = state_.pinned;
        const auto nothing = [&](std::string_view why) {
            fault(beat_.set.lines.of("pin"), fmt::format("pin '{}' points at nothing here: {}", *beat_.set.pin, why));
        };
        const auto within = [&](int x0, int y0, int x1, int y1) {
            return fmt::format("expected {} to {}, {} to {}", x0, x1 - 1, y0, y1 - 1);
        };
        switch (pin.kind) {
            case Selection::Kind::pixel: {
                const Rect frame = derived().scene().framebuffer.rect();
                if (!frame.contains(pin.at.x, pin.at.y)) nothing(within(frame.x0, frame.y0, frame.x1, frame.y1));
                break;
            }
            case Selection::Kind::texel: {
                const int width = derived().texture().width(), height = derived().texture().height();
                if (!Rect{0, 0, width, height}.contains(pin.at.x, pin.at.y)) nothing(within(0, 0, width, height));
                break;
            }
            case Selection::Kind::name:
                if (!value_named(derived().visit(), pin.name)) nothing("the name has no value at this step");
                break;
            case Selection::Kind::line:
                if (pin.line < 1 || pin.line > static_cast<int>(derived().listing().lines.size()))
                    nothing("the listing has no such line");
                break;
            default: nothing("expected a pixel, texel, name or line");
        }
    }

    void check_prediction(const Prediction& asked) {
        const auto views = side_views(state_);
        const auto shows = [&](std::string_view view) {
            return std::find(views.begin(), views.end(), view) != views.end();
        };
        if (asked.kind == Prediction::Kind::texel && !shows("texels") && !shows("face"))
            fault(asked.lines.of("kind"), "kind is 'texel', but no view here has texels to click, expected texels");
        if (asked.kind == Prediction::Kind::line && !shows("code"))
            fault(asked.lines.of("kind"), "kind is 'line', but no view here has lines to click, expected code");
        if (const auto explain = parse_path(asked.explain)) check_path("explain", *explain, asked.lines);
        const Accepted right = accepted(asked, derived().drawing(), derived().steps(), state_.cursor.step);
        if (right.options.empty() && !right.number && right.places.empty())
            fault(asked.lines.of("answer"), fmt::format("'{}' has no answer here. {}", asked.answer, right.sentence));
    }

    Store& store_;
    const State& state_;
    const Lesson& lesson_;
    const Beat& beat_;
    std::vector<BeatFault> faults_;
};

}  // namespace

std::vector<BeatFault> beat_faults(Store& store) { return BeatChecker(store).run(); }

std::string view_fault(std::string_view view, const Method& method) {
    std::string methods;
    for (const Special& special : kSpecials) {
        if (special.view != view) continue;
        if (special.method == method.id) return {};
        methods += fmt::format("{}{}", methods.empty() ? "" : " or ", special.method);
    }
    if (methods.empty()) return {};
    return fmt::format("views has '{}', which is for {}, but the lesson's method here is {}", view, methods, method.id);
}

std::string view_fault(std::string_view view, const Scene& scene) {
    const auto needed =
        std::find_if(kNeeded.begin(), kNeeded.end(), [view](const Needed& n) { return n.view == view; });
    if (needed == kNeeded.end() || needed->has(scene)) return {};
    return fmt::format("views has '{}', which needs {}, but the scene has none", view, needed->what);
}

}  // namespace texelscope
