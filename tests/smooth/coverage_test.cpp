#include "smooth/coverage.h"

#include <gtest/gtest.h>

#include "smooth/bead_plan.h"
#include "smooth/chord_error.h"
#include "smooth/engine_block.h"
#include "smooth/segment_lattice.h"
#include "smooth/sliced_section.h"
#include "support/regions.h"

namespace bead {
namespace {

TEST(Coverage, of_a_square_that_is_walled_plainly_lacks_nothing) {
    const Region square = test::square(20);
    const Coverage coverage = wall_coverage(sliced_section(square), square, 1.2);
    EXPECT_NEAR(coverage.band, 400 - 17.6 * 17.6, 1e-6);
    EXPECT_NEAR(coverage.underfill, 0, 1e-6);
    EXPECT_NEAR(coverage.overfill, 0, 1e-6);
    EXPECT_NEAR(coverage.outside, 0, 1e-6);
    EXPECT_NEAR(coverage.outline_deviation, 0, 6e-3);
}

TEST(Coverage, tells_gaps_overlaps_and_what_sticks_out) {
    const Region square = test::square(20);
    Toolpath layer = sliced_section(square);
    for (Path& path : layer)
        if (path.role == Role::outer_wall) path.bead.width += 0.1;
    const Coverage wide = wall_coverage(layer, square, 1.2);
    const double side = 19.6;  // of the outer wall's middle
    EXPECT_NEAR(wide.outside, std::pow(side + 0.5, 2) - 400, 1e-4);
    EXPECT_NEAR(wide.overfill, 4 * side * 0.5 - (std::pow(side + 0.5, 2) - 19.2 * 19.2), 1e-6);
    EXPECT_NEAR(wide.outline_deviation, 0.05 * std::sqrt(2.0), 6e-3);

    std::erase_if(layer, [](const Path& path) { return path.role == Role::outer_wall; });
    const Coverage bare = wall_coverage(layer, square, 1.2);
    EXPECT_NEAR(bare.underfill, 400 - 19.2 * 19.2, 1e-6);
}

TEST(Coverage, wider_beads_cover_the_engine_blocks_walls_as_well) {
    for (const int height : engine_block_heights) {
        const Region section = engine_block(height);
        const Toolpath plain = sliced_section(section);
        const Coverage before = wall_coverage(plain, section, 1.2);
        const Coverage after = wall_coverage(bead_planned(plain), section, 1.2);
        EXPECT_LT(before.underfill, 0.001 * before.band);
        // 15 %: where slots cut into bores third loops have grown together, and two become one.
        EXPECT_LT(after.underfill, 0.003 * before.band);
        EXPECT_LT(after.overfill, 0.003 * before.band);
        EXPECT_LT(after.outside, 1e-3);
        EXPECT_NEAR(after.outline_deviation, before.outline_deviation, 1e-6);
    }
}

TEST(ChordError, of_a_polygon_from_its_circle_is_known) {
    Path path{.role = Role::outer_wall, .bead = {0.4, 0.2}, .speed = 50, .points = {}};
    for (const Vec2 p : test::regular({}, 4, 24)) path.points.push_back(at_height(p, 0.2));
    path.points.push_back(path.points.front());
    const auto circle = boundary_curves(test::disc({}, 4, 4800));
    EXPECT_NEAR(chord_error({path}, Role::outer_wall, circle), 4 * (1 - std::cos(pi / 24)), 5e-4);
    EXPECT_EQ(chord_error({path}, Role::wall, circle), 0);
}

TEST(SegmentLattice, finds_what_looking_at_all_finds) {
    for (unsigned seed = 0; seed < 30; ++seed) {
        test::RandomRegions random(seed);
        const Region region = random.any();
        if (region.empty()) continue;
        const SegmentLattice near(boundary_curves(region), random.uniform(0.3, 5));
        for (int i = 0; i < 50; ++i) {
            const Vec2 p = random.point(60);
            ASSERT_NEAR(near.distance_to(p), boundary_distance(region, p), 1e-9);
        }
    }
}

}  // namespace
}  // namespace bead
