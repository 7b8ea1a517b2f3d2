#include "study/claims.h"

#include <gtest/gtest.h>

namespace bead {
namespace {

template <class Energy>
RunEnergies all_runs(const Energy& energy) {
    RunEnergies energies;
    for (const ExperimentRun& run : experiment_runs()) energies.add(run, energy(run));
    return energies;
}

// As the thesis claims.
double as_claimed(const ExperimentRun& run) {
    return 100 + (run.infill_angle == 45 ? 50 : 0) - (run.infill_angle == 90 ? 1 : 0) +
           10 * static_cast<double>(run.pattern) + 0.01 * run.part_angle;
}

TEST(Claims, AreFoundWhereTheyHold) {
    const Tallies counts = tallies(all_runs(as_claimed));
    EXPECT_EQ(counts.diagonal_worst, (Tally{100, 100}));
    EXPECT_EQ(counts.ninety_best, (Tally{100, 100}));
    EXPECT_EQ(counts.rectilinear_lowest, (Tally{60, 60}));
    EXPECT_EQ(counts.part_0_lowest, (Tally{75, 75}));
    EXPECT_EQ(counts.infill_outweighs_part, (Tally{5, 5}));
    EXPECT_EQ(counts.pattern_outweighs_part, (Tally{5, 5}));
}

TEST(Claims, AreNotFoundWhereTheyFail) {
    const Tallies counts = tallies(
        all_runs([](const ExperimentRun& run) { return -as_claimed(run) - run.part_angle; }));
    EXPECT_EQ(counts.diagonal_worst.holds, 0);
    EXPECT_EQ(counts.rectilinear_lowest.holds, 0);
    EXPECT_EQ(counts.part_0_lowest.holds, 0);
    EXPECT_EQ(counts.infill_outweighs_part.holds, 0);
}

TEST(Claims, LeaveOutCellsWithARunMissing) {
    RunEnergies energies;
    for (const ExperimentRun& run : experiment_runs())
        if (run != ExperimentRun{Shape::oval, 1, 45, 30}) energies.add(run, as_claimed(run));
    const Tallies counts = tallies(energies);
    EXPECT_EQ(counts.diagonal_worst, (Tally{99, 99}));
    EXPECT_EQ(counts.rectilinear_lowest, (Tally{59, 59}));
    EXPECT_EQ(counts.part_0_lowest, (Tally{74, 74}));
    EXPECT_EQ(counts.pattern_outweighs_part, (Tally{4, 4}));
}

TEST(Claims, ExchangeOfAxesShowsOnlyWhatDependsOnThem) {
    EXPECT_EQ(exchange_effect(all_runs([](const ExperimentRun&) { return 7.0; })), 0);
    const auto dearer = [](const ExperimentRun& run) { return run.part_angle == 90 ? 1.1 : 1.0; };
    EXPECT_NEAR(exchange_effect(all_runs(dearer)), 0.1, 1e-12);
}

TEST(Claims, CoastingPaysInPairsThatCoastMoreAndSpeedUpLess) {
    const ChargedFeatures coasts{{1, 1, 10, 0}, 5}, speeds_up{{4, 4, 2, 0}, 8},
        coasts_dearly{{1, 1, 20, 0}, 9}, neither{{0, 0, 1, 0}, 1};
    EXPECT_EQ(coasting_pays(std::array{coasts, speeds_up}), (Tally{1, 1}));
    EXPECT_EQ(coasting_pays(std::array{coasts_dearly, speeds_up}), (Tally{0, 1}));
    EXPECT_EQ(coasting_pays(std::array{coasts, neither}), (Tally{0, 0}));
}

}  // namespace
}  // namespace bead
