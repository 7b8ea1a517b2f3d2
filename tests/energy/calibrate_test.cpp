#include "energy/calibrate.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <random>

#include "energy/calibrated.h"
#include "support/table3.h"

namespace bead {
namespace {

using test::table3;
using enum EnergyModel;
using enum FitMethod;

const Calibration& fits_of_table3() {
    static const Calibration found = calibrate(table3(), {published, pooled, physical});
    return found;
}

const FittedModel& fit_of(const Calibration& found, EnergyModel model, FitMethod method) {
    for (const FittedModel& fit : found.fits)
        if (fit.model == model && fit.method == method) return fit;
    throw std::runtime_error("not fitted");
}

void expect_coefficients(const FittedModel& fit, const std::vector<double>& expected,
                         double tolerance) {
    const auto columns = columns_of(fit.model);
    ASSERT_EQ(columns.size(), expected.size());
    for (std::size_t j = 0; j < columns.size(); ++j)
        EXPECT_NEAR(fit.fit.coefficients[j] * columns[j].per_joule / expected[j], 1, tolerance)
            << columns[j].name;
}

TEST(Calibrate, RefitsTableThreeAsPublished) {
    const FittedModel& fit = fit_of(fits_of_table3(), published, ordinary);
    expect_coefficients(fit, {0.134857071, 0.131575661, 69.14025683, 832.7358875}, 1e-6);
    const std::vector<double> errors{0.031872769, 0.021151509, 3.979053804, 134.8706114};
    for (std::size_t j = 0; j < errors.size(); ++j)
        EXPECT_NEAR(fit.fit.standard_errors[j] * 1e3 / errors[j], 1, 1e-6);
    EXPECT_NEAR(fit.fit.residual, 100.152934, 1e-5);
    EXPECT_NEAR(fit.fit.r2, 0.998920917, 1e-8);
}

TEST(Calibrate, SaysWhatThePublishedStatisticsHide) {
    const FittedModel& fit = fit_of(fits_of_table3(), published, ordinary);
    EXPECT_NEAR(fit.fit.r2_centred, 0.930, 0.0005);
    EXPECT_NEAR(fit.fit.condition, 5.98, 0.01);
    EXPECT_NEAR(100 * fit.shown.mean_absolute, 2.86, 0.005);
    EXPECT_NEAR(100 * fit.alone->mean_absolute, 5.71, 0.005);
    EXPECT_NEAR(100 * fit.alone->worst, 17.3, 0.05);  // said too high
    EXPECT_NEAR(100 * fits_of_table3().mean->mean_absolute, 11.7, 0.05);
    EXPECT_GT(fit.by_group->mean_absolute, 2);  // without the L, four rows for four unknowns
}

TEST(Calibrate, FitsTheOtherWaysOfTheAudit) {
    const Calibration& found = fits_of_table3();
    const FittedModel& by_weight = fit_of(found, published, weighted);
    expect_coefficients(by_weight, {0.1314, 0.1291, 69.03, 853.7}, 5e-4);
    const FittedModel& bounded = fit_of(found, published, non_negative);
    expect_coefficients(bounded, {0.134857071, 0.131575661, 69.14025683, 832.7358875}, 1e-6);
    const FittedModel& alike = fit_of(found, pooled, ordinary);
    expect_coefficients(alike, {0.1327, 69.27, 828.5}, 5e-4);
    EXPECT_NEAR(100 * alike.alone->mean_absolute, 4.68, 0.005);
}

// The audit drew other rows, so its ends agree only about as well as ends of 2000 draws from ten
// rows do.
TEST(Calibrate, BootstrapsNearTheAudit) {
    const auto& scatter = fit_of(fits_of_table3(), published, ordinary).scatter;
    const std::vector<std::array<double, 4>> ends{{0.033, 0.396, 0.03, 0.08},
                                                  {-0.047, 0.184, 0.05, 0.03},
                                                  {56, 91, 4, 6},
                                                  {161, 1220, 100, 100}};
    for (std::size_t j = 0; j < ends.size(); ++j) {
        EXPECT_NEAR(scatter.coefficients[j].low * 1e3, ends[j][0], ends[j][2]) << j;
        EXPECT_NEAR(scatter.coefficients[j].high * 1e3, ends[j][1], ends[j][3]) << j;
    }
}

TEST(Calibrate, PhysicalTermsTellNewPrintsBetterThanThePublishedOnes) {
    const Calibration& found = fits_of_table3();
    const FittedModel& fit = fit_of(found, physical, non_negative);
    EXPECT_LT(100 * fit.alone->mean_absolute, 4.05);
    EXPECT_NEAR(100 * fit.by_group->mean_absolute, 7.46, 0.05);
    EXPECT_NEAR(100 * fit_of(found, pooled, non_negative).by_group->mean_absolute, 22.8, 0.05);
    EXPECT_NEAR(100 * fit_of(found, published, non_negative).by_group->mean_absolute, 27.9, 0.05);
    for (const double k : fit.fit.coefficients) EXPECT_GT(k, 0);
    const auto best = best_at_new_prints(found);
    EXPECT_EQ(found.fits[*best].model, physical);
    EXPECT_EQ(found.fits[*best].method, non_negative);
}

// The one number that is put in, not fitted, does not have to be exact.
TEST(Calibrate, PhysicalTermsForgiveAWrongAcceleration) {
    for (const auto& [acceleration, percent] : {std::pair{800.0, 4.79}, {1200.0, 4.18}}) {
        const Calibration found =
            calibrate(table3(), {physical}, {.model = {acceleration}, .bootstrap = {.draws = 1}});
        EXPECT_NEAR(100 * fit_of(found, physical, non_negative).alone->mean_absolute, percent,
                    0.01);
    }
}

// A stepper that is paid by time alone: lines from rest to rest, each in ramps and coasting at v,
// cost as the physical model says, whatever their length.
TEST(Calibrate, RampsFromRestTakeTheirWayTwiceInTime) {
    const double v = 80, a = 1000, watts = 5;
    for (const double length : {10.0, 50.0, 200.0}) {
        const double ramps = v * v / a, seconds = 2 * v / a + (length - ramps) / v;
        const Observation line{
            .name = "line", .energy = 1, .features = Features{v * v, 0, length - ramps, 0, 0}};
        EXPECT_NEAR(row_of(physical, line, {a})[0] * watts / v, watts * seconds, 1e-9);
    }
}

std::vector<Observation> random_prints(unsigned seed, std::size_t count) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> uniform(0.2, 2);
    std::vector<Observation> prints;
    for (std::size_t i = 0; i < count; ++i) {
        Observation seen{.name = "print " + std::to_string(i), .group = i % 2 == 0 ? "p" : "q"};
        const double hold = 500 * uniform(random);
        seen.features = Features{2e6 * uniform(random), 2e6 * uniform(random),
                                 2e4 * uniform(random), hold, hold + 900 * uniform(random)};
        seen.duration = seen.features->axis_time / 2;
        seen.filament = 10 * uniform(random);
        seen.heat_ups = 1;
        seen.modelled = 1e5 * uniform(random);
        prints.push_back(seen);
    }
    return prints;
}

RC_GTEST_PROP(Calibrate, FindsTheCoefficientsThatMadeTheEnergies, ()) {
    const auto model = EnergyModel(*rc::gen::inRange(0, int(energy_model_names.size())));
    std::vector<Observation> prints = random_prints(*rc::gen::arbitrary<unsigned>(), 12);
    std::vector<double> truth;
    for (const ModelColumn& column : columns_of(model)) truth.push_back(3 / column.per_joule);
    for (Observation& seen : prints) seen.energy = dot(row_of(model, seen, {}), truth);
    const Calibration found = calibrate(prints, {model}, {.bootstrap = {.draws = 5}});
    RC_ASSERT(found.fits.size() == 3U);
    for (const FittedModel& fit : found.fits) {
        for (std::size_t j = 0; j < truth.size(); ++j)
            RC_ASSERT(std::abs(fit.fit.coefficients[j] / truth[j] - 1) < 1e-7);
        RC_ASSERT(fit.by_group->mean_absolute < 1e-7);
        const CalibratedModel kept = calibrated(fit, {});
        RC_ASSERT(std::abs(estimate(kept, prints[3]) / prints[3].energy - 1) < 1e-7);
    }
}

// Joules or kilojoules, prints in any order: the same errors.
RC_GTEST_PROP(Calibrate, DoesNotCareForUnitsOrOrder, ()) {
    std::vector<Observation> prints = table3();
    const auto before = fit_of(fits_of_table3(), published, weighted).alone->mean_absolute;
    std::mt19937_64 random(*rc::gen::arbitrary<unsigned>());
    std::shuffle(prints.begin(), prints.end(), random);
    for (Observation& seen : prints) seen.energy *= 1e3;
    const Calibration found = calibrate(prints, {published}, {.bootstrap = {.draws = 1}});
    RC_ASSERT(std::abs(fit_of(found, published, weighted).alone->mean_absolute - before) < 1e-9);
}

TEST(Calibrate, SaysHowManyPrintsAreMissing) {
    std::vector<Observation> prints = table3();
    prints.resize(3);
    const Calibration found = calibrate(prints, {published, physical});
    ASSERT_EQ(found.unfitted.size(), 1U);
    EXPECT_NE(found.unfitted[0].reason.find("at least 1 more"), std::string::npos)
        << found.unfitted[0].reason;
    EXPECT_EQ(found.fits.front().model, physical);
}

TEST(Calibrate, NamesTheColumnsThatGoTogetherAndWhatToPrint) {
    std::vector<Observation> prints = random_prints(1, 8);
    for (Observation& seen : prints) seen.features->B = 1.5 * seen.features->A;
    const std::string reason = obstacle(published, prints, {});
    EXPECT_NE(reason.find("A (speed changes along X) and B (speed changes along Y)"),
              std::string::npos)
        << reason;
    EXPECT_NE(reason.find("short lines along X"), std::string::npos);
    EXPECT_EQ(obstacle(pooled, prints, {}), "");

    for (Observation& seen : prints) seen.features->H = 0;
    EXPECT_NE(obstacle(pooled, prints, {}).find("H (time in which an axis stands) is 0"),
              std::string::npos);
}

TEST(Calibrate, NamesTheTwoThatMatterAmongThree) {
    std::vector<Observation> prints = random_prints(2, 9);
    for (std::size_t i = 0; i < prints.size(); ++i)
        *prints[i].duration = 100 * *prints[i].filament * (1 + 1e-7 * double(i));
    const std::string reason = obstacle(machine, prints, {});
    EXPECT_NE(reason.find("printing time"), std::string::npos) << reason;
    EXPECT_NE(reason.find("filament"), std::string::npos) << reason;
    EXPECT_EQ(reason.find("heating up"), std::string::npos) << reason;
}

TEST(Calibrate, SaysWhatIsNotRecorded) {
    std::vector<Observation> prints = table3();
    EXPECT_NE(obstacle(EnergyModel::time, prints, {}).find("duration_s"), std::string::npos);
    EXPECT_NE(obstacle(machine, prints, {}).find(prints[0].name), std::string::npos);
}

TEST(Calibrate, CannotLeaveOutWhatTheRestNeeds) {
    std::vector<Observation> prints = table3();
    prints.resize(4);
    const Calibration found = calibrate(prints, {published}, {.bootstrap = {.draws = 10}});
    EXPECT_FALSE(found.fits.front().alone.has_value());
    EXPECT_FALSE(best_at_new_prints(found).has_value());
}

}  // namespace
}  // namespace bead
