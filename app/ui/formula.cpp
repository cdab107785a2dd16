#include "app/ui/formula.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <optional>

#include "app/ui/formula_parts.h"
#include "app/ui/text.h"

namespace texelscope::ui {
namespace {

constexpr float kRelationGap = .30F;

bool is_number(const Expr& e) { return e.op == Op::number; }

bool has_number(const Expr& e) {
    return std::any_of(e.parts.begin(), e.parts.end(), [](const Expr& part) { return is_number(part); });
}

bool looks_negative(const Expr& e) { return (is_number(e) && e.negative) || e.op == Op::negation; }

class Setter {
public:
    explicit Setter(const MathSetting& setting) : setting_(setting), kit_(setting) {}

    MathBox set(const Expr& e) {
        MathBox box = set_bare(e);
        if (e.marked) box = kit_.marked(std::move(box));
        if (e.link != 0) box.links.push_back({{0, -box.ascent, box.width, box.height()}, e.link});
        return box;
    }

    MathBox operand(const Expr& e, bool first) {
        const bool wrap = e.op == Op::sum || e.op == Op::relation || (!first && looks_negative(e));
        return wrap ? kit_.in_parentheses(set(e)) : set(e);
    }

    /// A sum's term without its sign, and the sign.
    std::pair<MathBox, std::string_view> term(const Expr& e, bool first) {
        if (!first && e.op == Op::negation) return {operand(e.parts.front(), false), kMinus};
        if (!first && setting_.fold_signs && is_number(e) && e.negative) {
            Expr positive = e;
            positive.text.erase(0, kMinus.size());
            return {set(positive), kMinus};
        }
        return {operand(e, first || e.op == Op::sum), "+"};
    }

    MathKit& kit() { return kit_; }

private:
    MathBox set_bare(const Expr& e) {
        switch (e.op) {
            case Op::symbol: return kit_.symbol(e.text, e.sub, e.role);
            case Op::number: return kit_.upright(e.text, e.role);
            case Op::word: return kit_.word(e.text, e.role);
            case Op::sum: return sum(e);
            case Op::product: return product(e);
            case Op::quotient: return kit_.fraction(set(e.parts[0]), set(e.parts[1]));
            case Op::slash: return slash(e);
            case Op::negation: return kit_.row({kit_.upright(kMinus, Role::text), operand(e.parts[0], false)}, 0);
            case Op::call: return function(e);
            case Op::floor: return kit_.floor(set(e.parts[0]));
            case Op::determinant: return kit_.determinant(std::max(1, e.columns), cells(e));
            case Op::matrix: return kit_.matrix(std::max(1, e.columns), cells(e));
            case Op::relation: return chain(e);
            case Op::sequence: return sequence(e);
        }
        return {};
    }

    MathBox sum(const Expr& e) {
        MathBox out;
        for (std::size_t i = 0; i < e.parts.size(); ++i) {
            auto [box, sign] = term(e.parts[i], i == 0);
            if (i > 0) out = kit_.with_sign(std::move(out), sign, kit_.em() * .22F, Role::text);
            append(out, box);
        }
        return out;
    }

    MathBox product(const Expr& e) {
        const bool dotted = setting_.dots || has_number(e);
        MathBox out;
        for (std::size_t i = 0; i < e.parts.size(); ++i) {
            if (i > 0 && dotted) out = kit_.with_sign(std::move(out), "·", kit_.em() * .22F, Role::text);
            if (i > 0 && !dotted) out.width += kit_.em() * .17F;
            append(out, operand(e.parts[i], i == 0));
        }
        return out;
    }

    MathBox slash(const Expr& e) {
        const auto side = [&](const Expr& part) {
            return part.op == Op::product ? kit_.in_parentheses(set(part)) : operand(part, false);
        };
        return kit_.row({e.parts[0].op == Op::product ? set(e.parts[0]) : operand(e.parts[0], true),
                         kit_.upright("/", Role::text), side(e.parts[1])},
                        kit_.em() * .04F);
    }

    MathBox function(const Expr& e) {
        MathBox inner;
        for (std::size_t i = 0; i < e.parts.size(); ++i) {
            if (i > 0) append(inner, kit_.upright(", ", Role::text));
            append(inner, set(e.parts[i]));
        }
        return kit_.row({kit_.upright(e.text, Role::text), kit_.in_parentheses(inner)}, 0);
    }

    std::vector<MathBox> cells(const Expr& e) {
        std::vector<MathBox> boxes;
        for (const Expr& part : e.parts) boxes.push_back(set(part));
        return boxes;
    }

    MathBox chain(const Expr& e) {
        MathBox out;
        for (std::size_t i = 0; i < e.parts.size(); ++i) {
            if (i > 0) out = kit_.with_sign(std::move(out), e.signs[i - 1], kRelationGap * kit_.em(), Role::text);
            append(out, set(e.parts[i]));
        }
        return out;
    }

    MathBox sequence(const Expr& e) {
        std::vector<MathBox> boxes;
        for (const Expr& part : e.parts) boxes.push_back(set(part));
        return kit_.row(std::move(boxes), kit_.em() * .35F);
    }

    MathSetting setting_;
    MathKit kit_;
};

/// One entry of a row that is to stand under another: a term, or the sign between two.
struct Cell {
    MathBox box;
    bool sign = false;
};

class Row {
public:
    Row(const MathSetting& setting, bool muted) : setter_(setting), muted_(muted) {}

    std::vector<Cell> cells_of(const Expr& e) {
        add(e, true);
        return std::move(cells_);
    }

private:
    void sign(std::string_view text) {
        const bool plain = !muted_;
        cells_.push_back({setter_.kit().upright(text, plain ? Role::text : Role::muted), true});
    }

