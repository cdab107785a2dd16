// Who drew a pixel: every shape that came to it, what its sides said of a sample exactly on them, and how many pixels
// were drawn more than once.
#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "app/ui/text.h"
#include "app/ui/widgets.h"
#include "app/views/terms.h"

namespace texelscope::owners_view {
namespace {

constexpr std::string_view kTitle = "Owners";
constexpr std::string_view kNoPixel = "Click a pixel on the canvas, or step into one, to see which shapes drew it.";
constexpr std::string_view kNobody = "No shape comes to this pixel.";
constexpr std::string_view kPixel = "pixel {}, {}";
constexpr std::string_view kWritten = "written {} times", kOnce = "written once", kNever = "not written";
constexpr std::string_view kSoFar = "{} so far", kNotYet = "not written yet";
constexpr std::string_view kUndecided = "undecided", kLater = "comes later";
constexpr std::string_view kDoubles = "{} pixels drawn twice{}", kOneDouble = "1 pixel drawn twice{}",
                           kOrMore = " or more";
constexpr std::string_view kNoDoubles = "no pixel drawn twice";
constexpr std::string_view kOnSide = "on side {}", kOnSideOwned = "on side {}, its own",
                           kOnSideOther = "on side {}, not its own";
constexpr std::string_view kGoTip = "Click to go to the step in which shape {} comes to this pixel.";
constexpr std::size_t kMostShapes = 8;
constexpr int kMostCounted = 1 << 18;  ///< samples of the framebuffer, times shapes, up to which doubles are counted

struct OnSide {
    int side = 0;
    std::optional<bool> owned;  ///< nothing where that is not decided yet
};
struct Claim {
    int shape = 0;
    Sample sample;
    enum class Stage : std::uint8_t { later, at_work, decided } stage = Stage::later;  ///< at the cursor's step
    std::vector<OnSide> on_sides;  ///< sides the sample lies exactly on, as far as the step knows

