// The table of variables: what each name stands for at a step, and nothing that is computed later.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "tests/app/state/fixture.h"

namespace texelscope {
namespace {

std::unique_ptr<Store> at(const std::string& method, const std::string& variant, const std::string& step, Level level) {
    auto store = std::make_unique<Store>(opened(quad_document(), State{}));
    store->dispatch(action::SetMethod{method});
    store->dispatch(action::SetVariant{variant});
    store->dispatch(action::SetLevel{level});
    store->dispatch(action::StepTo{*parse_path(step)});
    return store;
}

std::map<std::string, Value> values(Store& store) {
    std::map<std::string, Value> values;
    for (const Variable& v : store.derived().variables()) {
        EXPECT_TRUE(values.emplace(v.name, v.value).second) << v.name << " is listed twice";
        const Tape& tape = store.derived().visit().tape;
        const Named& named = tape.names[static_cast<std::size_t>(v.named)];
        EXPECT_EQ(named.line, v.line) << v.name;
        EXPECT_EQ(full_text(tape.operations[static_cast<std::size_t>(named.operation)].value), full_text(v.value));
    }
    return values;
}

/// The same names at the last expression of a stage.
std::map<std::string, Value> values_at_end(const std::string& method, const std::string& variant,
                                           const std::string& unit) {
    const auto store = at(method, variant, unit, Level::stage);
    const std::size_t count = store->derived().visit().unit().expressions.size();
    store->dispatch(action::SetLevel{Level::expression});
    store->dispatch(action::StepTo{*parse_path(unit + "/e" + std::to_string(count - 1))});
    return values(*store);
}

TEST(Variables, ANameGivenTwiceStandsForItsLastValue) {
    for (const std::string shape : {"t0", "t1"}) {
        const auto store = at("edge-equations", "corrected", shape + "/s3", Level::stage);
        const Tape& tape = store->derived().visit().tape;
        const auto own = store->derived().visit().unit().expressions;
        const auto shown = values(*store);
        bool twice = false;
        for (const std::int32_t n : own) {
            const std::string name = tape.names[static_cast<std::size_t>(n)].name.text();
            const auto last = std::find_if(own.rbegin(), own.rend(), [&](std::int32_t m) {
                return tape.names[static_cast<std::size_t>(m)].name.text() == name;
            });
            twice |= *last != n;
            const std::int32_t operation = tape.names[static_cast<std::size_t>(*last)].operation;
            EXPECT_EQ(full_text(shown.at(name)), full_text(tape.operations[static_cast<std::size_t>(operation)].value))
                << shape << ' ' << name;
        }
        EXPECT_TRUE(twice) << "no name is given twice: nothing is tested";
    }
}

TEST(Variables, ARowsEndsAreTheRoundedOnesOnceTheyAre) {
    const auto shown = values(*at("sections", "as-printed", "t0/s1/y4", Level::scanline));
    EXPECT_EQ(approximate(shown.at("x_l")), approximate(shown.at("first")));
    EXPECT_EQ(approximate(shown.at("x_r")), approximate(shown.at("last")));
}

TEST(Variables, AStageKnowsNothingOfLaterOnes) {
    const auto known = [](const std::string& step, Level level) {
        return values(*at("edge-equations", "corrected", step, level));
    };
    const auto delta = known("t0/s0", Level::stage);
    EXPECT_TRUE(delta.contains("Δ"));
    for (const std::string later : {"u_x", "v_x", "n_x_A", "owns_C", "k_C", "x_max", "x_a"})
        EXPECT_FALSE(delta.contains(later)) << later;
    EXPECT_FALSE(known("t0/s3", Level::stage).contains("x_a"));
    EXPECT_TRUE(known("t0/s4", Level::stage).contains("x_a"));
    EXPECT_TRUE(known("t0/s5", Level::stage).contains("x_a"));
    EXPECT_TRUE(known("t0", Level::triangle).contains("x_a"));
}

TEST(Variables, AStageKnowsWhatItsLastExpressionDoes) {
    for (const std::string stage : {"t0/s0", "t0/s1", "t0/s2", "t0/s3", "t0/s4"}) {
        const auto at_stage = values(*at("edge-equations", "corrected", stage, Level::stage));
        EXPECT_EQ(at_stage, values_at_end("edge-equations", "corrected", stage)) << stage;
    }
}

TEST(Variables, ARowKnowsNothingOfTheNextSection) {
    const auto store = at("sections", "as-printed", "t0/s1/y4", Level::scanline);
    const auto first = values(*at("sections", "as-printed", "t0/s1", Level::stage));
    EXPECT_EQ(full_text(values(*store).at("y_beg")), full_text(first.at("y_beg")));
    EXPECT_EQ(full_text(values(*store).at("last_row")), full_text(first.at("last_row")));
}

TEST(Variables, APinnedNameOfALaterStageIsNotShown) {
    const auto store = at("edge-equations", "corrected", "t0/s0", Level::stage);
    store->dispatch(action::Pin{{.kind = Selection::Kind::name, .name = "x_max"}});
    ASSERT_NE(store->derived().named(), nullptr);
    EXPECT_EQ(store->derived().named()->name.text(), "Δ");
}

TEST(Variables, WhatAStageMakesHasChanged) {
    const auto store = at("edge-equations", "corrected", "t0/s4", Level::stage);
    for (const Variable& v : store->derived().variables()) EXPECT_EQ(v.changed, v.own) << v.name;
}

}  // namespace
}  // namespace texelscope
