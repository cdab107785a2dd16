#include <algorithm>
#include <cmath>
#include <numeric>

#include "app/lesson/questions.h"
#include "app/state/lesson_cursor.h"
#include "app/state/store.h"
#include "core/geometry/polygon.h"
#include "core/image/wrap.h"

namespace texelscope {
namespace {

constexpr std::string_view kAtEnd = "This is the last step.", kAtStart = "This is the first step.";
constexpr std::string_view kNothing = "This scene draws nothing: there are no steps.";
constexpr std::string_view kMoved = "That step is gone; this is the nearest one before it.";
constexpr std::string_view kTurnedAway = "That face is drawn no longer; this is another of its solid.";
constexpr std::string_view kLastBeat = "The lesson ends here. L opens the list of lessons.";
constexpr std::string_view kConvex = "This method takes convex polygons: the corner stays where it would still be one.";
constexpr std::string_view kSolid =
    "A solid's corners move with it: hold O and press arrows, or drag with the right button.";
constexpr std::string_view kNoRandom = "This scene has no random triangles.";
constexpr std::string_view kExactRace = "Exact numbers are no racers: they say what is right. Choose another format.";
constexpr float kLeastRatio = 0.05F, kMostRatio = 4;       ///< of jelly cubes
constexpr float kLeastFocal = 1, kMostFocal = 1 << 16;     ///< [px]
constexpr std::int64_t kLongestPeriod = 1 << 20;           ///< of all textures that move together [frames]
constexpr double kMostDegrees = 360;                       ///< of one turn
constexpr float kLeastDepth = 1.0F / 64, kMostDepth = 64;  ///< of a corner
constexpr float kFarthest = 1e6F;                          ///< a corner is kept within this of the origin [px]

/// The step and the level that a lesson's beats up to this one ask for.
[[nodiscard]] std::pair<Path, Level> step_asked(const State& state, int beat) {
    std::pair<Path, Level> asked;
    for (int n = 0; n <= beat && n < beat_count(state); ++n) {
        const BeatSettings& set = state.document->lesson->beats[static_cast<std::size_t>(n)].set;
        if (set.step) asked = {*set.step, level_of(*set.step)};
        if (set.level) asked.second = *set.level;
    }
    return asked;
}

/// Applies one action to `next`; `derived` shows the state before until update() is called.
class Reducer {
public:
    Reducer(State& next, Derived& derived) : s_(next), derived_(derived) {}

    void operator()(const action::Open& a) { s_ = opened(a.document, s_); }
    void operator()(const action::Reload& a) {
        const Cursor cursor = s_.cursor;
        const auto asked = step_asked(s_, cursor.beat);
        s_.document = a.document;
        if (!s_.document->lesson) return settle();
        go_to_beat(s_, std::min(cursor.beat, beat_count(s_) - 1), derived_);
        if (step_asked(s_, cursor.beat) != asked) return;  // the writer moved it, and wants to see that
        s_.cursor.level = cursor.level;
        s_.cursor.step = cursor.step;
        settle(false);
    }
    void operator()(const action::Say& a) { s_.message = a.message; }