    [[nodiscard]] bool written() const { return stage == Stage::decided && sample.fate == Fate::written; }
};

[[nodiscard]] std::optional<glm::ivec2> pixel_of(const ViewContext& context) {
    for (const Selection* s : {&context.state.pinned, &context.state.hover}) {
        if (s->kind == Selection::Kind::pixel) return s->at;
    }
    return context.derived.pixel();
}

[[nodiscard]] const Value* value_of(const Tape& tape, const std::string& name) {
    const std::int32_t n = find_name(tape, name, static_cast<std::int32_t>(tape.names.size()) - 1);
    if (n < 0) return nullptr;
    return &tape.operations[static_cast<std::size_t>(tape.names[static_cast<std::size_t>(n)].operation)].value;
}

/// The sides on which the sample lies exactly, as the shape's own run has it.
[[nodiscard]] std::vector<OnSide> sides_of(const Derived& derived, int shape, glm::ivec2 pixel) {
    std::vector<OnSide> sides;
    const auto path = derived.steps().at_pixel(shape, pixel.x, pixel.y);
    if (!path) return sides;
    const Tape& tape = derived.steps().at(*path).tape;
    for (int side = 0; side < 3; ++side) {
        const std::string letter(1, static_cast<char>('A' + side));
        const Value *e = value_of(tape, "E_" + letter), *owns = value_of(tape, "owns_" + letter);
        if (e != nullptr && owns != nullptr && approximate(*e) == 0) sides.push_back({side, approximate(*owns) != 0});
    }
    return sides;
}

/// Those that the cursor's own pixel has found so far.
[[nodiscard]] std::vector<OnSide> sides_so_far(const Derived& derived) {
    std::vector<OnSide> sides;
    for (const Variable& v : derived.variables()) {
        if (v.own && v.name.substr(0, 2) == "E_" && approximate(v.value) == 0)
            sides.push_back({edge_of_name(v.name), std::nullopt});
    }
    return sides;
}

/// Every shape that comes to the pixel, before the step or after it: what lies ahead is not told.
[[nodiscard]] std::vector<Claim> claims_of(const Derived& derived, const Path& step, glm::ivec2 pixel) {
    std::vector<Claim> claims;
    const Drawing& drawing = derived.drawing();
    const Window window{{pixel.x, pixel.y, pixel.x + 1, pixel.y + 1}, 1};
    each_sample(drawing, 0, drawing.shape_count(), window, [&](int shape, const Sample& s) {
        if (claims.size() < kMostShapes) claims.push_back({shape, s, Claim::Stage::later, {}});
    });
    std::size_t come = 0;  // samples come in the same order
    each_sample_until(drawing, 0, step, window, [&](int, const Sample&) { ++come; });
    const auto own = static_cast<Integer>(derived.visit().unit().expressions.size());
    const bool at_work = derived.pixel() == pixel && step.at_expression() && step.parts.back().index + 1 < own;
    for (std::size_t n = 0; n < std::min(come, claims.size()); ++n) {
        claims[n].stage = at_work && n + 1 == come ? Claim::Stage::at_work : Claim::Stage::decided;
        const bool decided = claims[n].stage == Claim::Stage::decided;
        claims[n].on_sides = decided ? sides_of(derived, claims[n].shape, pixel) : sides_so_far(derived);
    }
    return claims;
}

struct Doubles {
    int pixels = 0;
    bool more = false;  ///< some are written more often than twice
};
/// Pixels that are written more than once in the finished picture; nothing where counting would cost too much.
[[nodiscard]] std::optional<Doubles> doubles_of(const Derived& derived) {
    const Rect frame = derived.scene().framebuffer.rect();
    const Drawing& drawing = derived.drawing();
    if (static_cast<Integer>(frame.width()) * frame.height() * std::max(1, drawing.shape_count()) > kMostCounted)
        return std::nullopt;
    Grid<std::uint8_t> writes(std::max(1, frame.width()), std::max(1, frame.height()));
    Doubles doubles;
    each_sample(drawing, 0, drawing.shape_count(), {frame, 1}, [&](int, const Sample& s) {
        if (s.fate != Fate::written || !frame.contains(s.x, s.y)) return;
        std::uint8_t& count = writes.at(static_cast<int>(s.x) - frame.x0, static_cast<int>(s.y) - frame.y0);
        count = std::min<std::uint8_t>(3, static_cast<std::uint8_t>(count + 1));
        doubles.pixels += count == 2;
        doubles.more |= count > 2;
    });
    return doubles;
}

void draw_doubles(const ViewContext& context, glm::vec2 pen, float width) {
    const auto doubles = doubles_of(context.derived);
    if (!doubles) return;
    const std::string_view more = doubles->more ? kOrMore : std::string_view();
    const std::string many =
        doubles->pixels == 1 ? fmt::format(kOneDouble, more) : fmt::format(kDoubles, doubles->pixels, more);
    const bool none = doubles->pixels == 0;
    context.ui.text_within(ui::Face::lead, pen, width, none ? ui::Role::muted : ui::Role::text,
                           none ? std::string(kNoDoubles) : many);
}

/// At a step outside of all pixels: what is true of all of them.
void draw_without_pixel(const ViewContext& context, const ui::Area& area) {
    ui::Ui& ui = context.ui;
    const float line = pitch(ui, 20, ui::Face::prose), top = ui.px(8);
    const ui::Area inner = ui.begin_scroll("owners/scroll", area);
    float y = inner.y + line - ui.px(4);
    draw_doubles(context, {inner.x, y}, inner.w);
    ui::hairline(ui, {inner.x, std::round(y + line * .6F)}, inner.w);
    y += line * .6F + top;
    y += ui.prose("owners/hint", {inner.x, y, inner.w, inner.h}, ui::spans_of(kNoPixel, ui::Role::muted));
    ui.end_scroll(y - inner.y);
}

class OwnersView {
public:
    OwnersView(const ViewContext& context, const ui::Area& area, glm::ivec2 pixel)
        : context_(context),
          ui_(context.ui),
          area_(area),
          pixel_(pixel),
          claims_(claims_of(context.derived, context.state.cursor.step, pixel)) {}

    void draw() {
        const float line = pitch(ui_, 20, ui::Face::prose);
        std::size_t lines = 4 + claims_.size();
        for (const Claim& claim : claims_) lines += claim.on_sides.size();
        foresee(ui_, "owners/scroll", static_cast<float>(lines) * line + ui_.px(20));
        const ui::Area inner = ui_.begin_scroll("owners/scroll", area_);
        glm::vec2 pen{inner.x, inner.y + line - ui_.px(4)};
        pen.y = draw_head(pen, inner.w, line) + line * 1.25F;
        if (claims_.empty()) ui_.text_within(ui::Face::prose, pen, inner.w, ui::Role::muted, kNobody), pen.y += line;
        for (const Claim& claim : claims_) pen.y = draw_claim(claim, pen, inner.w, line);
        pen.y += ui_.px(4);
        ui::hairline(ui_, {inner.x, std::round(pen.y - line * .7F)}, inner.w);
        draw_doubles(context_, {pen.x, pen.y + ui_.px(6)}, inner.w);
        ui_.end_scroll(static_cast<float>(lines) * line + ui_.px(20));
    }

private:
    /// @return the baseline of its last line.
    float draw_head(glm::vec2 pen, float width, float line) {
        const auto count = std::count_if(claims_.begin(), claims_.end(), [](const Claim& c) { return c.written(); });
        const bool open = std::any_of(claims_.begin(), claims_.end(),
                                      [](const Claim& c) { return c.stage != Claim::Stage::decided; });
        std::string text = count == 0   ? std::string(open ? kNotYet : kNever)
                           : count == 1 ? std::string(kOnce)
                                        : fmt::format(kWritten, count);
        if (open && count > 0) text = fmt::format(kSoFar, text);
        const std::string where = fmt::format(kPixel, pixel_.x, pixel_.y);
        const float used = ui_.text_within(ui::Face::code, pen, width, ui::Role::text, where) + ui_.px(14);
        const bool beside = used + ui::text_width(ui_.font(ui::Face::prose), text) <= width;
        const glm::vec2 at = beside ? glm::vec2(pen.x + used, pen.y) : glm::vec2(pen.x, pen.y + line);
        ui_.text_within(ui::Face::prose, at, pen.x + width - at.x, count > 1 ? ui::Role::error : ui::Role::muted, text);
        return at.y;
    }

