#include "study/densities.h"

#include <gtest/gtest.h>

#include "study/cases.h"
#include "study/fixed_lines.h"

namespace bead {
namespace {

constexpr Vec2 part_size{40, 12};

Layout walls_and_pads(const LoadCase& load_case) {
    Layout fixed = wall_lines(load_case.part, load_case.print.bead_width, load_case.print.walls);
    for (LayoutLine& pad : pad_lines(load_case, load_case.print.walls)) fixed.push_back(pad);
    return fixed;
}

Densities solved(const LoadCase& load_case, double area, int iterations = 20) {
    return densities(load_case, walls_and_pads(load_case),
                     {.area = area, .iterations = iterations});
}

double total(const Densities& d) {
    double sum = 0;
    for (double y = 0.25; y < part_size.y; y += 0.5)
        for (double x = 0.25; x < part_size.x; x += 0.5)
            sum += 0.25 * (d.density[0]({x, y}) + d.density[1]({x, y}));
    return sum;
}

TEST(Densities, SpendWhatTheyMay) {
    const LoadCase part = cantilever_case(part_size);
    for (const double area : {80.0, 160.0}) {
        const Densities d = solved(part, area);
        EXPECT_NEAR(total(d), area, 0.05 * area);
        for (const Sampled<double>& family : d.density)
            for (const double r : family.values) EXPECT_TRUE(r >= 0.0199 && r <= 1 + 1e-9);
    }
}

// More at the clamp than at the tip, and along the edges more than in the middle.
TEST(Densities, LieWhereThePartIsStressed) {
    const Densities d = solved(cantilever_case(part_size), 120);
    const auto both = [&](Vec2 p) { return d.density[0](p) + d.density[1](p); };
    EXPECT_GT(both({6, 10}), 2 * both({34, 10}));
    EXPECT_GT(both({6, 10}), 1.3 * both({6, 6}));
    // Above in tension along the bar, below in compression.
    EXPECT_GT(std::abs(std::cos(principal(d.frame({12, 10})).angle)), 0.95);
    EXPECT_LT(std::abs(std::cos(principal(d.frame({12, 2})).angle)), 0.3);
}

TEST(Densities, MoreBeadIsStiffer) {
    const LoadCase part = cantilever_case(part_size);
    EXPECT_LT(solved(part, 160).work, solved(part, 80).work);
    EXPECT_GT(solved(part, 80, 1).work, solved(part, 80, 20).work);
}

TEST(Densities, DoNotCareForTheLoadsSize) {
    const Densities light = solved(cantilever_case(part_size, {0, -1}), 100);
    const Densities heavy = solved(cantilever_case(part_size, {0, -1000}), 100);
    for (std::size_t i = 0; i < light.density[0].values.size(); ++i)
        EXPECT_NEAR(light.density[0].values[i], heavy.density[0].values[i], 1e-6);
}

// For a load that may come from two sides there is something for both.
TEST(Densities, HeedEveryVariant) {
    LoadCase part = cantilever_case(part_size, {20, 0});
    const Densities straight = solved(part, 100);
    part.situations[0].loads[0].turn = 0.5;
    const Densities turned = solved(part, 100);
    const auto lean = [](const Densities& d) { return d.density[0]({6, 10}); };
    EXPECT_GT(lean(turned), 1.2 * lean(straight));
}

TEST(Densities, SpendLessOnCompressionWhereItBearsMore) {
    const LoadCase part = cantilever_case(part_size);
    const auto below = [&](double compression) {
        return densities(part, walls_and_pads(part),
                         {.area = 120, .iterations = 20, .compression = compression})
            .density[1]({12, 2});
    };
    EXPECT_LT(below(1.5), 0.95 * below(1));
    SolidMaterial ductile;
    ductile.compressive = ductile.tensile;
    EXPECT_DOUBLE_EQ(allowed_compression(ductile), 1);
    ductile.compressive = 1.5 * ductile.tensile;
    EXPECT_DOUBLE_EQ(allowed_compression(ductile), 1.25);
}

// Where solid is not enough, what is solid grows: more iterations, more of it at the clamp.
TEST(Densities, GrowWhereSolidIsNotEnough) {
    const LoadCase part = cantilever_case(part_size);
    const auto near_clamp = [&](int iterations) {
        const Densities d = solved(part, 160, iterations);
        double sum = 0;
        for (double y = 0.5; y < part_size.y; ++y)
            for (double x = 4.5; x < 10; ++x) sum += d.density[0]({x, y}) + d.density[1]({x, y});
        return sum;
    };
    EXPECT_GT(near_clamp(40), 1.02 * near_clamp(6));
}

}  // namespace
}  // namespace bead