    void operator()(const action::Step& a) {
        Steps& steps = derived_.steps();
        for (int n = 0; n < std::abs(a.count); ++n) {
            const auto to = a.count > 0 ? steps.next(s_.cursor.step, s_.cursor.level)
                                        : steps.previous(s_.cursor.step, s_.cursor.level);
            if (!to) return end_reached(a.count > 0);
            s_.cursor.step = *to;
        }
    }
    void operator()(const action::StepTo& a) {
        s_.cursor.level = level_of(a.path);
        if (const auto to = derived_.steps().nearest(a.path, s_.cursor.level)) s_.cursor.step = *to;
    }
    void operator()(const action::StepEnd& a) {
        const auto to = a.last ? derived_.steps().last(s_.cursor.level) : derived_.steps().first(s_.cursor.level);
        if (to) s_.cursor.step = *to;
    }
    void operator()(const action::Advance& a) {
        if (beat_count(s_) == 0) return (*this)(action::Step{a.count});
        const int beat = s_.cursor.beat + a.count;
        if (beat >= beat_count(s_)) {
            s_.message = {std::string(kLastBeat)};
            return;
        }
        go_to_beat(s_, std::max(0, beat), derived_);
    }
    void operator()(const action::SetLevel& a) {
        s_.cursor.level = a.level;
        if (!s_.cursor.step.empty()) s_.cursor.step = derived_.steps().at_level(s_.cursor.step, a.level);
    }
    void operator()(const action::Finer& a) {
        const int level = std::clamp(static_cast<int>(s_.cursor.level) + a.count, 0, kLevels - 1);
        (*this)(action::SetLevel{static_cast<Level>(level)});
    }
    void operator()(const action::StepIn&) { (*this)(action::Finer{1}); }
    void operator()(const action::FinishUnit&) { (*this)(action::Finer{-1}); }
    void operator()(const action::Play& a) { s_.playing = a.on; }
    void operator()(const action::Speed& a) { s_.look.speed = std::clamp(s_.look.speed * a.factor, 0.5F, 240.0F); }
    void operator()(const action::ToggleBookmark&) {
        const auto found = std::find(s_.bookmarks.begin(), s_.bookmarks.end(), s_.cursor.step);
        if (found != s_.bookmarks.end())
            s_.bookmarks.erase(found);
        else if (!s_.cursor.step.empty())
            s_.bookmarks.push_back(s_.cursor.step);
    }
    void operator()(const action::GoToBookmark& a) {
        if (s_.bookmarks.empty()) return;
        const auto here = std::find(s_.bookmarks.begin(), s_.bookmarks.end(), s_.cursor.step);
        const auto count = static_cast<int>(s_.bookmarks.size());
        const int at =
            here == s_.bookmarks.end() ? (a.direction > 0 ? -1 : 0) : static_cast<int>(here - s_.bookmarks.begin());
        (*this)(action::StepTo{s_.bookmarks[static_cast<std::size_t>((at + a.direction + count) % count)]});
    }

