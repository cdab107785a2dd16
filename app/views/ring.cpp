// The corners of a polygon as a ring written twice, the two pointers that run round it, and the sections they make.
#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "app/ui/text.h"
#include "app/ui/widgets.h"
#include "app/views/formula_blocks.h"
#include "app/views/terms.h"

namespace texelscope::ring_view {
namespace {

constexpr std::string_view kTitle = "Ring, written twice", kTab = "Ring", kNote = "corner / y";
constexpr std::string_view kNoRing =
    "Only methods that run along a polygon's sides have a ring. Choose the method sections.";
constexpr std::string_view kNoSection = "Step into a section to see its two pointers.";
constexpr std::string_view kCornerTip = "Corner {} of the ring, at y = {}";
constexpr std::string_view kSectionTip = "Section {}: rows from y = {} to y = {}. Click to go there.";
constexpr std::string_view kLeft = "left", kRight = "right";

struct RingSection {
    Integer left = 0, right = 0;
    double y_beg = 0, y_end = 0;
    Integer stage = 0;  ///< its index among the shape's stages
};

struct Ring {
    std::vector<std::int32_t> corners;  ///< names of the y of each corner
    std::vector<RingSection> sections;
    int current = -1;  ///< index of the section the step lies in
};

[[nodiscard]] const Value& value_at(const Tape& tape, std::int32_t named) {
    return tape.operations[static_cast<std::size_t>(tape.names[static_cast<std::size_t>(named)].operation)].value;
}

[[nodiscard]] std::string shown(const Tape& tape, std::int32_t named) {
    return shown_number(value_at(tape, named), 2).text;
}

/// Reads the ring off the tape: every section is there, whichever one the step lies in.
[[nodiscard]] Ring ring_of(const Visit& visit) {
    Ring ring;
    const Tape& tape = visit.tape;
    for (int corner = 0;; ++corner) {
        const std::int32_t y =
            find_name(tape, fmt::format("y_{}", corner), static_cast<std::int32_t>(tape.names.size()) - 1);
        if (y < 0) break;
        ring.corners.push_back(y);
    }
    std::vector<Integer> stages;
    for (std::size_t n = 0; n < visit.stages.size(); ++n) {
        if (visit.stages[n].name == "section") stages.push_back(static_cast<Integer>(n));
    }
    RingSection section;
    for (std::size_t n = 0; n < tape.names.size() && ring.sections.size() < stages.size(); ++n) {
        const std::string name = tape.names[n].name.text();
        const Value& value = value_at(tape, static_cast<std::int32_t>(n));
        if (name == "left") section.left = static_cast<Integer>(approximate(value));
        if (name == "right") section.right = static_cast<Integer>(approximate(value));
        if (name == "y_beg") section.y_beg = approximate(value);
        if (name != "y_end") continue;
        section.y_end = approximate(value);
        section.stage = stages[ring.sections.size()];
        ring.sections.push_back(section);
    }
    const auto stage = visit.path.index_of('s');
    for (std::size_t n = 0; n < ring.sections.size(); ++n) {
        if (stage && ring.sections[n].stage == *stage) ring.current = static_cast<int>(n);
    }
    return ring;
}

class RingView {
public:
    RingView(const ViewContext& context, const ui::Area& area)
        : context_(context), ui_(context.ui), visit_(context.derived.visit()), area_(area), ring_(ring_of(visit_)) {}

    [[nodiscard]] bool empty() const { return ring_.corners.empty() || ring_.sections.empty(); }

