#include "app/views/math_of_tape.h"

#include <functional>
#include <set>

#include <gtest/gtest.h>

#include "core/method/drawing.h"
#include "tests/app/views/view_stage.h"

namespace texelscope {
namespace {

/// Calls `look` with a visit of every stage, of a row and of a few pixels, of every variant of every method.
void each_visit(NumberFormat format, const std::function<void(const Visit&)>& look) {
    for (const std::string id : {"edge-equations", "sections"}) {
        const Method& method = *find_method(id);
        const Scene scene = stage_scene(id == "sections");
        for (const VariantInfo& variant : method.variants) {
            const Drawing drawing(scene, {&method, format, variant.quirks, {}});
            const Visit shape = visit(drawing, Path{{{'t', 0}}});
            for (Integer s = 0; s < static_cast<Integer>(shape.stages.size()); ++s) {
                const Path stage = shape.path.child('s', s);
                const Visit at_stage = visit(drawing, stage);
                look(at_stage);
                const auto& rows = at_stage.unit().loop;
                if (!rows || rows->count() == 0) continue;
                const Path row = stage.child(rows->letter, rows->first + rows->count() / 2 * rows->step);
                const Visit at_row = visit(drawing, row);
                look(at_row);
                const auto& pixels = at_row.unit().loop;
                if (!pixels || pixels->count() == 0) continue;
                for (const Integer k : {Integer{0}, pixels->count() / 2})
                    look(visit(drawing, row.child(pixels->letter, pixels->first + k * pixels->step)));
            }
        }
    }
}

[[nodiscard]] const Operation& operation_of(const Tape& tape, std::size_t named) {
    return tape.operations[static_cast<std::size_t>(tape.names[named].operation)];
}

[[nodiscard]] SymbolValue values_on(const Tape& tape) {
    return [&tape](const ui::Expr& e) -> std::optional<double> {
        if (e.link == 0) return std::nullopt;
        return approximate(operation_of(tape, static_cast<std::size_t>(named_of(e.link))).value);
    };
}

TEST(MathOfTape, EveryNamedValueIsWhatItsTermsGive) {
    int checked = 0;
    each_visit(NumberFormat::f64, [&](const Visit& v) {
        for (std::size_t n = 0; n < v.tape.names.size(); ++n) {
            const TapeMath math = math_of(v.tape, static_cast<std::int32_t>(n));
            if (math.leaf) continue;
            const auto value = evaluated(math.symbols, values_on(v.tape));
            ASSERT_TRUE(value) << v.path.text() << " " << v.tape.names[n].name.text();
            EXPECT_EQ(*value, approximate(operation_of(v.tape, n).value))
                << v.path.text() << " " << v.tape.names[n].name.text();
            ++checked;
        }
    });
    EXPECT_GT(checked, 500);
}

/// The named inputs that an operation depends on.
void inputs_of(const Tape& tape, const std::set<std::int32_t>& named, std::int32_t at, std::set<std::int32_t>& inputs) {
    const Operation& o = tape.operations[static_cast<std::size_t>(at)];
    if (o.op == Op::input && named.contains(at)) inputs.insert(at);
    for (const std::int32_t x : {o.a, o.b, o.c}) {
        if (x >= 0) inputs_of(tape, named, x, inputs);
    }
}

void links_of(const ui::Expr& e, std::set<ui::LinkId>& links) {
    if (e.link != 0) links.insert(e.link);
    for (const ui::Expr& part : e.parts) links_of(part, links);
}

TEST(MathOfTape, NoTermIsLost) {
    each_visit(NumberFormat::f32, [&](const Visit& v) {
        std::set<std::int32_t> named;
        for (const Named& n : v.tape.names) named.insert(n.operation);
        for (std::size_t n = 0; n < v.tape.names.size(); ++n) {
            const TapeMath math = math_of(v.tape, static_cast<std::int32_t>(n));
            if (math.leaf) continue;
            std::set<std::int32_t> needed, shown;
            inputs_of(v.tape, named, v.tape.names[n].operation, needed);
            std::set<ui::LinkId> links;
            links_of(math.symbols, links);
            for (const ui::LinkId link : links) {
                inputs_of(v.tape, named, v.tape.names[static_cast<std::size_t>(named_of(link))].operation, shown);
            }
            EXPECT_EQ(needed, shown) << v.path.text() << " " << v.tape.names[n].name.text();
        }
    });
}

TEST(MathOfTape, EqualIsSaidOnlyWhereTheWrittenNumbersGiveTheWrittenValue) {
    for (const NumberFormat format : {NumberFormat::f64, NumberFormat::fx8_8, NumberFormat::exact}) {
        each_visit(format, [&](const Visit& v) {
            for (std::size_t n = 0; n < v.tape.names.size(); ++n) {
                const TapeMath math = math_of(v.tape, static_cast<std::int32_t>(n));
                if (math.leaf || !math.exact || !math.fault.empty()) continue;
                const auto nothing = [](const ui::Expr&) { return std::nullopt; };
                const auto left = evaluated(math.numbers, nothing), right = evaluated(math.value, nothing);
                if (!left || !right) continue;
                EXPECT_EQ(*left, *right) << v.path.text() << " " << v.tape.names[n].name.text();
            }
        });
    }
}

[[nodiscard]] TapeMath math_at(const std::string& method, const std::string& step, const std::string& name,
                               NumberFormat format = NumberFormat::f64) {
    const Scene scene = stage_scene(method == "sections");
    const Drawing drawing(scene, {find_method(method), format, 0, {}});
    const Visit v = visit(drawing, *parse_path(step));
    for (std::size_t n = 0; n < v.tape.names.size(); ++n) {
        if (v.tape.names[n].name.text() == name) return math_of(v.tape, static_cast<std::int32_t>(n));
    }
    ADD_FAILURE() << name;
    return {};
}

TEST(MathOfTape, ThePlanesAreQuotientsOfTwoDeterminants) {
    for (const std::string name : {"u_x", "u_y", "v_x", "v_y"}) {
        const TapeMath math = math_at("edge-equations", "t0/s5/y11/x16", name);
        ASSERT_EQ(math.symbols.op, ui::Op::quotient) << name;
        EXPECT_EQ(math.symbols.parts[0].op, ui::Op::determinant) << name;
        EXPECT_EQ(math.symbols.parts[1].op, ui::Op::determinant) << name;
        EXPECT_NE(math.symbols.parts[1].link, 0U) << name;
        EXPECT_TRUE(math.tall) << name;
    }
}

TEST(MathOfTape, CoefficientsStandBeforeTheirCoordinates) {
    const TapeMath math = math_at("edge-equations", "t0/s5/y11/x16", "u");
    ASSERT_EQ(math.symbols.op, ui::Op::sum);
    ASSERT_EQ(math.symbols.parts.size(), 3U);
    EXPECT_EQ(math.symbols.parts[0].parts[0].sub, "x");
    EXPECT_EQ(math.symbols.parts[0].parts[1].text, "X");
    EXPECT_FALSE(math.tall);
    EXPECT_FALSE(math.exact);
}

TEST(MathOfTape, AMaskedFloorIsSetWithBrackets) {
    const TapeMath math = math_at("edge-equations", "t0/s5/y11/x16", "column");
    ASSERT_EQ(math.symbols.op, ui::Op::relation);
    EXPECT_EQ(math.symbols.signs, std::vector<std::string>{"&"});
    EXPECT_EQ(math.symbols.parts[0].op, ui::Op::floor);
    EXPECT_TRUE(math.exact);
}

TEST(MathOfTape, InputsAreLeaves) {
    EXPECT_TRUE(math_at("edge-equations", "t0/s0", "x_0").leaf);
    EXPECT_FALSE(math_at("edge-equations", "t0/s0", "Δ").leaf);
}

TEST(MathOfTape, AValueThatLeftItsRangeSaysSo) {
    EXPECT_EQ(math_at("edge-equations", "t0/s0", "Δ", NumberFormat::fx8_8).fault, "left 8.8");
    EXPECT_TRUE(math_at("edge-equations", "t0/s0", "Δ", NumberFormat::fx16_16).fault.empty());
    EXPECT_EQ(fault_of(Value(std::nan(""))), "no value");
    EXPECT_EQ(value_term(Value(std::nan(""))).role, ui::Role::error);
}

TEST(MathOfTape, NamesBecomeSymbols) {
    EXPECT_EQ(symbol_of_name("n_x_A").sub, "A,x");
    EXPECT_EQ(symbol_of_name("u_x").role, ui::Role::u);
    EXPECT_EQ(symbol_of_name("x_l").role, ui::Role::text);
    EXPECT_EQ(markup_of_name("n_y_C"), "$n_{C,y}$");
    EXPECT_EQ(edge_of_name("E_B"), 1);
    EXPECT_EQ(edge_of_name("u_x"), -1);
    EXPECT_EQ(corner_of_name("x_12"), 12);
    EXPECT_EQ(corner_of_name("x_l"), -1);
}

TEST(MathOfTape, RationalsAreWrittenInFullWhereFourDecimalsDo) {
    const ui::Number fifth = shown_number(Value(Exact(1) / Exact(5))), third = shown_number(Value(Exact(1) / Exact(3)));
    EXPECT_EQ(fifth.text, "0.2");
    EXPECT_TRUE(fifth.exact);
    EXPECT_EQ(third.text, "0.3333");
    EXPECT_FALSE(third.exact);
}

}  // namespace
}  // namespace texelscope
