#include "energy/published.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <fstream>
#include <map>
#include <sstream>
#include <string>

#include "support/blocks.h"

namespace bead {
namespace {

using namespace test;

const double diagonal = 1 / std::sqrt(2.0);

TEST(Features, OfALineAlongXFromRestToRest) {
    const Features f = features_of(trapezoid({100, 0, 0, 5}, 0, 0, 80, 1000));
    EXPECT_NEAR(f.A, 6400, 1e-9);
    EXPECT_NEAR(f.B, 0, 1e-9);
    EXPECT_NEAR(f.C, 93.6, 1e-9);
    EXPECT_NEAR(f.H, 1.33, 1e-9);
    EXPECT_NEAR(f.axis_time, 2.66, 1e-9);
}

TEST(Features, OfALineTooShortToCruise) {
    const Features f = features_of(trapezoid({2, 0, 0, 0}, 0, 0, 80, 1000));
    EXPECT_NEAR(f.A, 2000, 1e-9);
    EXPECT_NEAR(f.C, 0, 1e-9);
    EXPECT_NEAR(f.axis_time / 2, 0.0894427191, 1e-9);
}

TEST(Features, OfADiagonal) {
    const Features f =
        features_of(trapezoid({100 * diagonal, -100 * diagonal, 0, 0}, 0, 0, 80, 1000));
    EXPECT_NEAR(f.A, 3200, 1e-9);
    EXPECT_NEAR(f.B, 3200, 1e-9);
    EXPECT_NEAR(f.C, 93.6 * std::sqrt(2.0), 1e-9);
    EXPECT_EQ(f.H, 0);
}

TEST(Features, OfFilamentAloneAreBothAxesHolding) {
    const Block retraction = trapezoid({0, 0, 0, -0.8}, 0, 0, 35, 1250);
    const Features f = features_of(retraction);
    EXPECT_EQ(f.A + f.B + f.C, 0);
    EXPECT_DOUBLE_EQ(f.H, 2 * duration(retraction));
    EXPECT_DOUBLE_EQ(f.axis_time, f.H);
}

TEST(Features, OfNothingAreNothing) { EXPECT_EQ(published_energy(features_of(Block{})), 0); }

RC_GTEST_PROP(Features, AddUpWhenABlockIsCutInTwo, ()) {
    const Block whole = any_block();
    RC_PRE(whole.t_cruise > 1e-6);
    Block first = whole, second = whole;
    first.t_cruise = number_between(0, whole.t_cruise);
    second.t_cruise = whole.t_cruise - first.t_cruise;
    first.v_exit = second.v_entry = whole.v_peak;
    first.t_decel = second.t_accel = 0;
    const double cut =
        ((first.v_entry + first.v_peak) / 2 * first.t_accel + first.v_peak * first.t_cruise) /
        whole.length;
    for (double& d : first.delta) d *= cut;
    for (double& d : second.delta) d *= 1 - cut;
    first.length *= cut;
    second.length *= 1 - cut;
    const Features sum = features_of(first) + features_of(second), all = features_of(whole);
    RC_ASSERT(std::abs(published_energy(sum) - published_energy(all)) < 1e-6);
    RC_ASSERT(std::abs(standing_form(sum) - standing_form(all)) < 1e-6);
}

RC_GTEST_PROP(Features, ExchangeWithTheAxes, ()) {
    const Block block = any_block();
    Block turned = block;
    std::swap(turned.delta[axis_x], turned.delta[axis_y]);
    const Features f = features_of(block), g = features_of(turned);
    RC_ASSERT(f.A == g.B && f.B == g.A && f.H == g.H && f.axis_time == g.axis_time);
    RC_ASSERT(std::abs(f.C - g.C) < 1e-9);
    const MotorCoefficients equal{.a = 1e-4, .b = 1e-4};
    RC_ASSERT(std::abs(published_energy(f, equal) - published_energy(g, equal)) < 1e-9);
}

RC_GTEST_PROP(Features, ForgetDirection, ()) {
    const Block block = any_block();
    Block back = block;
    for (double& d : back.delta) d = -d;
    std::swap(back.v_entry, back.v_exit);
    std::swap(back.t_accel, back.t_decel);
    RC_ASSERT(std::abs(published_energy(features_of(block)) - published_energy(features_of(back))) <
              1e-12);
}

RC_GTEST_PROP(Features, EveryAxisAcceleratesCoastsOrHolds, ()) {
    const Features f = features_of(any_block());
    RC_ASSERT(f.A >= 0 && f.B >= 0 && f.C >= 0 && f.H >= 0 && f.H <= f.axis_time);
}

TEST(StandingForm, CostsAsPublishedForAnAxisThatCoastsAtTheUsualSpeed) {
    const double u = 65;
    const Features coasting{.C = 2 * u * 3, .axis_time = 2 * 3};  // both axes, 3 s
    EXPECT_NEAR(standing_form(coasting, {}, u), published_energy(coasting), 1e-12);
}

// The published form drops by the whole standing power at the first micrometre off the axis.
TEST(StandingForm, HasNoLoopholeNearTheAxes) {
    const Features straight = features_of(trapezoid({100, 0, 0, 0}, 0, 0, 40, 1000));
    const Features tilted = features_of(trapezoid({100, 0.01, 0, 0}, 0, 0, 40, 1000));
    EXPECT_LT(published_energy(tilted), 0.9 * published_energy(straight));
    EXPECT_GT(standing_form(tilted), standing_form(straight));
}

using Row = std::map<std::string, std::string>;

std::vector<Row> rows_of(const std::string& name) {
    std::ifstream file(std::string(BEAD_SOURCE_DIR) + "/tests/data/somade2023/" + name);
    const auto cells = [](const std::string& line) {
        std::vector<std::string> result;
        std::istringstream text(line);
        for (std::string cell; std::getline(text, cell, ',');) result.push_back(cell);
        return result;
    };
    std::vector<Row> rows;
    std::string line;
    std::getline(file, line);
    const std::vector<std::string> names = cells(line);
    while (std::getline(file, line)) {
        const std::vector<std::string> values = cells(line);
        Row row;
        for (std::size_t i = 0; i < names.size(); ++i)
            row[names[i]] = i < values.size() ? values[i] : "";
        rows.push_back(row);
    }
    return rows;
}

bool is_complete(const Row& row) {
    for (const char* key : {"a_mm2_per_s2", "b_mm2_per_s2", "c_mm", "t_hold_total_s", "energy_mWs"})
        if (row.at(key).empty()) return false;
    return true;
}

TEST(PublishedEnergy, AgreesWithEveryCompleteRowOfTheAppendices) {
    int complete = 0;
    for (const char* table : {"appendix_d_infill.csv", "appendix_d_geometry.csv",
                              "appendix_e_infill.csv", "appendix_e_geometry.csv"})
        for (const Row& row : rows_of(table)) {
            if (!is_complete(row)) continue;
            ++complete;
            const auto number = [&](const char* key) { return std::stod(row.at(key)); };
            const Features f{number("a_mm2_per_s2"), number("b_mm2_per_s2"), number("c_mm"),
                             number("t_hold_total_s"), 0};
            const double joules = number("energy_mWs") * 1e-3;
            EXPECT_NEAR(published_energy(f), joules, joules * 1e-6) << table << ' ' << complete;
        }
    EXPECT_EQ(complete, 61);
}

// Appendix D leaves the energy of octogram 0/60 blank; Appendix C prints it.
TEST(PublishedEnergy, AgreesWithTheRowWhoseEnergyStandsInAppendixC) {
    const Features f{9021594.311, 8655633.357, 76998.1962, 1479.55, 0};
    EXPECT_NEAR(published_energy(f), 8911.245583, 8911 * 1e-6);
}

}  // namespace
}  // namespace bead