    void draw() {
        const float label = pitch(ui_, 17, ui::Face::title), box = 2 * pitch(ui_, 16, ui::Face::code) + ui_.px(2);
        const float top = area_.y + label + beside_text(9);
        boxes_ = {area_.x, top, area_.w, box};
        draw_ring();
        const ui::MathBox letter = ui::set_math(ui::symbol("y"), {.fonts = &ui_.fonts(), .size = ui::MathSize::note});
        const float left = std::ceil(letter.width) + beside_text(6);
        const ui::Area bar{area_.x + left, boxes_.bottom() + label + beside_text(11), area_.w - left - ui_.px(6),
                           beside_text(12)};
        ui_.formula(letter, {area_.x, bar.bottom() - beside_text(2)});
        draw_bar(bar);
        const float line = bar.bottom() + pitch(ui_, 15, ui::Face::count) + ui_.px(2);
        ui::hairline(ui_, {area_.x - ui_.px(12), line}, area_.w + ui_.px(24));
        draw_formulas({area_.x, line + 1, area_.w, area_.bottom() - line - 1});
    }

private:
    /// A length that goes with the titles' letters: while presenting they grow more than px() does.
    [[nodiscard]] float beside_text(float at_100) const {
        return std::round(at_100 * ui_.font(ui::Face::title).em / ui::face_px(ui::Face::title, {}));
    }
    [[nodiscard]] int count() const { return static_cast<int>(ring_.corners.size()); }
    [[nodiscard]] ui::Area cell(int place) const {
        const float w = std::floor(boxes_.w / static_cast<float>(2 * count()));
        return {boxes_.x + w * static_cast<float>(place), boxes_.y, w - ui_.px(2), boxes_.h};
    }
    /// Right runs forwards from the top, left backwards from the same corner in the ring's second writing.
    [[nodiscard]] int place_of_right(const RingSection& s) const { return top() + wrap(s.right - top()); }
    [[nodiscard]] int place_of_left(const RingSection& s) const { return top() + count() - wrap(top() - s.left); }
    [[nodiscard]] int top() const { return static_cast<int>(ring_.sections.front().left); }
    [[nodiscard]] int wrap(Integer steps) const { return static_cast<int>(((steps % count()) + count()) % count()); }

    void draw_ring() {
        const bool in_section = ring_.current >= 0;
        const RingSection section =
            in_section ? ring_.sections[static_cast<std::size_t>(ring_.current)] : RingSection{};
        for (int place = 0; place < 2 * count(); ++place) {
            const int corner = place % count();
            const ui::Area area = cell(place);
            const bool chosen = in_section && (place == place_of_left(section) || place == place_of_right(section));
            const std::string number = std::to_string(corner),
                              y = shown(visit_.tape, ring_.corners[static_cast<std::size_t>(corner)]);
            const std::string name = "y_" + number;
            const ui::Control control = ui_.control(
                {fmt::format("ring/{}", place), area, ui::Kind::link, name, fmt::format(kCornerTip, corner, y)});
            act_on_name(context_, control, name);
            ui::fill(ui_.list(), area, ui_.theme().raise, ui::size::kBadgeRadius);
            ui::frame(ui_.list(), area, ui_.theme()[chosen ? ui::Role::now : ui::Role::faint], chosen ? 2.0F : 1.0F,
                      ui::size::kBadgeRadius);
            if (control.hovered || light_of_name(context_, name) != Light::none)
                draw_light(ui_, area.inset(-2, -2), Light::hovered);
            const ui::Color ground = ui_.ground();
            ui_.set_ground(ui_.theme().raise);
            const float half = area.h / 2;
            ui_.text_centred(ui::Face::code_strong, {area.x, area.y + ui_.px(1), area.w, half},
                             place < count() ? ui::Role::text : ui::Role::muted, number);
            ui_.text_centred(ui::Face::count, {area.x, area.y + half - ui_.px(1), area.w, half}, ui::Role::muted, y);
            ui_.set_ground(ground);
        }
        if (!in_section) return;
        draw_pointer(cell(place_of_right(section)), kRight, true);
        draw_pointer(cell(place_of_left(section)), kLeft, false);
    }

    /// A triangle at the box, the pointer's name, and an arrow to where it will go.
    void draw_pointer(const ui::Area& at, std::string_view name, bool above) {
        const ui::Color now = ui_.theme()[ui::Role::now];
        const float x = std::round(at.centre().x), side = beside_text(5), gap = beside_text(4);
        const float y = above ? at.y - gap : at.bottom() + gap, tail = above ? y - side * 1.6F : y + side * 1.6F;
        const glm::vec2 corners[] = {{x - side, tail}, {x + side, tail}, {x, y}};
        ui::fill_convex(ui_.list(), corners, now);
        const float middle = (y + tail) / 2, reach = beside_text(24), from = beside_text(9);
        ui::arrow(ui_.list(), {x + (above ? from : -from), middle},
                  {x + (above ? from + reach : -from - reach), middle}, ui_.px(2), now, beside_text(6));
        const ui::Font& font = ui_.font(ui::Face::title);
        const float width = ui::text_width(font, name),
                    left = std::clamp(x - width / 2, area_.x, area_.right() - width);
        const float baseline = above ? tail - beside_text(4) : tail + beside_text(3) + font.cap;
        ui_.text(ui::Face::title, {left, std::round(baseline)}, ui::Role::now, name);
    }