    void operator()(const action::MoveVertex& a) {
        const auto [polygon, vertex, texture] = a.handle;
        const std::vector<Vertex>* ring = ring_of(polygon);
        if (ring == nullptr || vertex < 0 || vertex >= static_cast<int>(ring->size())) return;
        if (!std::isfinite(a.to.x) || !std::isfinite(a.to.y)) return;
        const std::vector<Vertex>& vertices = *ring;
        Vertex value = vertices[static_cast<std::size_t>(vertex)];
        const float x = std::clamp(a.to.x, -kFarthest, kFarthest), y = std::clamp(a.to.y, -kFarthest, kFarthest);
        if (texture)
            value.u = x, value.v = y;
        else
            value.x = x, value.y = y;
        if (!texture && bends_inwards(vertices, static_cast<std::size_t>(vertex), value)) {
            s_.message = {std::string(kConvex)};
            return;
        }
        put({polygon, vertex, value});
        s_.handle = a.handle;
        settle();
    }
    void operator()(const action::MoveShape& a) {
        const auto& polygons = derived_.scene().polygons;
        if (a.polygon < 0 || a.polygon >= static_cast<int>(polygons.size())) return;
        std::vector<Vertex> vertices = polygons[static_cast<std::size_t>(a.polygon)].vertices;
        if (vertices.size() != a.to.size()) return;
        for (std::size_t n = 0; n < vertices.size(); ++n) {
            if (!std::isfinite(a.to[n].x) || !std::isfinite(a.to[n].y)) return;
            vertices[n].x = std::clamp(a.to[n].x, -kFarthest, kFarthest);
            vertices[n].y = std::clamp(a.to[n].y, -kFarthest, kFarthest);
        }
        for (std::size_t n = 0; n < vertices.size(); ++n) put({a.polygon, static_cast<int>(n), vertices[n]});
        settle();
    }
    void operator()(const action::SetDepth& a) {
        const auto [polygon, vertex, texture] = a.handle;
        const std::vector<Vertex>* ring = ring_of(polygon);
        if (ring == nullptr || vertex < 0 || vertex >= static_cast<int>(ring->size()) || !std::isfinite(a.w)) return;
        Vertex value = (*ring)[static_cast<std::size_t>(vertex)];
        value.w = std::clamp(a.w, kLeastDepth, kMostDepth);
        put({polygon, vertex, value});
        s_.handle = a.handle;
        settle();
    }
    void operator()(const action::TurnRing& a) {
        const std::vector<Vertex>* ring = ring_of(a.polygon);
        if (ring == nullptr) return;
        std::vector<Vertex> turned = *ring;
        std::rotate(turned.begin(), turned.begin() + 1, turned.end());
        const auto count = static_cast<int>(turned.size());
        for (int n = 0; n < count; ++n) put({a.polygon, n, turned[static_cast<std::size_t>(n)]});
        if (s_.handle.polygon == a.polygon) s_.handle.vertex = (s_.handle.vertex + count - 1) % count;
        settle();
    }
    void operator()(const action::ChooseHandle& a) { s_.handle = a.handle; }
    void operator()(const action::Turn& a) {
        MeshEdit* edit = edit_of(a.what.mesh);
        if (edit == nullptr || a.axis < 0 || a.axis > 2 || !std::isfinite(a.degrees)) return;
        glm::vec3& angles = a.what.small ? edit->rotate2 : edit->rotate;
        angles = turned_angles(angles, a.axis, std::clamp(a.degrees, -kMostDegrees, kMostDegrees));
        s_.turning = a.what;
        settle_faces();
    }
    void operator()(const action::ChooseTurning& a) { s_.turning = a.what; }
    void operator()(const action::SetRatio& a) {
        MeshEdit* edit = edit_of(a.mesh);
        if (edit == nullptr || !std::isfinite(a.ratio)) return;
        edit->ratio = std::clamp(a.ratio, kLeastRatio, kMostRatio);
        settle_faces();
    }
    void operator()(const action::SetSizeTwice& a) {
        if (a.on == derived_.scene().size_twice) return;
        s_.work.size_twice = a.on;
        settle_faces();
    }
    void operator()(const action::SetFocal& a) {
        if (!std::isfinite(a.focal)) return;
        s_.work.focal = std::clamp(a.focal, kLeastFocal, kMostFocal);
        settle_faces();
    }
    void operator()(const action::SetFrame& a) {
        std::int64_t period = 1;
        for (const Animation& animation : derived_.scene().animations)
            period = std::min<std::int64_t>(kLongestPeriod,
                                            std::lcm(period, std::max<std::int64_t>(1, std::ssize(animation.frames))));
        s_.work.frame = static_cast<int>(euclidean_modulo(a.frame, period));
        settle();
    }
    void operator()(const action::SetRandom& a) {
        if (!derived_.scene().random) {
            s_.message = {std::string(kNoRandom)};
            return;
        }
        if (!std::isfinite(a.to.size)) return;
        const auto& polygons = derived_.scene().polygons;
        auto& edits = s_.work.edits;  // the triangles whose corners were moved are gone
        edits.erase(std::remove_if(edits.begin(), edits.end(),
                                   [&](const VertexEdit& e) {
                                       const auto n = static_cast<std::size_t>(e.polygon);
                                       return n >= polygons.size() || polygons[n].random;
                                   }),
                    edits.end());
        RandomTriangles& random = s_.work.random.emplace(a.to);
        random.count = std::clamp(random.count, 1, kMostTriangles);
        random.size = std::clamp(random.size, kLeastTriangleSide, kMostTriangleSide);
        random.distance = std::clamp(random.distance, 0, kMaxDistance);
        random.waste = std::clamp(random.waste, 0, kMaxWaste);
        settle(false);
    }
    void operator()(const action::StartRace& a) {
        s_.race.running = a.on && derived_.drawing().shape_count() > 0 && s_.work.format != NumberFormat::exact;
        if (a.on && s_.work.format == NumberFormat::exact) s_.message = {std::string(kExactRace)};
        if (s_.race.running) s_.race.laps.clear(), s_.measure.running = s_.measure.live = false;  // one at a time
    }
    void operator()(const action::FinishLap& a) {
        if (!s_.race.running) return;
        s_.race.laps.push_back(a.lap);
        s_.race.running = !a.last;
    }
    void operator()(const action::StartMeasure& a) {
        Measure& m = s_.measure;
        if (a.what != m.what) m = {.what = a.what};
        m.running = m.live = a.on && derived_.drawing().shape_count() > 0;
        m.share = 0, m.doing.clear();
        if (m.running) s_.race.running = false;  // they would take each other's time
    }
    void operator()(const action::MeasureOn& a) {
        if (s_.measure.running && s_.measure.what == a.found.what) s_.measure = a.found;
    }
    void operator()(const action::PlayFrames& a) { s_.moving = a.on && derived_.frames().count > 1; }
    void operator()(const action::FrameRate& a) {
        s_.look.frame_rate = std::clamp(s_.look.frame_rate * a.factor, 1.0F, 64.0F);
    }
    void operator()(const action::SetFormat& a) { s_.work.format = a.format, settle(); }
    void operator()(const action::SetMode& a) { s_.work.mode = a.mode, settle(); }
    void operator()(const action::SetVariant& a) {
        const Method& method = derived_.method();
        if (find_variant(method, a.id) == nullptr) return;
        QuirkSet forms = 0;
        for (std::size_t n = 0; n < method.quirks.size(); ++n)
            forms |= method.quirks[n].kind == QuirkKind::form ? QuirkSet{1} << n : 0;
        s_.work.variant = a.id;
        s_.work.quirks = quirks_of(method, a.id) | (s_.work.quirks & forms);
        settle();
    }
    void operator()(const action::SetQuirk& a) {
        if (a.index < 0 || a.index >= static_cast<int>(derived_.method().quirks.size())) return;
        const QuirkSet bit = QuirkSet{1} << a.index;
        s_.work.quirks = a.on ? s_.work.quirks | bit : s_.work.quirks & ~bit;
        settle();
    }
    void operator()(const action::SetQuirks& a) {
        const std::size_t count = derived_.method().quirks.size();
        s_.work.quirks = a.quirks & ((QuirkSet{1} << count) - 1);
        settle();
    }
    void operator()(const action::SetMethod& a) {
        const Method* method = find_method(a.id);
        if (method == nullptr || a.id == s_.work.method) return;
        s_.work.method = a.id;
        s_.work.variant = method->variants.back().id;
        s_.work.quirks = method->variants.back().quirks;
        s_.cursor.step = {};
        settle(false);
    }
    void operator()(const action::SetTexture& a) {
        s_.work.texture_file = a.file, s_.work.texture = a.texture, settle();
    }

