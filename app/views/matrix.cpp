// The chain M⁻¹ = U · P⁻¹ with its numbers: from the corners on the texture and on the screen to the nine
// coefficients a … i. What the current expression is made of is marked.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "app/views/terms.h"

namespace texelscope::matrix_view {
namespace {

constexpr std::string_view kTitle = "Matrix chain", kTab = "Matrix", kNote = "M⁻¹ = U · P⁻¹, P⁻¹ = A / det";
constexpr std::string_view kNone =
    "Only methods that lay the texture on with one matrix have it: backward-affine, backward-projective, constant-z.";
constexpr float kLineGap = 12;

using Names = std::array<std::string, 9>;
constexpr std::array<ui::MathSize, 3> kSizes{ui::MathSize::row, ui::MathSize::prose, ui::MathSize::note};

class MatrixView {
public:
    MatrixView(const ViewContext& context, const ui::Area& area)
        : context_(context), ui_(context.ui), tape_(context.derived.visit().tape), area_(area) {
        const std::int32_t now = current_name(context.derived);
        if (now < 0) return;
        lit_ = operands_of(tape_, now);
        lit_.push_back(now);
    }

    [[nodiscard]] bool empty() const { return last("det") < 0 || last("i") < 0; }

    void draw() {
        std::vector<ui::MathBox> lines = fitted();
        float height = 0;
        for (const ui::MathBox& line : lines) height += line.height();
        const auto gaps = static_cast<float>(lines.size() + 1);
        const float gap = std::floor(std::clamp((area_.h - height) / gaps, ui_.px(5), ui_.px(kLineGap)));
        const float content = height + gaps * gap;
        foresee(ui_, "matrix/scroll", content);
        const ui::Area inner = ui_.begin_scroll("matrix/scroll", area_);
        float y = inner.y + gap;
        for (std::size_t n = 0; n < lines.size(); ++n) {
            const glm::vec2 pen{inner.x + ui_.px(4), y + lines[n].ascent};
            draw_marks(lines[n], pen);
            draw_terms(context_, fmt::format("matrix/{}", n), tape_, lines[n], pen);
            y += lines[n].height() + gap;
        }
        ui_.end_scroll(content);
    }

private:
    [[nodiscard]] bool lit(std::int32_t named) const {
        return std::find(lit_.begin(), lit_.end(), named) != lit_.end();
    }
    /// Lies under the terms and takes no room, so that stepping moves nothing.
    void draw_marks(const ui::MathBox& box, glm::vec2 pen) {
        const ui::Color now = ui_.theme()[ui::Role::now];
        for (const ui::MathLink& link : box.links) {
            if (!lit(named_of(link.id))) continue;
            const ui::Area at = link.area.moved(std::round(pen.x), std::round(pen.y)).inset(-ui_.px(3), -ui_.px(1));
            ui::fill(ui_.list(), at, ui::with_alpha(now, ui::alpha::kMark), ui::size::kBadgeRadius);
            ui::fill(ui_.list(), {at.x, std::round(at.bottom()) - 1, at.w, 2}, now);
        }
    }
    /// Of a … i those that follow det: in a pixel g and b are channels, too.
    [[nodiscard]] std::int32_t named_as(std::string_view name) const {
        if (name.size() != 1) return last(name);
        for (auto n = last("det"); n >= 0 && n < static_cast<std::int32_t>(tape_.names.size()); ++n)
            if (tape_.names[static_cast<std::size_t>(n)].name.text() == name) return n;
        return -1;
    }
    [[nodiscard]] std::int32_t last(std::string_view name) const {
        return find_name(tape_, name, static_cast<std::int32_t>(tape_.names.size()) - 1);
    }
    [[nodiscard]] ui::Expr term(const std::string& name, bool number, int decimals) const {
        const std::int32_t named = named_as(name);
        if (named < 0) return ui::number(1);  // what has no name is the 1 of (u, v, 1)
        const Value& value =
            tape_.operations[static_cast<std::size_t>(tape_.names[static_cast<std::size_t>(named)].operation)].value;
        ui::Expr e = symbol_of_name(name);
        if (number) {
            const ui::Role role = e.role;
            e = undefined(value) ? value_term(value) : ui::number(shown_number(value, decimals), role);
            e.negative = false;  // a cell needs no parentheses
        }
        if (lit(named)) e.role = ui::Role::text;  // a role's colour is too weak on the mark
        return ui::linked(std::move(e), link_of(named));
    }
    [[nodiscard]] ui::Expr matrix(const Names& names, bool numbers, int decimals = 4) const {
        std::vector<ui::Expr> cells;
        for (const std::string& name : names) cells.push_back(term(name, numbers, decimals));
        return ui::matrix(3, std::move(cells));
    }
    /// The corner of the polygon that spanning corner n is: the one that X_n was made from.
    [[nodiscard]] int corner(int n) const {
        const std::int32_t x = last(fmt::format("X_{}", n));
        if (x < 0) return n;
        for (const std::int32_t operand : operands_of(tape_, x)) {
            const int c = corner_of_name(tape_.names[static_cast<std::size_t>(operand)].name.text());
            if (c >= 0) return c;
        }
        return n;
    }
    [[nodiscard]] Names inverse() const { return {"a", "b", "c", "d", "e", "f", "g", "h", "i"}; }
    [[nodiscard]] Names texture() const {
        Names names;
        for (int n = 0; n < 3; ++n) {
            names[static_cast<std::size_t>(n)] = fmt::format("u_{}", corner(n));
            names[static_cast<std::size_t>(n) + 3] = fmt::format("v_{}", corner(n));
        }
        return names;
    }
    [[nodiscard]] Names screen() const {
        Names names;
        for (int n = 0; n < 3; ++n) {
            names[static_cast<std::size_t>(n)] = fmt::format("X_{}", n);
            names[static_cast<std::size_t>(n) + 3] = fmt::format("Y_{}", n);
            names[static_cast<std::size_t>(n) + 6] = fmt::format("w_{}", corner(n));
        }
        return names;
    }
    /// Row by row: A_11 A_21 A_31, A_12 …: the cofactors of P, turned over.
    [[nodiscard]] Names cofactors() const {
        Names names;
        for (std::size_t n = 0; n < 9; ++n) names[n] = fmt::format("A_{}{}", n % 3 + 1, n / 3 + 1);
        return names;
    }
    /// M⁻¹ = U · 1/det · A.
    [[nodiscard]] ui::Expr chain(bool numbers, int decimals) const {
        return ui::relation_chain(
            {matrix(inverse(), numbers, decimals), matrix(texture(), numbers, decimals),
             ui::quotient(ui::number(1), term("det", numbers, decimals)), matrix(cofactors(), numbers, decimals)},
            {"=", "·", "·"});
    }
    [[nodiscard]] ui::Expr beside(const Names& names, int decimals) const {
        return ui::relation(matrix(names, false, decimals), "=", matrix(names, true, decimals));
    }

