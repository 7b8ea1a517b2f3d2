#include "job/published_tables.h"

#include <gtest/gtest.h>

namespace bead {
namespace {

TEST(PublishedTables, HaveTheRunsInOrder) {
    const std::vector<PublishedRun> runs = published_runs();
    const std::vector<ExperimentRun> wanted = experiment_runs();
    ASSERT_EQ(runs.size(), wanted.size());
    for (std::size_t i = 0; i < runs.size(); ++i) {
        EXPECT_EQ(runs[i].run, wanted[i]);
        EXPECT_GT(runs[i].energy, 4000);
        EXPECT_LT(runs[i].energy, 16000);
    }
    EXPECT_EQ(std::ranges::count_if(runs, [](const auto& run) { return run.suspect; }), 31);
}

TEST(PublishedTables, AppendicesAgreeWithTheModel) {
    const std::vector<FeatureRow> rows = appendix_rows();
    EXPECT_EQ(rows.size(), 62U);
    for (const FeatureRow& row : rows)
        EXPECT_NEAR(published_energy(row.features), row.energy, 1e-6 * row.energy);
}

TEST(PublishedTables, HaveTheMeasuredPrints) {
    const std::vector<FeatureRow> rows = calibration_rows();
    ASSERT_EQ(rows.size(), 10U);
    for (const FeatureRow& row : rows)  // the fit's own residuals reach 8 %
        EXPECT_NEAR(published_energy(row.features), row.energy, 0.1 * row.energy);
}

// A fifth of all runs, of every shape, pattern and angle; the journey makes all of them.
TEST(Replay, AgreesWithAFifthOfTheTable) {
    std::vector<PublishedRun> some;
    const std::vector<PublishedRun> all = published_runs();
    for (std::size_t i = 0; i < all.size(); ++i)
        if (i % 5 == (i / 60) % 5 && usable(all[i].run)) some.push_back(all[i]);
    const Agreement found =
        agreement(replayed(some), [](const PublishedRun& run) { return !run.suspect; });
    EXPECT_GT(found.rows, 45);
    EXPECT_LT(found.mape, 0.021);
    EXPECT_GT(found.spearman, 0.99);
    for (const double shape : found.by_shape) EXPECT_GT(shape, 0.75);
}

}  // namespace
}  // namespace bead
