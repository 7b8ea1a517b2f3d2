// What finds lines by place, against looking at all of them.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "geom/deviation.h"
#include "smooth/cell_table.h"
#include "smooth/neighbourhood.h"
#include "smooth/segment_grid.h"
#include "smooth/segment_lattice.h"

namespace bead {
namespace {

class RandomLines {
  public:
    explicit RandomLines(unsigned seed) : random_(seed) {}

    double uniform(double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random_);
    }
    Vec2 point() { return {uniform(-30, 30), uniform(-20, 20)}; }
    // A few short lines and a long one.
    std::vector<Polyline> lines(std::size_t count) {
        std::vector<Polyline> result;
        for (std::size_t i = 0; i < count; ++i) {
            Polyline line{point()};
            const double step = i == 0 ? 30 : 4;
            const auto points = 2 + static_cast<int>(uniform(0, 6));
            for (int k = 0; k < points; ++k)
                line.push_back(line.back() + Vec2{uniform(-step, step), uniform(-step, step)});
            result.push_back(std::move(line));
        }
        return result;
    }

  private:
    std::mt19937 random_;
};

std::vector<SegmentGrid::Line> open(const std::vector<Polyline>& lines) {
    std::vector<SegmentGrid::Line> result;
    for (const Polyline& line : lines) result.push_back({line, false});
    return result;
}

TEST(CellTable, holds_every_number_in_its_cell_in_the_order_given) {
    const std::vector<CellEntry> entries{{2, 7}, {0, 3}, {2, 1}, {3, 9}, {0, 3}};
    const CellTable table = sorted_by_cell(entries, 4);
    const auto numbers = [&](std::size_t first, std::size_t last) {
        const auto found = table.in(first, last);
        return std::vector<std::uint32_t>(found.begin(), found.end());
    };
    EXPECT_EQ(numbers(0, 0), (std::vector<std::uint32_t>{3, 3}));
    EXPECT_TRUE(numbers(1, 1).empty());
    EXPECT_EQ(numbers(2, 3), (std::vector<std::uint32_t>{7, 1, 9}));
    EXPECT_TRUE(sorted_by_cell({}, 3).in(0, 2).empty());
}

TEST(Neighbourhood, misses_no_loop_within_reach) {
    for (unsigned seed = 0; seed < 40; ++seed) {
        RandomLines random(seed);
        const std::vector<Polyline> loops = random.lines(9);
        std::vector<const Polyline*> borrowed;
        for (const Polyline& loop : loops) borrowed.push_back(&loop);
        const double reach = random.uniform(0.3, 5);
        const Neighbourhood near(borrowed, reach);
        for (int k = 0; k < 60; ++k) {
            const Vec2 point = random.point();
            const auto found = near.around(point);
            EXPECT_TRUE(std::ranges::is_sorted(found));
            for (std::size_t i = 0; i < loops.size(); ++i) {
                Polyline closed = loops[i];
                closed.push_back(closed.front());
                const double away = line_distance(closed, point);
                const bool is_there = std::ranges::find(found, i) != found.end();
                EXPECT_TRUE(is_there || away > reach) << seed << " " << away;
                EXPECT_FALSE(is_there && away > 4 * reach) << seed << " " << away;
            }
        }
    }
}

TEST(SegmentGrid, finds_what_looking_at_all_finds) {
    for (unsigned seed = 0; seed < 40; ++seed) {
        RandomLines random(seed);
        const std::vector<Polyline> lines = random.lines(8);
        const double reach = random.uniform(0.5, 6);
        const SegmentGrid grid(open(lines), reach, seed % 2 == 0 ? 0 : reach / 3);
        for (int k = 0; k < 60; ++k) {
            const Vec2 point = random.point();
            const std::vector<NearLine> near = grid.near(point);
            std::size_t next = 0;
            double nearest_but_first = 1e9;
            for (std::size_t i = 0; i < lines.size(); ++i) {
                const double away = line_distance(lines[i], point);
                if (i > 0) nearest_but_first = std::min(nearest_but_first, away);
                if (away > reach) continue;
                ASSERT_LT(next, near.size());
                EXPECT_EQ(near[next].line, i);
                EXPECT_NEAR(near[next++].distance, away, 1e-9);
            }
            EXPECT_EQ(next, near.size());
            const auto other = grid.nearest_other(point, 0);
            ASSERT_EQ(other.has_value(), nearest_but_first <= reach);
            EXPECT_NEAR(other.value_or(nearest_but_first), nearest_but_first, 1e-9);
        }
    }
}

TEST(SegmentGrid, knows_what_is_clear_of_all_lines_but_two) {
    for (unsigned seed = 0; seed < 40; ++seed) {
        RandomLines random(seed);
        const std::vector<Polyline> lines = random.lines(5);
        const SegmentGrid grid(open(lines), 3);
        for (int k = 0; k < 60; ++k) {
            const Vec2 point = random.point();
            const double distance = random.uniform(0, 3);
            bool clear = true;
            for (const std::size_t i : {1U, 2U, 4U})
                clear = clear && line_distance(lines[i], point) >= distance;
            EXPECT_EQ(grid.is_clear(point, distance, {0, 3}), clear) << seed;
        }
    }
}

bool is_crossed(const std::vector<Polyline>& lines, Vec2 a, Vec2 b) {
    const auto side = [](Vec2 from, Vec2 to, Vec2 p) { return cross(to - from, p - from); };
    for (const Polyline& line : lines)
        for (std::size_t i = 1; i < line.size(); ++i) {
            const Vec2 c = line[i - 1], d = line[i];
            if (side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0) return true;
        }
    return false;
}

TEST(SegmentGrid, knows_what_a_segment_crosses) {
    for (unsigned seed = 0; seed < 40; ++seed) {
        RandomLines random(seed);
        const std::vector<Polyline> lines = random.lines(4);
        const SegmentGrid grid(open(lines), 1);
        for (int k = 0; k < 80; ++k) {
            const Vec2 a = random.point(),
                       b = k % 2 == 0 ? random.point()
                                      : a + Vec2{random.uniform(-2, 2), random.uniform(-2, 2)};
            EXPECT_EQ(grid.is_crossed(a, b), is_crossed(lines, a, b)) << seed;
        }
    }
}

TEST(SegmentLattice, knows_the_farthest_of_many_places) {
    for (unsigned seed = 0; seed < 40; ++seed) {
        RandomLines random(seed);
        const std::vector<Polyline> lines = random.lines(6);
        const SegmentLattice lattice(lines, random.uniform(0.3, 4));
        const Polyline places = places_along(random.lines(1)[0], 0.5);
        double farthest = 0;
        for (const Vec2 place : places) farthest = std::max(farthest, lattice.distance_to(place));
        EXPECT_NEAR(lattice.farthest(places), farthest, 1e-9);
        EXPECT_EQ(lattice.farthest(places, 1e3), 1e3);
        EXPECT_NEAR(lattice.farthest(places, farthest / 2), farthest, 1e-9);
    }
    EXPECT_EQ(SegmentLattice({}).farthest({}, 2), 2);
    EXPECT_EQ(SegmentLattice({}).farthest({Vec2{1, 1}}), std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace bead
