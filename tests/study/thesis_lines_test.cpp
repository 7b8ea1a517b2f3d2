#include "study/thesis_lines.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "geom/clip.h"
#include "geom/line_index.h"
#include "study/cases.h"
#include "study/fixed_lines.h"
#include "study/stress_field.h"

namespace bead {
namespace {

constexpr Vec2 short_beam{48, 15};
constexpr ThesisSeeds all_seeds[] = {ThesisSeeds::edges, ThesisSeeds::even, ThesisSeeds::stress};

double asked(const LoadCase& load_case) { return load_case.print.fill * area(load_case.part); }

TEST(ThesisLines, WeighWhatTheCaseSays) {
    const LoadCase beam = beam_case(short_beam);
    for (const ThesisSeeds seeds : all_seeds)
        for (const int copies : {0, 4}) {
            const auto lines = thesis_lines(beam, {.seeds = seeds, .copies = copies});
            ASSERT_TRUE(lines);
            EXPECT_NEAR(lines->area, asked(beam), 0.005 * asked(beam))
                << int(seeds) << ' ' << copies;
            EXPECT_NEAR(lines->area, deposited_area(lines->layout, 0.6), 1e-9);
            EXPECT_EQ(lines->threshold > 0, copies > 0);
        }
}

// What is saved at crossings goes into more lines.
TEST(ThesisLines, WeighTheSameWithLessAtCrossings) {
    LoadCase beam = beam_case(short_beam);
    const auto whole = thesis_lines(beam, {.seeds = ThesisSeeds::even});
    beam.print.crossing_flow = 0.5;
    const auto thinned = thesis_lines(beam, {.seeds = ThesisSeeds::even});
    ASSERT_TRUE(whole && thinned);
    EXPECT_NEAR(thinned->area, asked(beam), 0.005 * asked(beam));
    EXPECT_NEAR(thinned->area, deposited_area(thinned->layout, beam.print), 1e-9);
    EXPECT_GT(deposited_area(thinned->layout, 0.6), 1.02 * deposited_area(whole->layout, 0.6));
}

TEST(ThesisLines, LieInsideTheWallsMiddle) {
    LoadCase part = cantilever_case(short_beam);
    part.part = difference(part.part, {{{{20, 5}, {28, 5}, {28, 10}, {20, 10}}, {}}});
    const auto lines = thesis_lines(part, {});
    ASSERT_TRUE(lines);
    const Region inside = offset(part.part, -0.3 + 1e-3);
    for (const LineKind kind : {LineKind::tensile, LineKind::compressive})
        for (const Polyline& line : lines_of(lines->layout, kind))
            EXPECT_TRUE(outside_parts({line}, inside).empty());
}

// Single lines go along the stress; both families are there.
TEST(ThesisLines, FollowTheStress) {
    const LoadCase part = cantilever_case(short_beam);
    const Sampled<PlaneTensor> stress = solid_stress(part, 0, 0.5);
    const auto lines = thesis_lines(part, {.seeds = ThesisSeeds::even, .copies = 0});
    ASSERT_TRUE(lines);
    for (const LineKind kind : {LineKind::tensile, LineKind::compressive}) {
        const std::vector<Polyline> family = lines_of(lines->layout, kind);
        EXPECT_FALSE(family.empty());
        for (const Polyline& line : family)
            for (std::size_t i = 1; i < line.size(); ++i) {
                const Vec2 way = line[i] - line[i - 1];
                const PlaneTensor t = stress(lerp(line[i], line[i - 1], 0.5));
                const double angle = principal(t).angle + (kind == LineKind::tensile ? 0 : pi / 2);
                EXPECT_LT(std::abs(cross(way, unit(angle))), 0.03);
            }
    }
}

// No point of the mirrored part's lines is far from the part's own.
TEST(ThesisLines, OfAMirroredPartAreMirrored) {
    const LoadCase part = cantilever_case(short_beam, {5, -20});
    LoadCase other = part;
    for (Situation& s : other.situations) {
        s.supports[0].on = {{short_beam.x, 0}, short_beam, {}};
        s.loads[0] = pull({0, 0}, {0, short_beam.y}, {-5, -20});
    }
    const auto lines = thesis_lines(part, {}), mirrored = thesis_lines(other, {});
    ASSERT_TRUE(lines && mirrored);
    EXPECT_NEAR(lines->area, mirrored->area, 1e-3 * lines->area);
    for (const LineKind kind : {LineKind::tensile, LineKind::compressive}) {
        std::vector<Polyline> turned = lines_of(mirrored->layout, kind);
        for (Polyline& line : turned)
            for (Vec2& p : line) p.x = short_beam.x - p.x;
        const std::vector<Polyline> own = lines_of(lines->layout, kind);
        EXPECT_EQ(own.size(), turned.size());
        const LineIndex near(own, 1.0);
        for (const Polyline& line : turned)
            for (const Vec2 p : line) EXPECT_TRUE(near.nearest(p, 0.1)) << p.x << ' ' << p.y;
    }
}

TEST(ThesisLines, AreThickerWhereMoreIsCarried) {
    const LoadCase part = cantilever_case({60, 12});
    const auto lines = thesis_lines(part, {});
    ASSERT_TRUE(lines);
    const auto length_in = [&](double from, double to) {
        double sum = 0;
        const Region box{{{{from, 0}, {to, 0}, {to, 12}, {from, 12}}, {}}};
        for (const LineKind kind : {LineKind::tensile, LineKind::compressive})
            for (const Polyline& piece : inside_parts(lines_of(lines->layout, kind), box))
                sum += length(piece);
        return sum;
    };
    EXPECT_GT(length_in(3, 18), 1.5 * length_in(42, 57));
}

TEST(ThesisLines, AreNoneWhereWallsTakeAll) {
    LoadCase part = cantilever_case(short_beam);
    part.print.fill = 0.05;
    EXPECT_FALSE(thesis_lines(part, {}));
}

TEST(ThesisLines, AreTheSameEachTime) {
    const LoadCase part = beam_case(short_beam);
    const auto once = thesis_lines(part, {.seeds = ThesisSeeds::stress});
    const auto again = thesis_lines(part, {.seeds = ThesisSeeds::stress});
    ASSERT_TRUE(once && again);
    ASSERT_EQ(once->layout.size(), again->layout.size());
    for (std::size_t i = 0; i < once->layout.size(); ++i)
        EXPECT_EQ(once->layout[i].points, again->layout[i].points);
}

TEST(SolidStress, OfABeamIsBeamTheorysAndReachesBeyondTheEdge) {
    const LoadCase part = cantilever_case({60, 10}, {0, -12});
    const Sampled<PlaneTensor> stress = solid_stress(part, 0, 0.5);
    const double inertia = 10.0 * 10 * 10 / 12 * 6;
    const PlaneTensor t = stress({30, 8});
    EXPECT_NEAR(t.xx, 12 * 30 * 3 / inertia, 0.02 * 12 * 30 * 3 / inertia);
    EXPECT_NEAR(t.xy, -12 / (2 * inertia) * (25 - 9), 0.03);
    EXPECT_GT(stress({30, 9.9}).xx, t.xx);
}

}  // namespace
}  // namespace bead