    void operator()(const action::Choose& a) {
        const Prediction* asked = prediction_of(s_);
        if (asked == nullptr || a.option < 0 || a.option >= static_cast<int>(asked->options.size())) return;
        Answer& answer = reopened();
        const auto found = std::find(answer.chosen.begin(), answer.chosen.end(), a.option);
        if (asked->kind != Prediction::Kind::many)
            answer.chosen = {a.option};
        else if (found != answer.chosen.end())
            answer.chosen.erase(found);
        else
            answer.chosen.insert(std::upper_bound(answer.chosen.begin(), answer.chosen.end(), a.option), a.option);
    }
    void operator()(const action::Type& a) {
        if (prediction_of(s_) != nullptr) reopened().typed = a.text.substr(0, 32);
    }
    void operator()(const action::Point& a) {
        if (prediction_of(s_) == nullptr) return;
        Answer& answer = reopened();
        const auto found = std::find(answer.places.begin(), answer.places.end(), a.place);
        if (found != answer.places.end())
            answer.places.erase(found);
        else
            answer.places.push_back(a.place);
        constexpr std::size_t kMostPlaces = 64;
        if (answer.places.size() > kMostPlaces) answer.places.erase(answer.places.begin());
    }
    void operator()(const action::Check&) {
        const Prediction* asked = prediction_of(s_);
        if (asked == nullptr) return;
        Answer& answer = answer_here(s_);
        const Grade grade = texelscope::grade(*asked, answer, derived_, s_);
        answer.verdict = grade.verdict, answer.sentence = grade.sentence, answer.explain = grade.explain;
    }
    void operator()(const action::Skip&) {
        if (prediction_of(s_) != nullptr) answer_here(s_).verdict = Answer::Verdict::skipped;
    }