    void draw_bar(const ui::Area& bar) {
        const double first = ring_.sections.front().y_beg, last = ring_.sections.back().y_end;
        if (!(last > first)) return;
        const auto at = [&](double y) {
            return std::round(bar.x + static_cast<float>((y - first) / (last - first)) * bar.w);
        };
        const ui::Font& font = ui_.font(ui::Face::count);
        float free = area_.x;
        const auto label = [&](double y) {
            const std::string text = shown_number(Value(y), 2).text;
            const float width = ui::text_width(font, text),
                        x = std::clamp(at(y) - width / 2, area_.x, area_.right() - width);
            if (x < free) return;
            ui_.text(ui::Face::count, {x, bar.bottom() + ui_.px(4) + font.cap}, ui::Role::muted, text);
            free = x + width + ui_.px(4);
        };
        for (std::size_t n = 0; n < ring_.sections.size(); ++n) {
            const RingSection& s = ring_.sections[n];
            const ui::Area part{at(s.y_beg), bar.y, std::max(1.0F, at(s.y_end) - at(s.y_beg)), bar.h};
            draw_part(static_cast<int>(n), part);
            label(s.y_beg);
        }
        label(last);
        if (ring_.current < 0) return;
        const RingSection& s = ring_.sections[static_cast<std::size_t>(ring_.current)];
        ui::frame(ui_.list(), {at(s.y_beg) - 1, bar.y - 1, at(s.y_end) - at(s.y_beg) + 2, bar.h + 2},
                  ui_.theme()[ui::Role::now], 2);
    }
    void draw_part(int n, const ui::Area& part) {
        const RingSection& s = ring_.sections[static_cast<std::size_t>(n)];
        const std::string tip =
            fmt::format(kSectionTip, n + 1, shown_number(Value(s.y_beg), 2).text, shown_number(Value(s.y_end), 2).text);
        const ui::Control control = ui_.control(
            {fmt::format("ring/section{}", n), part, ui::Kind::button, fmt::format("section {}", n + 1), tip});
        if (control.clicked) context_.act(action::StepTo{visit_.path.prefix(1).child('s', s.stage)});
        const ui::Color color = ui_.theme()[ui::section_role(n)];
        ui::fill(ui_.list(), part, ui::with_alpha(color, ui::alpha::kSectionFill));
        const glm::vec2 corners[] = {
            {part.x, part.y}, {part.right(), part.y}, {part.right(), part.bottom()}, {part.x, part.bottom()}};
        ui::draw_hatch(ui_.list(), corners, ui::section_degrees(n), ui_.px(6), {area_.x, area_.y}, ui_.px(2), color);
        if (control.hovered) ui::frame(ui_.list(), part, ui_.theme()[ui::Role::now], 1);
    }

    /// m, x and the first pixel for both ends of the row, as the tape has them.
    void draw_formulas(const ui::Area& area) {
        std::vector<ui::MathBox> lines;
        const std::int32_t last = static_cast<std::int32_t>(visit_.tape.names.size()) - 1;
        for (const std::string_view side : {"_l", "_r"}) {
            const std::int32_t m = find_name(visit_.tape, "m" + std::string(side), last),
                               x = find_name(visit_.tape, "x" + std::string(side), last);
            if (m < 0 || x < 0) continue;
            lines.push_back(fitted(m, x, area.w));
        }
        if (lines.empty())
            return draw_empty(context_, area.inset(0, ui_.px(6)), ring_.current < 0 ? kNoSection : kNoRow);
        float used = 0, content = 0;
        for (const ui::MathBox& box : lines) used += box.height();
        const float gap =
            std::max(ui_.px(kLeastGap), std::floor((area.h - used) / static_cast<float>(lines.size() + 1)));
        content = used + gap * static_cast<float>(lines.size() + 1);
        foresee(ui_, "ring/scroll", content);
        const ui::Area inner = ui_.begin_scroll("ring/scroll", area);
        float y = inner.y;
        for (std::size_t n = 0; n < lines.size(); ++n) {
            y = std::round(y + gap);
            draw_terms(context_, fmt::format("ring/formula{}", n), visit_.tape, lines[n],
                       {inner.x + ui_.px(4), y + lines[n].ascent});
            y += lines[n].height();
        }
        ui_.end_scroll(content);
    }