    /// Swatch, shape and fate; below them the sides that the sample lies on. @return the next baseline.
    float draw_claim(const Claim& claim, glm::vec2 pen, float width, float line) {
        const bool written = claim.written(), decided = claim.stage == Claim::Stage::decided;
        const ui::Area row{pen.x - ui_.px(6), std::round(pen.y - line * .72F), width + ui_.px(12), line};
        const std::string title =
            fmt::format("{} {}", context_.derived.method().triangles ? "triangle" : "polygon", claim.shape + 1);
        const ui::Control control = ui_.control(
            {fmt::format("owners/{}", claim.shape), row, ui::Kind::link, title, fmt::format(kGoTip, claim.shape + 1)});
        if (control.hovered) ui::frame(ui_.list(), row, ui_.theme()[ui::Role::now], 1, ui::size::kRadius);
        if (control.clicked) {
            if (const auto path = context_.derived.steps().at_pixel(claim.shape, pixel_.x, pixel_.y))
                context_.act(action::StepTo{*path});
        }
        const float side = ui_.px(12), indent = side + ui_.px(8);
        const ui::Area swatch{pen.x, std::round(row.centre().y - side / 2), side, side};
        const Rgb& c = claim.sample.colour;
        if (written)
            ui::fill(ui_.list(), swatch, ui::hex(static_cast<std::uint32_t>(c.r << 16 | c.g << 8 | c.b)), 2);
        else if (decided)
            ui::cross(ui_.list(), swatch.centre(), side / 3, 1.5F, ui_.theme()[ui::Role::muted]);
        if (written || !decided)
            ui::frame(ui_.list(), swatch, ui_.theme()[written ? ui::Role::text : ui::Role::faint], 1, 2);
        const float used =
            indent + ui_.text_within(ui::Face::lead, {pen.x + indent, pen.y}, width - indent, ui::Role::text, title) +
            ui_.px(10);
        ui_.text_within(ui::Face::prose, {pen.x + used, pen.y}, width - used, ui::Role::muted,
                        decided                                ? text_of(claim.sample.fate)
                        : claim.stage == Claim::Stage::at_work ? kUndecided
                                                               : kLater);
        pen.y += line;
        for (const auto& [edge, owned] : claim.on_sides) {
            const glm::vec2 mark{pen.x + indent + ui_.px(4), pen.y - ui_.font(ui::Face::prose).cap / 2};
            ui::edge_mark(ui_.list(), edge, mark, ui_.px(4), ui_.theme()[ui::edge_role(edge)]);
            const std::string letter(1, static_cast<char>('A' + edge));
            const std::string_view how = !owned ? kOnSide : *owned ? kOnSideOwned : kOnSideOther;
            const std::string text = fmt::format(fmt::runtime(how), letter);
            ui_.text_within(ui::Face::prose, {pen.x + indent + ui_.px(14), pen.y}, width - indent - ui_.px(14),
                            ui::Role::text, text);
            pen.y += line;
        }
        return pen.y;
    }

    const ViewContext& context_;
    ui::Ui& ui_;
    ui::Area area_;
    glm::ivec2 pixel_;
    std::vector<Claim> claims_;
};

void draw(const ViewContext& context, const ui::Area& place) {
    const ui::Area area = begin_view(context, "owners", place, kTitle);
    const auto pixel = pixel_of(context);
    if (context.derived.shape() < 0)
        draw_empty(context, area, kNoPixel);
    else if (!pixel)
        draw_without_pixel(context, area);
    else
        OwnersView(context, area, *pixel).draw();
    context.ui.end_panel();
}

constexpr View kView{"owners", kTitle, draw};
const RegisterView kRegistered(kView);

}  // namespace
}  // namespace texelscope::owners_view
