#include "app/views/formula_blocks.h"

#include <algorithm>
#include <array>
#include <set>

#include <fmt/format.h>

#include "app/views/terms.h"

namespace texelscope {
namespace {

constexpr std::string_view kSideNote = "side {}, from $P_{}$ to $P_{}$";
constexpr std::string_view kAreaNote = "$Δ = {}$ twice the area";

[[nodiscard]] bool trivial(const Tape& tape, std::int32_t named) { return operands_of(tape, named).empty(); }

[[nodiscard]] ui::MathSetting setting_of(const ui::Fonts& fonts, ui::MathSize size, bool fold) {
    return {.fonts = &fonts, .size = size, .fold_signs = fold};
}

/// A sum, or what is joined by "or", as links of the chain, so that it can be broken before any of its terms.
void add_link(const ui::Expr& e, std::string_view sign, std::vector<ui::Expr>& parts, std::vector<std::string>& signs) {
    const auto term = [](const ui::Expr& t) {
        const bool wraps = t.op == ui::Op::sum || t.op == ui::Op::negation || (t.op == ui::Op::number && t.negative);
        return wraps ? ui::call("", {t}) : t;
    };
    if (e.op == ui::Op::relation && e.link == 0 && e.signs.front() == "∨") {
        for (std::size_t n = 0; n < e.parts.size(); ++n) {
            parts.push_back(e.parts[n]);
            signs.emplace_back(n == 0 ? sign : e.signs[n - 1]);
        }
        return;
    }
    if (e.op != ui::Op::sum) {
        parts.push_back(e);
        signs.emplace_back(sign);
        return;
    }
    for (std::size_t n = 0; n < e.parts.size(); ++n) {
        const bool minus = n > 0 && e.parts[n].op == ui::Op::negation;
        const ui::Expr& inner = minus ? e.parts[n].parts.front() : e.parts[n];
        parts.push_back(n == 0 ? inner : term(inner));
        signs.emplace_back(n == 0 ? sign : minus ? ui::kMinus : "+");
    }
}

[[nodiscard]] ui::Expr with_terms_open(const ui::Expr& chain) {
    std::vector<ui::Expr> parts{chain.parts.front()};
    std::vector<std::string> signs;
    for (std::size_t n = 1; n < chain.parts.size(); ++n) add_link(chain.parts[n], chain.signs[n - 1], parts, signs);
    return ui::relation_chain(std::move(parts), std::move(signs));
}

constexpr std::array kFormulaBlocksSizes{ui::MathSize::row, ui::MathSize::prose, ui::MathSize::note};

/// How a chain is set: on one line where a size allows it, else broken.
struct ChainSize {
    ui::MathSize size = ui::MathSize::note;
    bool broken = false;
};

[[nodiscard]] ui::MathBox set_chain(const ui::Fonts& fonts, const ui::Expr& chain, const ChainSize& as, float width) {
    const bool fold = as.broken || as.size != kFormulaBlocksSizes.front();
    if (!as.broken) return ui::set_math(chain, setting_of(fonts, as.size, fold));
    ui::MathBox box = ui::set_math_broken(chain, setting_of(fonts, as.size, fold), width);
    if (box.width <= width || as.size != kFormulaBlocksSizes.back()) return box;
    return ui::set_math_broken(with_terms_open(chain), setting_of(fonts, as.size, fold), width);
}

/// The largest size from `largest` on in which the chain fits.
[[nodiscard]] ChainSize size_of(const ui::Fonts& fonts, const ui::Expr& chain, float width,
                                ui::MathSize largest = kFormulaBlocksSizes.front()) {
    for (const bool broken : {false, true}) {
        for (const ui::MathSize size : kFormulaBlocksSizes) {
            if (size <= largest && set_chain(fonts, chain, {size, broken}, width).width <= width) return {size, broken};
        }
    }
    return {kFormulaBlocksSizes.back(), true};
}

}  // namespace

FormulaBlock formula_line(const ui::Fonts& fonts, const Tape& tape, std::int32_t named, bool marked, float width) {
    const ui::Expr chain = chain_of(math_of(tape, named), marked);
    return {set_chain(fonts, chain, size_of(fonts, chain, width), width), named};
}

FormulaBlock formula_block(const ui::Fonts& fonts, const Tape& tape, std::int32_t named, bool marked, float width) {
    const TapeMath math = math_of(tape, named);
    if (math.tall || math.leaf || !math.fault.empty() || math.symbols.op == ui::Op::symbol)
        return formula_line(fonts, tape, named, marked, width);
    const bool truth = math.value.op == ui::Op::word && math.symbols.op == ui::Op::relation;
    const ui::Expr name = marked ? ui::marked(math.name) : math.name;
    const ui::Expr above = ui::relation(name, truth ? ":" : "=", math.symbols);
    const ui::Expr below = ui::relation(math.value, truth ? ":" : ui::equals_sign(math.exact), math.numbers);
    for (const ui::MathSize size : kFormulaBlocksSizes) {
        for (const bool fold : {false, true}) {
            ui::MathBox box = ui::set_substitution(above, below, setting_of(fonts, size, fold));
            if (box.width <= width) return {std::move(box), named};
        }
    }
    return formula_line(fonts, tape, named, marked, width);
}

std::vector<FormulaBlock> formula_list(const ui::Fonts& fonts, const Tape& tape, std::span<const std::int32_t> names,
                                       std::int32_t now, float width) {
    std::vector<ui::Expr> chains;
    ui::MathSize size = kFormulaBlocksSizes.front();
    for (const std::int32_t n : names) {
        chains.push_back(chain_of(math_of(tape, n), n == now));
        size = std::min(size, size_of(fonts, chains.back(), width).size);
    }
    std::vector<FormulaBlock> blocks;
    for (std::size_t n = 0; n < names.size(); ++n)
        blocks.push_back({set_chain(fonts, chains[n], size_of(fonts, chains[n], width, size), width), names[n]});
    return blocks;
}

bool shows_list(const Visit& visit, const Cursor& cursor) {
    if (cursor.step.at_expression()) return false;
    return !cursor.step.index_of('x') && visit.unit().expressions.size() > 1;
}

std::vector<std::int32_t> listed_names(const Visit& visit) {
    std::vector<std::int32_t> names;
    std::set<std::string> later;
    const auto& own = visit.unit().expressions;
    for (auto n = own.rbegin(); n != own.rend(); ++n) {
        const bool last = later.insert(visit.tape.names[static_cast<std::size_t>(*n)].name.text()).second;
        if (last && !trivial(visit.tape, *n)) names.push_back(*n);
    }
    std::reverse(names.begin(), names.end());
    return names;
}

std::vector<std::int32_t> setup_names(const Visit& visit, std::int32_t named) {
    std::vector<std::int32_t> names;
    for (const std::int32_t n : operands_of(visit.tape, named)) {
        const Named& operand = visit.tape.names[static_cast<std::size_t>(n)];
        if (!operand.loop_variable && !trivial(visit.tape, n)) names.push_back(n);
    }
    // What was prepared in an earlier unit tells more than what was computed a line above.
    const auto& own = visit.unit().expressions;
    std::stable_partition(names.begin(), names.end(),
                          [&](std::int32_t n) { return std::find(own.begin(), own.end(), n) == own.end(); });
    return names;
}

std::string formula_note(const Derived& derived, std::int32_t named) {
    const Tape& tape = derived.visit().tape;
    if (named < 0) return {};
    const std::string name = tape.names[static_cast<std::size_t>(named)].name.text();
    const int edge = edge_of_name(name), shape = derived.shape();
    if (edge >= 0 && shape >= 0) {
        const int corners = static_cast<int>(derived.drawing().corners(shape).size());
        return fmt::format(kSideNote, static_cast<char>('A' + edge), edge, (edge + 1) % std::max(1, corners));
    }
    const std::int32_t area = find_name(tape, "Δ", named);
    if (area < 0 || area == named) return {};
    const Operation& operation =
        tape.operations[static_cast<std::size_t>(tape.names[static_cast<std::size_t>(area)].operation)];
    const ui::Number number = shown_number(operation.value);
    if (undefined(operation.value)) return {};
    const std::string digits = number.negative ? "-" + number.text.substr(ui::kMinus.size()) : number.text;
    return fmt::format(kAreaNote, digits);
}

}  // namespace texelscope