    void operator()(const action::Hover& a) { s_.hover = a.what; }
    void operator()(const action::Pin& a) { s_.pinned = s_.pinned == a.what ? Selection{} : a.what; }
    void operator()(const action::SetLook& a) {
        s_.look = a.look;
        s_.look.scale = std::clamp(s_.look.scale, 1.0F, 2.5F);
    }
    void operator()(const action::Show& a) {
        s_.overlay = s_.overlay == a.overlay ? Overlay::none : a.overlay;
        const Lesson* open = s_.document && s_.document->lesson ? &*s_.document->lesson : nullptr;
        if (s_.overlay == Overlay::lessons && open != nullptr && open->number > 0) s_.chosen_lesson = open->number - 1;
    }
    void operator()(const action::ChooseLesson& a) { s_.chosen_lesson = std::max(0, a.index); }
    void operator()(const action::Escape&) {
        if (s_.look.blank)
            s_.look.blank = false;
        else if (s_.overlay != Overlay::none)
            s_.overlay = Overlay::none;
        else if (s_.playing || s_.moving || s_.race.running || s_.measure.live)
            s_.playing = s_.moving = s_.race.running = s_.measure.running = s_.measure.live = false;
        else
            s_.pinned = {}, s_.handle = {}, s_.turning = {};
    }

