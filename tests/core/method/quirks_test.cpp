// Each quirk is a switch that can be seen, has its line of code, and belongs to what was printed.
#include <gtest/gtest.h>

#include <algorithm>

#include "core/trace/listing.h"
#include "tests/core/method/cases.h"

namespace texelscope::quirks_test {
namespace {

struct Named {
    std::string name;
    Scene scene;
};

std::vector<Named> scenes() {
    std::vector<Named> all;
    for (unsigned seed = 1; seed <= 40; ++seed)
        all.push_back({"random_scene(" + std::to_string(seed) + ")", laws::random_scene(seed)});
    all.push_back({"a long row in perspective", laws::steep_scene()});
    all.push_back({"far from the origin", laws::far_scene()});
    return all;
}

/// Pictures may agree where a sample is drawn twice: the samples tell.
bool differ(const Scene& scene, const DrawSettings& a, const DrawSettings& b) {
    return render(Drawing(scene, a)) != render(Drawing(scene, b));
}

/// Added to the corrected method, or taken from what was printed: some need another to be seen.
TEST(Quirks, EachChangesAPixelOfSomeScene) {
    const std::vector<Named> tried = scenes();
    for (const Method* method : methods()) {
        for (std::size_t n = 0; n < method->quirks.size(); ++n) {
            if (method->quirks[n].kind == QuirkKind::form) continue;
            const auto seen = [&](const Named& scene, NumberFormat format, QuirkSet others) {
                const QuirkSet quirk = QuirkSet{1} << n;
                return differ(scene.scene, laws::settings_of(*method, format, others | quirk),
                              laws::settings_of(*method, format, others & ~quirk));
            };
            const auto found = std::find_if(tried.begin(), tried.end(), [&](const Named& scene) {
                return seen(scene, NumberFormat::f64, 0) ||
                       seen(scene, NumberFormat::f64, quirks_of(*method, "as-printed")) ||
                       seen(scene, NumberFormat::f32, 0) || seen(scene, NumberFormat::fx8_8, 0);
            });
            ASSERT_NE(found, tried.end()) << method->id << ": " << method->quirks[n].field << " changes nothing";
            RecordProperty(std::string(method->id) + "_" + std::string(method->quirks[n].field), found->name);
        }
    }
}

TEST(Quirks, NoneIsTheCorrectedVariantAndAllAreWhatWasPrinted) {
    for (const Method* method : methods()) {
        QuirkSet faults = 0;
        for (std::size_t n = 0; n < method->quirks.size(); ++n)
            faults |= method->quirks[n].kind == QuirkKind::printed ? QuirkSet{1} << n : 0;
        ASSERT_FALSE(method->variants.empty()) << method->id;
        EXPECT_EQ(method->variants.back().id, "corrected") << method->id;
        EXPECT_EQ(quirks_of(*method, "corrected"), 0U) << method->id;
        EXPECT_EQ(quirks_of(*method, "no such variant"), 0U) << method->id;
        const VariantInfo* printed = find_variant(*method, "as-printed");
        if (printed != nullptr) {
            EXPECT_EQ(printed->quirks & ~laws::forms_of(*method), faults) << method->id;
        }
    }
}

TEST(Quirks, AFormDrawsTheSameSamplesInAnotherOrder) {
    const auto before = [](const std::pair<int, Sample>& a, const std::pair<int, Sample>& b) {
        return std::tuple(a.first, a.second.y, a.second.x) < std::tuple(b.first, b.second.y, b.second.x);
    };
    for (const laws::Case& c : laws::every_case()) {
        const QuirkSet forms = laws::forms_of(*c.settings.method);
        if (forms == 0 || (c.settings.quirks & forms) != 0) continue;
        for (unsigned seed = 1; seed <= 21; ++seed) {
            SCOPED_TRACE(c.text() + ", random_scene(" + std::to_string(seed) + ")");
            const Scene scene = laws::random_scene(seed);
            DrawSettings with = c.settings;
            with.quirks |= forms;
            const Drawing loop(scene, c.settings), form(scene, with);
            ASSERT_EQ(render(loop), render(form));
            auto a = laws::all_samples(loop, {scene.framebuffer.rect(), 1}),
                 b = laws::all_samples(form, {scene.framebuffer.rect(), 1});
            std::stable_sort(a.begin(), a.end(), before);
            std::stable_sort(b.begin(), b.end(), before);
            ASSERT_TRUE(std::equal(a.begin(), a.end(), b.begin(), b.end(),
                                   [](const auto& s, const auto& t) { return laws::same(s, t); }));
        }
    }
}

TEST(Quirks, EachHasItsLineInTheListing) {
    for (const Method* method : methods()) {
        const Listing listing = load_listing(method->listing);
        ASSERT_FALSE(listing.lines.empty()) << method->id << ": no listing " << method->listing;
        for (const QuirkInfo& quirk : method->quirks) {
            EXPECT_GT(guilty_line(listing, quirk), 0) << method->id << ": " << quirk.field;
            EXPECT_FALSE(quirk.title.empty() || quirk.sentence.empty() || quirk.id.empty())
                << method->id << ": " << quirk.field;
        }
    }
}

TEST(Quirks, AllTogetherInEveryCombinationDraw) {
    for (const Method* method : methods()) {
        for (QuirkSet quirks = 0; quirks < QuirkSet{1} << method->quirks.size(); ++quirks) {
            const Scene scene = laws::random_scene(quirks + 1);
            const Drawing drawing(scene, laws::settings_of(*method, NumberFormat::f32, quirks));
            const Image picture = render(drawing);
            ASSERT_EQ(picture.width(), scene.framebuffer.width);
            ASSERT_EQ(picture, render(drawing)) << method->id << ", quirks " << quirks;
        }
    }
}

}  // namespace
}  // namespace texelscope::quirks_test