    /// The chain in names, then in numbers, with P where there is room; or each matrix beside its own numbers.
    enum class Lines { with_p, chain, narrow };
    [[nodiscard]] std::vector<ui::Expr> lines_of(Lines lines, int decimals) const {
        if (lines == Lines::narrow)
            return {beside(inverse(), decimals), beside(texture(), decimals), beside(cofactors(), decimals),
                    ui::relation(term("det", false, decimals), "=", term("det", true, decimals)),
                    beside(screen(), decimals)};
        ui::Expr p = ui::relation(ui::symbol("P"), "=", matrix(screen(), false, decimals));
        if (lines == Lines::chain) return {ui::sequence({chain(false, decimals), p}), chain(true, decimals)};
        return {chain(false, decimals), chain(true, decimals),
                ui::relation(ui::symbol("P"), "=", beside(screen(), decimals))};
    }

    [[nodiscard]] std::vector<ui::MathBox> fitted() const {
        std::vector<ui::MathBox> boxes;
        for (const Lines lines : {Lines::with_p, Lines::chain, Lines::narrow}) {
            for (const int decimals : {4, 2}) {
                for (const ui::MathSize size : kSizes) {
                    boxes.clear();
                    float width = 0, height = ui_.px(5);
                    for (const ui::Expr& e : lines_of(lines, decimals)) {
                        boxes.push_back(ui::set_math(e, {.fonts = &ui_.fonts(), .size = size}));
                        width = std::max(width, boxes.back().width), height += boxes.back().height() + ui_.px(5);
                    }
                    const bool scrolls = lines == Lines::narrow && size == kSizes.back();
                    if (width <= area_.w - ui_.px(16) && (height <= area_.h || scrolls)) return boxes;
                }
            }
        }
        return boxes;
    }

    const ViewContext& context_;
    ui::Ui& ui_;
    const Tape& tape_;
    ui::Area area_;
    std::vector<std::int32_t> lit_;
};

void draw(const ViewContext& context, const ui::Area& place) {
    const ui::Area area = begin_view(context, "matrix", place, kTitle, kNote);
    MatrixView view(context, area);
    if (context.derived.shape() < 0 || view.empty())
        draw_empty(context, area, kNone);
    else
        view.draw();
    context.ui.end_panel();
}

constexpr View kView{"matrix", kTab, draw};
const RegisterView kRegistered(kView);

}  // namespace
}  // namespace texelscope::matrix_view
