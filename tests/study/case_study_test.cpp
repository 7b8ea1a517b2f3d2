#include "study/case_study.h"

#include <gtest/gtest.h>

#include "geom/polygon.h"

namespace bead {
namespace {

TEST(CaseStudy, TheStandInIsOnePieceWithFourOpenings) {
    const Region part = bracket_outline();
    ASSERT_EQ(part.size(), 1U);
    EXPECT_EQ(part.front().holes.size(), 4U);
    const Box2 box = bounds(part);
    EXPECT_GT(box.high.x - box.low.x, box.high.y - box.low.y);  // longest along X
}

// Two patterns of which one falls and one rises with the angle; the rest is missing.
TEST(CaseStudy, CountsWhatTheThesisConcludes) {
    std::vector<BracketRun> runs;
    for (const int angle : {0, 45, 90}) {
        const double bump = angle == 45 ? 5 : 0;
        runs.push_back({{Shape::square, 0, angle, 0}, 10 - angle / 90.0 + bump});
        runs.push_back({{Shape::square, 1, angle, 0}, 12 + angle / 90.0 + bump});
        if (angle == 0) continue;
        runs.push_back({{Shape::square, 0, 0, angle}, 11});
        runs.push_back({{Shape::square, 1, 0, angle}, 11});
    }
    const BracketFindings found = bracket_findings(runs);
    EXPECT_EQ(found.patterns, 2);
    EXPECT_EQ(found.diagonal_worse, 2);
    EXPECT_EQ(found.ninety_better, 1);
    EXPECT_EQ(found.part_0_lowest, 1);
    EXPECT_EQ(found.set_ups, 0);
    EXPECT_EQ(found.best.infill_angle, 90);
    EXPECT_NEAR(found.below_worst, 1 - 9 / 17.5, 1e-12);
    EXPECT_NEAR(found.below_usual, 1 - 9 / 14.5, 1e-12);
}

TEST(CaseStudy, GivesTheSameForAnyNumberOfThreads) {
    const std::vector<ExperimentRun> runs{{Shape::square, 0, 45, 0}, {Shape::square, 3, 0, 90}};
    EXPECT_EQ(bracket_energies(runs, 1), bracket_energies(runs, 2));
}

}  // namespace
}  // namespace bead
