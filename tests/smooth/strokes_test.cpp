#include "smooth/strokes.h"

#include <gtest/gtest.h>

#include "smooth/engine_block.h"
#include "smooth/sliced_section.h"
#include "support/layer_sums.h"
#include "support/regions.h"

namespace bead {
namespace {

TEST(Strokes, taken_apart_and_put_together_a_layer_is_the_same) {
    for (unsigned seed = 0; seed < 40; ++seed) {
        const Toolpath layer = sliced_section(test::RandomRegions(seed).any());
        EXPECT_TRUE(test::is_same(joined(strokes_of(layer)), layer));
    }
}

TEST(Strokes, whatever_is_dropped_the_rest_stays_connected) {
    Strokes strokes = strokes_of(sliced_section(engine_block(75)));
    const std::size_t all = strokes.strokes.size();
    for (std::size_t i = all; i-- > 0;)
        if (i % 3 == 0)
            strokes.strokes.erase(strokes.strokes.begin() + static_cast<std::ptrdiff_t>(i));
    const Toolpath layer = joined(strokes);
    EXPECT_TRUE(test::is_connected(layer));
    EXPECT_EQ(strokes_of(layer).strokes.size(), strokes.strokes.size());
    for (const Path& path : layer)
        EXPECT_DOUBLE_EQ(path.speed, path.role == Role::travel   ? 120
                                     : path.role == Role::infill ? 60
                                                                 : 50);
}

TEST(Strokes, a_loop_keeps_its_length_and_begins_near_where_it_did) {
    const Toolpath layer = sliced_section(test::square(30));
    for (const Path& path : layer) {
        if (path.role == Role::travel) continue;
        ASSERT_TRUE(is_loop(path));
        const Path again = along_loop(path, loop_of(path));
        EXPECT_EQ(again.points, path.points);
    }
}

TEST(Strokes, width_and_section_undo_each_other) {
    for (const double width : {0.1, 0.2, 0.4, 0.8, 1.3})
        EXPECT_NEAR(width_for(section({width, 0.2}), 0.2), width, 1e-12);
}

// Figures of the specification's table, from another program: 15187 mm and 7365 points at 75 %.
TEST(EngineBlock, its_section_at_75_percent_is_as_long_as_published_for_the_stand_in) {
    const Toolpath layer = sliced_section(engine_block(75));
    double all = 0;
    std::size_t points = 0;
    for (const Path& path : layer) {
        all += length(path);
        points += path.points.size() - 1;
    }
    EXPECT_NEAR(all, 15'187, 0.01 * 15'187);
    EXPECT_NEAR(static_cast<double>(points), 7365, 10);
}

TEST(EngineBlock, has_41_round_holes_or_slots_that_open_into_them) {
    const auto holes = [](int height) {
        std::size_t count = 0;
        for (const Polygon& polygon : engine_block(height)) count += polygon.holes.size();
        return count;
    };
    EXPECT_EQ(holes(75), 41U);
    EXPECT_EQ(holes(15), 35U);  // each oil slot opens into four bores
    EXPECT_EQ(holes(25), holes(50));
}

}  // namespace
}  // namespace bead