    /// m = numbers ≈ value, x = numbers ≈ value: beside each other, in the largest size that fits, else below each
    /// other.
    [[nodiscard]] ui::MathBox fitted(std::int32_t m, std::int32_t x, float width) const {
        const auto short_chain = [&](std::int32_t named, bool under_work) {
            const TapeMath math = math_of(visit_.tape, named);
            const bool rounds = math.symbols.op == ui::Op::call && math.symbols.parts.size() == 1;
            ui::Expr value = under_work ? ui::marked(math.value) : math.value;
            if (rounds) return ui::relation_chain({math.name, rounded(named, math), std::move(value)}, {"=", "="});
            return ui::relation_chain({math.name, math.numbers, std::move(value)},
                                      {"=", std::string(ui::equals_sign(math.exact))});
        };
        const ui::Expr first = short_chain(m, false), second = short_chain(x, true);
        ui::MathBox box;
        for (const ui::MathSize size : {ui::MathSize::row, ui::MathSize::prose, ui::MathSize::note}) {
            const ui::MathSetting setting{.fonts = &ui_.fonts(), .size = size, .fold_signs = true};
            const ui::MathBox left = ui::set_math(first, setting), right = ui::set_math(second, setting);
            const float gap = ui_.px(size == ui::MathSize::note ? 10 : 16);
            if (left.width + gap + right.width <= width - ui_.px(8)) return beside(left, right, gap);
            const ui::MathBox both[] = {left, ui::set_math_broken(second, setting, width)};
            box = ui::stacked(both, ui_.px(kLeastGap));
        }
        return box;
    }
    [[nodiscard]] static ui::MathBox beside(const ui::MathBox& left, const ui::MathBox& right, float gap) {
        ui::MathBox out = left;
        const float dx = left.width + gap;
        for (ui::MathText text : right.texts) text.at.x += dx, out.texts.push_back(std::move(text));
        for (ui::MathInk ink : right.inks) ink.area = ink.area.moved(dx, 0), out.inks.push_back(ink);
        for (ui::MathLink link : right.links) link.area = link.area.moved(dx, 0), out.links.push_back(link);
        out.width = dx + right.width;
        out.ascent = std::max(left.ascent, right.ascent);
        out.descent = std::max(left.descent, right.descent);
        return out;
    }
    /// round(…) of one number: the value of what is rounded.
    [[nodiscard]] ui::Expr rounded(std::int32_t named, const TapeMath& math) const {
        const Operation* operation = &operation_of(visit_.tape.names[static_cast<std::size_t>(named)].operation);
        while (operation->op == Op::to_real || operation->op == Op::same) operation = &operation_of(operation->a);
        if (operation->a < 0) return math.numbers;
        return ui::call(math.symbols.text, {value_term(operation_of(operation->a).value)});
    }
    [[nodiscard]] const Operation& operation_of(std::int32_t at) const {
        return visit_.tape.operations[static_cast<std::size_t>(at)];
    }

    static constexpr float kLeastGap = 3;  ///< between lines: with it two rows' four fit where the panel is lowest
    static constexpr std::string_view kNoRow = "Step into a row to see where it meets the two sides.";

    const ViewContext& context_;
    ui::Ui& ui_;
    const Visit& visit_;
    ui::Area area_, boxes_;
    Ring ring_;
};

void draw(const ViewContext& context, const ui::Area& place) {
    const ui::Area area = begin_view(context, "ring", place, kTitle, kNote);
    RingView view(context, area);
    if (context.derived.shape() < 0 || view.empty())
        draw_empty(context, area, kNoRing);
    else
        view.draw();
    context.ui.end_panel();
}

constexpr View kView{"ring", kTab, draw};
const RegisterView kRegistered(kView);

}  // namespace
}  // namespace texelscope::ring_view
