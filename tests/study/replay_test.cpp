#include "study/replay.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <set>

namespace bead {
namespace {

std::vector<double> random_values() {
    auto values = *rc::gen::container<std::vector<int>>(rc::gen::inRange(-1000, 1000));
    return {values.begin(), values.end()};
}

RC_GTEST_PROP(Spearman, KnowsOnlyTheOrder, ()) {
    const std::vector<double> values = random_values();
    RC_PRE(std::set<double>(values.begin(), values.end()).size() > 1);
    std::vector<double> bent, fallen;
    for (const double value : values) {
        bent.push_back(std::exp(value / 100));
        fallen.push_back(-value);
    }
    RC_ASSERT(std::abs(spearman(values, bent) - 1) < 1e-12);
    RC_ASSERT(std::abs(spearman(values, fallen) + 1) < 1e-12);
}

TEST(Spearman, SharesTheRanksOfEqualValues) {
    const std::vector<double> a{1, 2, 3, 4}, b{10, 20, 20, 40};
    EXPECT_NEAR(spearman(a, b), 4.5 / std::sqrt(5 * 4.5), 1e-12);
    EXPECT_EQ(spearman(a, std::vector<double>(4, 7)), 0);
}

TEST(Experiment, Has300RunsOfWhich258CanBeRight) {
    const std::vector<ExperimentRun> runs = experiment_runs();
    EXPECT_EQ(runs.size(), 300U);
    EXPECT_EQ(std::ranges::count_if(runs, usable), 258);
    for (std::size_t i = 0; i < runs.size(); ++i)
        EXPECT_EQ(std::ranges::count(runs, runs[i]), 1) << i;
}

// All shapes lie within the bed at every angle, and their layers fill as asked: 16 of 20 are solid.
TEST(Experiment, IsPrintedOnTheBed) {
    const Machine machine = experiment_machine();
    for (std::size_t shape = 0; shape < shape_names.size(); ++shape)
        for (const int angle : part_angles) {
            const Region outline = outline_of(static_cast<Shape>(shape));
            const Print print =
                experiment_print(outline, setup_of({static_cast<Shape>(shape), 0, 0, angle}));
            EXPECT_TRUE(fits_bed(print.parts, machine.printer));
            const auto sparse = std::ranges::count_if(print.parts, [](const LayerParts& layer) {
                return layer.islands.front().fills.front().role == Role::infill;
            });
            EXPECT_EQ(print.parts.size(), 20U);
            EXPECT_EQ(sparse, 4);
            EXPECT_NEAR(print.parts.back().z, 2.1, 1e-12);
        }
}

TEST(Replay, GivesTheSameForAnyNumberOfThreads) {
    const std::vector<PublishedRun> runs{{{Shape::drop, 3, 45, 30}, 1, false},
                                         {{Shape::triangle, 2, 90, 60}, 1, false},
                                         {{Shape::square, 0, 0, 0}, 1, false}};
    const std::vector<ReplayedRun> one = replayed(runs, 1), many = replayed(runs, 3);
    for (std::size_t i = 0; i < runs.size(); ++i) {
        EXPECT_EQ(one[i].ours.energy, many[i].ours.energy);
        EXPECT_EQ(one[i].ours.duration, many[i].ours.duration);
        EXPECT_EQ(one[i].published.run, runs[i].run);
    }
}

TEST(Replay, TurningASquareByARightAngleChangesNothing) {
    const auto cost = [](int part_angle) {
        const ExperimentRun run{Shape::square, 0, 45, part_angle};
        return run_cost(experiment_print(outline_of(run.shape), setup_of(run)));
    };
    EXPECT_NEAR(cost(0).energy, cost(90).energy, 1e-4 * cost(0).energy);
}

TEST(Agreement, CountsOnlyWhatIsWanted) {
    const ExperimentRun run;
    const std::vector<ReplayedRun> runs{{{run, 100, false}, {110, 0, 0, {}}},
                                        {{run, 200, false}, {190, 0, 0, {}}},
                                        {{run, 300, true}, {900, 0, 0, {}}}};
    const Agreement some = agreement(runs, [](const auto& row) { return !row.suspect; });
    EXPECT_EQ(some.rows, 2);
    EXPECT_NEAR(some.mape, 0.075, 1e-12);
    EXPECT_NEAR(some.worst, 0.1, 1e-12);
    EXPECT_EQ(agreement(runs, [](const auto&) { return true; }).rows, 3);
}

}  // namespace
}  // namespace bead
