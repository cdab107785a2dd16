#include "app/state/link.h"

#include <gtest/gtest.h>

#include "app/state/store.h"
#include "tests/app/state/fixture.h"

namespace texelscope {
namespace {

State changed_state() {
    Store store(opened(quad_document(), State{}));
    store.dispatch(action::SetFormat{NumberFormat::fx8_8});
    store.dispatch(action::SetMode{{Overflow::wrap, true}});
    store.dispatch(action::MoveVertex{{0, 1, false}, {20.0625F, 1.0F / 3}, 1});
    store.dispatch(action::MoveVertex{{0, 3, true}, {-7.1e-9F, 1e6F}, 2});
    store.dispatch(action::SetQuirk{0, true});
    store.dispatch(action::SetSizeTwice{true});
    store.dispatch(action::StepTo{*parse_path("t0/s5/y9/x12/e3")});
    State state = store.state();
    state.work.answers.push_back({.beat = 2,
                                  .chosen = {0, 3},
                                  .typed = "-16,6 %",
                                  .places = {{4, 5}, {-1, 7}},
                                  .verdict = Answer::Verdict::wrong});
    state.work.texture_file = "a b;c=d.png";
    state.look.other = {"edge-equations", "as-published", NumberFormat::fx8_8};
    state.look.difference = true;
    return state;
}

TEST(Link, ParsesBackToTheSameState) {
    const State state = changed_state();
    const auto link = parse_link(print_link(state));
    ASSERT_TRUE(link) << link.error().text();
    EXPECT_EQ(link->document, state.document->id);
    EXPECT_EQ(link->cursor, state.cursor);
    EXPECT_EQ(link->work, state.work);
    EXPECT_EQ(link->other, state.look.other);
    EXPECT_TRUE(link->difference);
}

TEST(Link, IsOnePrintableLine) {
    for (const char c : print_link(changed_state())) EXPECT_TRUE(c > ' ' && c < 127) << static_cast<int>(c);
}

TEST(Link, EveryDamagedCharacterIsNoticed) {
    const std::string good = print_link(changed_state());
    for (std::size_t n = 0; n < good.size(); ++n) {
        std::string bad = good;
        bad[n] = bad[n] == '7' ? '8' : '7';
        EXPECT_FALSE(parse_link(bad)) << bad;
        EXPECT_FALSE(parse_link(good.substr(0, n))) << n;
    }
}

TEST(Link, TellsWhatIsWrongInOneLine) {
    const auto link = parse_link("texelscope:1:nonsense");
    ASSERT_FALSE(link);
    EXPECT_EQ(link.error().text().find('\n'), std::string::npos);
    EXPECT_NE(link.error().text().find("damaged"), std::string::npos);
}

TEST(Link, NonsenseWithAGoodChecksumIsRefusedWithItsField) {
    State state = changed_state();
    state.work.method = "no-such-method";
    const auto link = parse_link(print_link(state));
    ASSERT_FALSE(link);
    EXPECT_NE(link.error().text().find("no-such-method"), std::string::npos);
}

}  // namespace
}  // namespace texelscope
