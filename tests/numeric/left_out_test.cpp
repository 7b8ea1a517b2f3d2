#include "numeric/left_out.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <random>

namespace bead {
namespace {

struct LeftOutSample {
    Rows rows;
    std::vector<double> values;
};

LeftOutSample random_sample(unsigned seed, std::size_t n, double noise) {
    std::mt19937_64 random(seed);
    std::normal_distribution<double> normal;
    LeftOutSample s;
    for (std::size_t i = 0; i < n; ++i) {
        s.rows.push_back({1 + std::abs(normal(random)), 10 * std::abs(normal(random))});
        s.values.push_back(dot(s.rows.back(), {5, 0.3}) + noise * normal(random));
    }
    return s;
}

// The closed form: a row's own error grows by 1 / (1 - its leverage) when it is left out.
RC_GTEST_PROP(LeftOut, OfSingleRowsIsTheFitsErrorOverOneLessLeverage, ()) {
    const LeftOutSample s = random_sample(*rc::gen::arbitrary<unsigned>(), 12, 0.2);
    FitOptions options;
    for (std::size_t i = 0; i < s.rows.size(); ++i) options.weights.push_back(1.0 + double(i % 3));
    const LinearFit fit = fit_linear(s.rows, s.values, options);
    const auto told = left_out(s.rows, s.values, each_alone(s.rows.size()), options);
    for (std::size_t i = 0; i < s.rows.size(); ++i) {
        const double error = s.values[i] - dot(s.rows[i], fit.coefficients);
        RC_ASSERT(told[i].has_value());
        RC_ASSERT(std::abs(s.values[i] - *told[i] - error / (1 - fit.leverage[i])) < 1e-9);
    }
}

RC_GTEST_PROP(LeftOut, KnowsExactRowsWhateverTheGroups, ()) {
    const LeftOutSample s = random_sample(*rc::gen::arbitrary<unsigned>(), 9, 0);
    const auto told = left_out(s.rows, s.values, {0, 0, 0, 1, 1, 2, 2, 2, 3}, {});
    const auto errors = relative_errors(told, s.values);
    RC_ASSERT(errors->told == 9U);
    RC_ASSERT(errors->mean_absolute < 1e-9);
}

// What is left out cannot be known: changing its value does not change what is said of it.
RC_GTEST_PROP(LeftOut, DoesNotPeek, ()) {
    LeftOutSample s = random_sample(*rc::gen::arbitrary<unsigned>(), 9, 0.1);
    const std::vector<std::size_t> labels{0, 0, 0, 1, 1, 2, 2, 2, 3};
    const auto before = left_out(s.rows, s.values, labels, {.non_negative = true});
    s.values[3] *= 7;
    s.values[4] *= 0.1;
    const auto after = left_out(s.rows, s.values, labels, {.non_negative = true});
    RC_ASSERT(*before[3] == *after[3]);
    RC_ASSERT(*before[4] == *after[4]);
    RC_ASSERT(*before[0] != *after[0]);
}

TEST(LeftOut, SaysNothingWhereTheRestDoesNotDecide) {
    const auto too_few = left_out({{1, 2}, {2, 1}}, {1, 2}, {0, 1}, {});
    EXPECT_FALSE(too_few[0].has_value());
    const auto alike = left_out({{1, 2}, {1, 0}, {2, 4}, {3, 6}}, {1, 2, 3, 4}, {0, 1, 2, 3}, {});
    EXPECT_TRUE(alike[0].has_value());
    EXPECT_FALSE(alike[1].has_value());
    EXPECT_FALSE(relative_errors({std::nullopt}, {1}).has_value());
}

TEST(LeftOut, ErrorsAreRelativeAndTheWorstKeepsItsSign) {
    const auto errors = relative_errors({110, 70, std::nullopt}, {100, 100, 100});
    EXPECT_EQ(errors->told, 2U);
    EXPECT_NEAR(errors->mean_absolute, 0.2, 1e-12);
    EXPECT_NEAR(errors->worst, -0.3, 1e-12);
    EXPECT_EQ(errors->worst_row, 1U);
}

}  // namespace
}  // namespace bead
