#include "app/state/derived.h"

#include <algorithm>
#include <cstdlib>
#include <set>
#include <utility>

#include "app/state/derived_cache.h"

namespace texelscope {
namespace {

[[nodiscard]] DrawSettings settings_of(const Work& work) {
    const Method* method = find_method(work.method);
    return {method != nullptr ? method : &default_method(), work.format, work.quirks, work.mode};
}

[[nodiscard]] bool trivial(Op op) { return op == Op::input || op == Op::constant || op == Op::same; }

/// The expression that tells most of a unit: the last one that computes a number with a fraction, else anything.
[[nodiscard]] const Named* telling(const Visit& visit) {
    const Named *best = nullptr, *fallback = nullptr;
    for (const std::int32_t n : visit.unit().expressions) {
        const Named& named = visit.tape.names[static_cast<std::size_t>(n)];
        const Operation& operation = visit.tape.operations[static_cast<std::size_t>(named.operation)];
        fallback = &named;
        const bool whole =
            std::holds_alternative<bool>(operation.value) || std::holds_alternative<Integer>(operation.value);
        if (!trivial(operation.op) && !whole) best = &named;
    }
    return best != nullptr ? best : fallback;
}

/// What is computed nearest to a line of the listing, the last time that it runs.
[[nodiscard]] const Named* nearest(const Visit& visit, int line) {
    const Named* best = nullptr;
    const auto distance = [&](const Named& n) { return std::abs(n.line - line); };
    for (const Named& named : visit.tape.names) {
        if (best == nullptr || distance(named) <= distance(*best)) best = &named;
    }
    return best;
}

/// A whole number that the step's unit has computed by now, or else the round of its loop that is called so.
[[nodiscard]] std::optional<Integer> whole_number(const Visit& v, const Path& step, std::string_view name) {
    std::optional<Integer> found = name.size() == 1 ? step.index_of(name[0]) : std::nullopt;
    const auto& own = v.unit().expressions;
    const std::size_t end =
        step.at_expression() ? std::min(own.size(), static_cast<std::size_t>(step.parts.back().index) + 1) : own.size();
    for (std::size_t k = 0; k < end; ++k) {
        const Named& named = v.tape.names[static_cast<std::size_t>(own[k])];
        const Value& value = v.tape.operations[static_cast<std::size_t>(named.operation)].value;
        if (named.name.text() == name && std::holds_alternative<Integer>(value)) found = std::get<Integer>(value);
    }
    return found;
}

}  // namespace

bool same_scene(const Work& a, const Work& b) {
    return a.edits == b.edits && a.meshes == b.meshes && a.focal == b.focal && a.frame == b.frame &&
           a.random == b.random && a.size_twice == b.size_twice && a.texture == b.texture;
}

bool same_race(const Work& a, const Work& b) { return a.format == b.format && a.mode == b.mode && same_scene(a, b); }

Derived::Derived() : cache_(std::make_unique<Cache>()) {}
Derived::~Derived() = default;

void Derived::update(const State& state) {
    Cache& c = *cache_;
    const bool scene_same = c.scene && c.state.document == state.document && same_scene(c.state.work, state.work);
    const bool drawing_same = scene_same && c.drawing && c.drawing->settings() == settings_of(state.work);
    const bool step_same = drawing_same && c.state.cursor == state.cursor && c.state.pinned == state.pinned;
    c.state = state;
    const std::unique_ptr<Scene> last_scene = scene_same ? nullptr : std::move(c.scene);
    if (!scene_same) {
        c.faces.clear(), c.jelly.reset(), c.bills.reset(), c.rung.reset(), c.skips.reset();
        c.scene =
            std::make_unique<Scene>(state.document ? edited_scene(*state.document, state.work, &c.faces) : Scene{});
    }
    if (!drawing_same) {
        const DrawSettings settings = settings_of(state.work);
        if (!c.drawing || c.drawing->settings().method != settings.method)
            c.listing = load_listing(settings.method->listing);
        const std::unique_ptr<Drawing> last = std::exchange(c.drawing, std::make_unique<Drawing>(*c.scene, settings));
        last ? c.canvas.change(*last, *c.drawing) : c.canvas.forget();
        c.steps = std::make_unique<Steps>(*c.drawing);
        c.of_drawing = {};
    }
    if (!step_same) c.of_step = {};
}

const Scene& Derived::scene() const { return *cache_->scene; }
const Drawing& Derived::drawing() const { return *cache_->drawing; }
Steps& Derived::steps() const { return *cache_->steps; }
const Method& Derived::method() const { return *drawing().settings().method; }
const Listing& Derived::listing() const { return cache_->listing; }

int Derived::shape() const {
    const Path& step = cache_->state.cursor.step;
    if (step.empty() || drawing().shape_count() == 0) return -1;
    return static_cast<int>(std::clamp<Integer>(step.parts[0].index, 0, drawing().shape_count() - 1));
}

const Visit& Derived::visit() const {
    auto& visit = cache_->of_step.visit;
    if (!visit) visit = std::make_shared<Visit>(steps().at(cache_->state.cursor.step));
    return *visit;
}

const Named* Derived::named() const {
    const Visit& v = visit();
    const Path& step = cache_->state.cursor.step;
    if (step.at_expression()) {
        const auto e = static_cast<std::size_t>(step.parts.back().index);
        return e < v.unit().expressions.size() ? &v.tape.names[static_cast<std::size_t>(v.unit().expressions[e])]
                                               : nullptr;
    }
    const Selection& pinned = cache_->state.pinned;
    const Named* best = telling(v);
    const auto last_that = [&](auto is) -> const Named* {
        for (std::int32_t n = last_known(v, step); n >= 0; --n) {
            if (const Named& named = v.tape.names[static_cast<std::size_t>(n)]; is(named)) return &named;
        }
        return nullptr;
    };
    if (pinned.kind == Selection::Kind::name) {
        const Named* found = last_that([&](const Named& n) { return n.name.text() == pinned.name; });
        if (found != nullptr) return found;
    }
    if (pinned.kind == Selection::Kind::line && best == nullptr) {  // a whole shape has no expression of its own
        if (const Named* found = nearest(v, pinned.line)) return found;
    }
    return best != nullptr ? best : last_that([](const Named&) { return true; });
}

int Derived::line() const {
    const Named* now = named();
    return now != nullptr ? now->line : 0;
}

const Texture& Derived::texture() const {
    static const Texture kNone{.name = "none", .texels = Image(1, 1, {128, 128, 128})};
    const int n = shape();
    if (n < 0) return scene().textures.empty() ? kNone : *scene().textures.front();
    return *drawing().job(n).texture;
}

std::optional<glm::ivec2> Derived::pixel() const {
    const Path& step = cache_->state.cursor.step;
    const auto x = step.index_of('x'), y = step.index_of('y');
    if (x && y) return glm::ivec2(*x, *y);
    if (step.unit().depth() < 4) return std::nullopt;
    return whole_pair("x", "y");  // driven by what it reads: known once it is computed
}

std::optional<glm::ivec2> Derived::whole_pair(std::string_view first, std::string_view second) const {
    const Path& step = cache_->state.cursor.step;
    const auto a = whole_number(visit(), step, first), b = whole_number(visit(), step, second);
    constexpr Integer kFarthest = 1 << 30;
    if (!a || !b || std::abs(*a) > kFarthest || std::abs(*b) > kFarthest) return std::nullopt;
    return glm::ivec2(*a, *b);
}

std::optional<Integer> Derived::row() const { return cache_->state.cursor.step.index_of('y'); }

std::optional<glm::ivec2> Derived::texel() const { return whole_pair("column", "row"); }

const std::vector<Variable>& Derived::variables() const {
    auto& found = cache_->of_step.variables;
    if (!found) found = make_variables(visit(), named(), cache_->state.cursor, steps());
    return *found;
}

const std::vector<Notice>& Derived::notices() const {
    auto& found = cache_->of_drawing.notices;
    if (found) return *found;
    found.emplace();
    constexpr int kLookedAt = 64;
    for (int n = 0; n < std::min(kLookedAt, drawing().shape_count()); ++n) {
        const Visit v = texelscope::visit(drawing(), Path{{{'t', n}}});
        if (v.shape_fate != Fate::written) found->push_back({n, std::string(text_of(v.shape_fate))});
    }
    return *found;
}

}  // namespace texelscope