    void operator()(const action::Undo&) {}
    void operator()(const action::Redo&) {}
    void operator()(const action::Reset&) {
        const State fresh = opened(s_.document, s_);
        s_.work = fresh.work, s_.cursor = fresh.cursor, s_.pinned = fresh.pinned, s_.handle = {};
        s_.turning = {}, s_.moving = false;
    }
    void operator()(const action::Restore& a) {
        s_.work = a.work, s_.cursor = a.cursor;
        s_.look.other = a.other, s_.look.difference = a.difference;
        s_.look.rung = a.rung, s_.look.skips = a.skips;
        s_.cursor.beat = std::clamp(s_.cursor.beat, 0, std::max(0, beat_count(s_) - 1));
        settle();
    }

private:
    /// The corners of a polygon that may be changed one by one; null where there is none, which is said of a solid's.
    [[nodiscard]] const std::vector<Vertex>* ring_of(int polygon) {
        const auto& polygons = derived_.scene().polygons;
        if (polygon < 0 || polygon >= static_cast<int>(polygons.size())) return nullptr;
        const Polygon& found = polygons[static_cast<std::size_t>(polygon)];
        if (found.mesh < 0) return &found.vertices;
        s_.message = {std::string(kSolid)};
        return nullptr;
    }
    /// The corner stands there from now on.
    void put(const VertexEdit& edit) {
        auto& edits = s_.work.edits;
        const auto place =
            std::lower_bound(edits.begin(), edits.end(), std::pair(edit.polygon, edit.vertex),
                             [](const VertexEdit& e, const auto& key) { return std::pair(e.polygon, e.vertex) < key; });
        if (place != edits.end() && place->polygon == edit.polygon && place->vertex == edit.vertex)
            place->value = edit.value;
        else
            edits.insert(place, edit);
    }
    /// Whether a method that takes convex polygons would no longer be given one.
    [[nodiscard]] bool bends_inwards(std::vector<Vertex> corners, std::size_t moved, const Vertex& to) const {
        if (derived_.method().triangles || !std::all_of(corners.begin(), corners.end(), is_finite)) return false;
        const bool was_convex = is_convex(corners);
        corners[moved] = to;
        return was_convex && !is_convex(corners);
    }
    void end_reached(bool forward) {
        s_.playing = false;
        s_.message = {std::string(s_.cursor.step.empty() ? kNothing : forward ? kAtEnd : kAtStart)};
    }
    /// After an edit: the same triangle, row and pixel where they still exist, else the nearest step before.
    void settle(bool tell = true) {
        derived_.update(s_);
        const Path before = s_.cursor.step;
        s_.cursor.step = derived_.steps().nearest(before, s_.cursor.level).value_or(Path{});
        if (tell && s_.cursor.step != before && !before.empty()) s_.message = {std::string(kMoved)};
    }
    /// The edit of a mesh, made where there is none yet; null where there is no such mesh, or one with numbers that
    /// cannot be turned.
    [[nodiscard]] MeshEdit* edit_of(int mesh) {
        const auto& meshes = derived_.scene().meshes;
        if (mesh < 0 || mesh >= static_cast<int>(meshes.size())) return nullptr;
        const MeshPlacement& placed = meshes[static_cast<std::size_t>(mesh)];
        for (const glm::vec3& angles : {placed.rotate, placed.rotate2})
            for (int axis = 0; axis < 3; ++axis)
                if (!std::isfinite(angles[axis])) return nullptr;
        auto& edits = s_.work.meshes;
        const auto place = std::lower_bound(edits.begin(), edits.end(), mesh,
                                            [](const MeshEdit& e, int wanted) { return e.mesh < wanted; });
        if (place != edits.end() && place->mesh == mesh) return &*place;
        return &*edits.insert(place, {mesh, placed.rotate, placed.rotate2, placed.ratio});
    }
    /// After polygons of meshes were made anew: the same face, row and pixel where they still exist. Where the face is
    /// no longer drawn the nearest one of its mesh in drawing order.
    void settle_faces() {
        const Path before = s_.cursor.step;
        const int shape = derived_.shape();
        if (before.empty() || shape < 0) return settle();
        const int polygon = derived_.drawing().polygon_of(shape);
        const Polygon old = derived_.scene().polygons[static_cast<std::size_t>(polygon)];
        const int part = shape - derived_.drawing().first_shape_of(polygon);
        derived_.update(s_);
        const auto& now = derived_.scene().polygons;
        int found = -1;
        bool same = old.mesh < 0;
        for (int n = 0; n < static_cast<int>(now.size()) && !same; ++n) {
            const Polygon& p = now[static_cast<std::size_t>(n)];
            if (p.mesh != old.mesh) continue;
            same = p.face == old.face;
            if (same || found < 0 || std::abs(n - polygon) < std::abs(found - polygon)) found = n;
        }
        if (found >= 0) {
            const int first = derived_.drawing().first_shape_of(found);
            const int shapes = derived_.drawing().first_shape_of(found + 1) - first;
            s_.cursor.step.parts[0].index = first + std::clamp(part, 0, std::max(0, shapes - 1));
        }
        const Path there = s_.cursor.step;
        settle(false);
        if (!same)
            s_.message = {std::string(found >= 0 ? kTurnedAway : kMoved)};
        else if (s_.cursor.step != there)
            s_.message = {std::string(kMoved)};
    }
    [[nodiscard]] Answer& reopened() {
        Answer& answer = answer_here(s_);
        answer.verdict = Answer::Verdict::open, answer.sentence.clear(), answer.explain = {};
        return answer;
    }

    State& s_;
    Derived& derived_;
};

}  // namespace

void measure_again(State& state, const Work& before) {
    if (same_scene(before, state.work)) return;
    const Measure old = std::move(state.measure);
    state.measure = {.what = old.what, .running = old.live, .live = old.live};
}

State reduce(const State& state, const Action& action, Derived& derived) {
    State next = state;
    // What the user did not do takes no message away.
    if (!std::holds_alternative<action::Hover>(action) && !std::holds_alternative<action::MeasureOn>(action) &&
        !std::holds_alternative<action::FinishLap>(action))
        next.message = {};
    if (!next.document && !std::holds_alternative<action::Open>(action)) return next;
    std::visit(Reducer(next, derived), action);
    if (next.document != state.document || !same_race(state.work, next.work)) next.race = {};
    if (next.document != state.document)
        next.measure = {};
    else
        measure_again(next, state.work);
    if (next.measure.live && next.measure.what == Measure::What::skips && next.look.skips != state.look.skips)
        next.measure.running = true, next.measure.share = 0;
    derived.update(next);
    return next;
}

}  // namespace texelscope