    void add(const Expr& e, bool first) {
        if (e.op == Op::relation) {
            for (std::size_t i = 0; i < e.parts.size(); ++i) {
                if (i > 0) sign(e.signs[i - 1]);
                add(e.parts[i], true);
            }
        } else if (e.op == Op::sum && first) {
            for (std::size_t i = 0; i < e.parts.size(); ++i) add_term(e.parts[i], i == 0);
        } else if (e.op == Op::product && e.link == 0) {
            for (std::size_t i = 0; i < e.parts.size(); ++i) {
                if (i > 0) sign("·");
                cells_.push_back({setter_.operand(e.parts[i], first && i == 0), false});
            }
        } else {
            Expr bare = e;
            bare.marked = false;
            cells_.push_back({setter_.operand(bare, first), false});
        }
    }

    void add_term(const Expr& e, bool first) {
        const Expr& inner = !first && e.op == Op::negation ? e.parts.front() : e;
        if (inner.op == Op::product) {
            if (!first) sign(&inner == &e ? "+" : kMinus);
            add(inner, first);
            return;
        }
        auto [box, text] = setter_.term(e, first);
        if (!first) sign(text);
        cells_.push_back({std::move(box), false});
    }

    Setter setter_;
    bool muted_;
    std::vector<Cell> cells_;
};

bool same_shape(const std::vector<Cell>& a, const std::vector<Cell>& b) {
    if (a.size() != b.size()) return false;
    for (std::size_t i = 0; i < a.size(); ++i)
        if (a[i].sign != b[i].sign) return false;
    return true;
}

}  // namespace

MathBox set_math(const Expr& e, const MathSetting& setting) { return Setter(setting).set(e); }

MathBox set_math_to_fit(const Expr& e, MathSetting setting, float width, std::span<const MathSize> sizes) {
    MathBox box;
    for (const MathSize size : sizes) {
        setting.size = size;
        box = set_math(e, setting);
        if (box.width <= width) break;
    }
    return box;
}

namespace {

/// A side of a relation that no line break can help: in the largest size up to the setting's that fits.
[[nodiscard]] MathBox set_smaller_to_fit(const Expr& e, MathSetting setting, float width) {
    MathBox box = set_math(e, setting);
    while (box.width > width && setting.size != MathSize::note) {
        setting.size = static_cast<MathSize>(static_cast<int>(setting.size) - 1);
        box = set_math(e, setting);
    }
    return box;
}

}  // namespace

MathBox set_math_broken(const Expr& e, const MathSetting& setting, float width) {
    if (e.op != Op::relation || e.parts.size() < 2) return set_math(e, setting);
    Setter setter(setting);
    MathKit& kit = setter.kit();
    const MathBox left = setter.set(e.parts.front());
    std::vector<MathBox> parts;
    for (std::size_t i = 1; i < e.parts.size(); ++i) {
        parts.push_back(kit.with_sign({}, e.signs[i - 1], kRelationGap * kit.em(), Role::text));
        append(parts.back(), set_smaller_to_fit(e.parts[i], setting, width - left.width - parts.back().width));
    }
    // Lines fill from the last one: a result stays beside what it came from.
    std::vector<std::size_t> starts;
    float used = left.width;
    for (std::size_t i = parts.size(); i-- > 0;) {
        used += parts[i].width;
        if (used > width && i + 1 < parts.size()) {
            starts.insert(starts.begin(), i + 1);
            used = left.width + parts[i].width;
        }
    }
    std::vector<MathBox> lines{left};
    for (std::size_t i = 0; i < parts.size(); ++i) {
        if (std::find(starts.begin(), starts.end(), i) != starts.end()) {
            lines.emplace_back();
            lines.back().width = left.width;
        }
        append(lines.back(), parts[i]);
    }
    return stacked(lines, kit.em() * .9F);
}

MathBox set_substitution(const Expr& symbols, const Expr& numbers, const MathSetting& setting) {
    MathKit kit(setting);
    MathSetting below = setting;
    if (setting.size != MathSize::note) below.size = static_cast<MathSize>(static_cast<int>(setting.size) - 1);
    const std::vector<Cell> top = Row(setting, false).cells_of(symbols), bottom = Row(below, true).cells_of(numbers);
    const float lead = std::round(kit.em() * 1.38F + (setting.fonts->spec().presenting ? kit.em() * .12F : 0));
    if (!same_shape(top, bottom)) {
        const MathBox both[] = {set_math(symbols, setting), set_math(numbers, below)};
        return stacked(both, kit.em() * .3F);
    }
    MathBox out;
    std::optional<Area> mark;
    for (std::size_t i = 0; i < top.size(); ++i) {
        const float gap = top[i].sign ? kit.em() * .22F : 0;
        const bool marked = i == 0 && !symbols.parts.empty() && symbols.parts.front().marked;
        const float pad = marked ? kit.em() * .32F : 0;
        const float width = std::max(top[i].box.width, bottom[i].box.width) + 2 * (gap + pad);
        const float left = out.width;
        const auto centred = [&](const MathBox& box) { return left + (width - box.width) / 2; };
        put(out, top[i].box, {centred(top[i].box), 0});
        put(out, bottom[i].box, {centred(bottom[i].box), lead});
        out.width = left + width;
        if (marked) mark = Area{left, -kit.em() * .95F, width, kit.em() * 1.35F + lead};
    }
    if (mark) put_mark_under(out, *mark);
    return out;
}

MathBox stacked(std::span<const MathBox> boxes, float gap) {
    MathBox out;
    float y = 0;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        if (i > 0) y = std::round(y + boxes[i - 1].descent + gap + boxes[i].ascent);
        put(out, boxes[i], {0, y});
    }
    return out;
}

}  // namespace texelscope::ui
