#include <gtest/gtest.h>

#include <set>

#include "core/method/run.h"
#include "tests/core/method/cases.h"

namespace texelscope::registry_test {
namespace {

TEST(Registry, HasEveryMethod) {
    for (const char* id :
         {"edge-equations", "sections", "edge-walk", "barycentric", "forward", "backward-affine", "backward-projective",
          "constant-z", "two-pass", "subdivided", "sampling-1d", "exact", "fast"})
        EXPECT_NE(find_method(id), nullptr) << id;
}

TEST(Registry, IsInOrderOfIdsAndFindsThem) {
    for (std::size_t n = 0; n < methods().size(); ++n) {
        const Method& method = *methods()[n];
        if (n > 0) {
            EXPECT_LT(methods()[n - 1]->id, method.id);
        }
        EXPECT_EQ(find_method(method.id), &method);
    }
    EXPECT_EQ(find_method("no such method"), nullptr);
}

TEST(Registry, MethodsAreComplete) {
    for (const Method* method : methods()) {
        EXPECT_FALSE(method->id.empty() || method->title.empty() || method->source.empty()) << method->id;
        EXPECT_TRUE(method->render && method->samples && method->until && method->visit) << method->id;
        std::set<std::string_view> fields, ids;
        for (const QuirkInfo& quirk : method->quirks) {
            EXPECT_TRUE(fields.insert(quirk.field).second && ids.insert(quirk.id).second)
                << method->id << ": " << quirk.field;
        }
    }
}

/// The four functions of a method agree in every number type on what became of a shape.
TEST(Registry, EveryMethodRunsWithEveryNumberType) {
    for (const laws::Case& c : laws::every_case()) {
        const Scene scene = laws::random_scene(8);
        const Drawing drawing(scene, c.settings);
        for (int n = 0; n < drawing.shape_count(); ++n) {
            const Job job = drawing.job(n);
            const Method& method = *c.settings.method;
            Image picture(job.frame.width(), job.frame.height());
            const Fate fate = method.render(c.settings.format, job, picture);
            EXPECT_EQ(fate, method.samples(c.settings.format, job, {job.frame, 1}, [](const Sample&) {})) << c.text();
            EXPECT_EQ(fate, method.visit(c.settings.format, job, Path{{{'t', n}}}).shape_fate) << c.text();
            EXPECT_FALSE(method.until(c.settings.format, job, {job.frame, 1}, {}, [](const Sample&) {}).empty())
                << c.text();
        }
    }
}

TEST(Registry, WithTypeGivesEachFormatItsOwnType) {
    const auto name = [](NumberFormat format) {
        return run::with_type(format, [](auto type) {
            using T = decltype(type);
            static_assert(Real<T> && Real<Recorded<T>>);
            if constexpr (std::same_as<T, double>)
                return "f64";
            else if constexpr (std::same_as<T, float>)
                return "f32";
            else if constexpr (std::same_as<T, Fixed16>)
                return "fx16.16";
            else if constexpr (std::same_as<T, Fixed8>)
                return "fx8.8";
            else
                return "exact";
        });
    };
    for (const NumberFormatInfo& format : kNumberFormats) {
        EXPECT_EQ(name(format.format), format.id);
        EXPECT_EQ(number_format(format.id), format.format);
    }
    EXPECT_FALSE(number_format("f16"));
}

}  // namespace
}  // namespace texelscope::registry_test
