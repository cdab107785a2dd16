// Every value on a tape is what its operation says, and what its printed formula says, in every number type.
#include "core/trace/expression.h"

#include <gtest/gtest.h>

#include "core/method/steps.h"
#include "tests/cases.h"
#include "tests/core/method/cases.h"
#include "tests/core/trace/evaluate.h"

namespace texelscope::expression_test {
namespace {

using laws::Case;

Value real_like(NumberFormat format) {
    switch (format) {
        case NumberFormat::f32: return 0.0F;
        case NumberFormat::fx16_16: return Fixed16{};
        case NumberFormat::fx8_8: return Fixed8{};
        case NumberFormat::exact: return Exact{};
        case NumberFormat::f64: break;
    }
    return 0.0;
}

/// Calls `check` on visits all over the step tree: every stage, row and expression's unit, and one pixel in seven.
void for_visits(const Case& c, const Scene& scene, const std::function<void(const Visit&)>& check) {
    const Drawing drawing(scene, c.settings);
    Steps steps(drawing);
    for (const Level level : {Level::stage, Level::scanline, Level::pixel}) {
        int n = 0;
        for (auto path = steps.first(level); path; path = steps.next(*path, level)) {
            if (level != Level::pixel || n++ % 7 == 0) check(steps.at(*path));
            if (testing::Test::HasFailure()) return;
        }
    }
}

void check_operations(const Visit& visit) {
    for (std::size_t n = 0; n < visit.tape.operations.size(); ++n) {
        const Operation& o = visit.tape.operations[n];
        for (const std::int32_t operand : {o.a, o.b, o.c}) ASSERT_LT(operand, static_cast<std::int32_t>(n));
        const Value again = laws::evaluated(visit.tape, o);
        ASSERT_TRUE(laws::same_value(again, o.value))
            << visit.path.text() << ", operation " << n << " " << symbol_of(o.op) << ": " << full_text(o.value)
            << ", again " << full_text(again);
        ASSERT_EQ(overflowed(again), overflowed(o.value)) << visit.path.text() << ", operation " << n;
    }
}

TEST(Tape, EachOperationEvaluatedAgainGivesItsValue) {
    for (Case c : laws::every_case()) {
        for (const Overflow overflow : {Overflow::mark, Overflow::saturate, Overflow::wrap}) {
            c.settings.mode = {overflow, overflow == Overflow::wrap};
            for (unsigned seed = 1; seed <= cases(7, 3); ++seed) {
                SCOPED_TRACE(c.text() + ", random_scene(" + std::to_string(seed) + ")");
                for_visits(c, laws::random_scene(seed), check_operations);
                if (HasFailure()) return;
            }
            const bool fixed = c.settings.format == NumberFormat::fx16_16 || c.settings.format == NumberFormat::fx8_8;
            if (!fixed) break;
        }
    }
}

void check_text(const Visit& visit, const Named& named, const std::string& text, const Value& real) {
    const Value& value = visit.tape.operations[static_cast<std::size_t>(named.operation)].value;
    std::string error;
    const Value again = laws::evaluated_text(visit.tape, text, named.operation, value, real, error);
    ASSERT_EQ(error, "") << visit.path.text() << ": " << named.name.text() << " = " << text;
    ASSERT_TRUE(laws::same_value(again, value)) << visit.path.text() << ": " << named.name.text() << " = " << text
                                                << " is " << full_text(value) << ", parsed " << full_text(again);
}

TEST(Expression, TheFormulaParsedAndEvaluatedGivesTheValue) {
    for (const Case& c : laws::every_case()) {
        for (unsigned seed = 1; seed <= cases(14, 7); ++seed) {
            SCOPED_TRACE(c.text() + ", random_scene(" + std::to_string(seed) + ")");
            const Scene scene = laws::random_scene(seed);
            const Value real = real_like(Drawing(scene, c.settings).settings().format);
            for_visits(c, scene, [&](const Visit& visit) {
                for (const std::int32_t n : visit.unit().expressions) {
                    const Named& named = visit.tape.names[static_cast<std::size_t>(n)];
                    check_text(visit, named, formula(visit.tape, named), real);
                    check_text(visit, named, substituted(visit.tape, named), real);
                }
            });
            if (HasFailure()) return;
        }
    }
}

TEST(Expression, BracketsStandWhereTheOrderNeedsThem) {
    TapeWriter writer;
    const auto input = [&](double value, Name name) {
        const std::int32_t leaf = writer.tape.push(Op::input, value);
        writer.tape.names.push_back({leaf, name, 1, false});
        return Recorded<double>(value, &writer, leaf);
    };
    const auto a = input(2, "a"), b = input(-3, "b"), c = input(5, {"c", 0});
    const auto text = [&](const Recorded<double>& x) { return formula(writer.tape, {x.operation(), "r", 1, false}); };
    EXPECT_EQ(text(a - (b - c)), "a - (b - c_0)");
    EXPECT_EQ(text(a - b - c), "a - b - c_0");
    EXPECT_EQ(text((a + b) * c), "(a + b) * c_0");
    EXPECT_EQ(text(a + b * c), "a + b * c_0");
    EXPECT_EQ(text(a / (b * c)), "a / (b * c_0)");
    EXPECT_EQ(text(-(a + b)), "-(a + b)");
    EXPECT_EQ(text(lesser(a, b)), "lesser(a, b)");
    EXPECT_EQ(substituted(writer.tape, {(a * b).operation(), "r", 1, false}), "2 * (-3)");
}

}  // namespace
}  // namespace texelscope::expression_test
