#include "numeric/least_squares.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <random>

namespace bead {
namespace {

struct System {
    Rows rows;
    std::vector<double> values;
};

System random_sample(unsigned seed, std::size_t n, const std::vector<double>& truth, double noise) {
    std::mt19937_64 random(seed);
    std::normal_distribution<double> normal;
    System sample;
    for (std::size_t i = 0; i < n; ++i) {
        Row row;
        for (std::size_t j = 0; j < truth.size(); ++j)
            row.push_back(std::pow(1e3, double(j)) * (1 + std::abs(normal(random))));
        sample.values.push_back(dot(row, truth) + noise * normal(random));
        sample.rows.push_back(row);
    }
    return sample;
}

RC_GTEST_PROP(LeastSquares, FindsWhatMadeTheValues, ()) {
    const std::vector<double> truth{2.5, -1e-3, 4e-6};
    const System s = random_sample(*rc::gen::arbitrary<unsigned>(), 12, truth, 0);
    const LinearFit fit = fit_linear(s.rows, s.values);
    for (std::size_t j = 0; j < truth.size(); ++j)
        RC_ASSERT(std::abs(fit.coefficients[j] / truth[j] - 1) < 1e-9);
    RC_ASSERT(fit.r2 > 1 - 1e-12);
}

// The errors are at right angles to every column, and leverages sum to the number of coefficients.
RC_GTEST_PROP(LeastSquares, ErrorsAreOrthogonalToTheColumns, ()) {
    const System s = random_sample(*rc::gen::arbitrary<unsigned>(), 15, {1, 1e-3}, 0.5);
    std::vector<double> weights;
    for (std::size_t i = 0; i < s.rows.size(); ++i) weights.push_back(1.0 + double(i % 4));
    const LinearFit fit = fit_linear(s.rows, s.values, {.weights = weights});
    for (std::size_t j = 0; j < 2; ++j) {
        double sum = 0, size = 0;
        for (std::size_t i = 0; i < s.rows.size(); ++i) {
            sum += weights[i] * s.rows[i][j] * (s.values[i] - dot(s.rows[i], fit.coefficients));
            size += weights[i] * std::abs(s.rows[i][j] * s.values[i]);
        }
        RC_ASSERT(std::abs(sum) < 1e-10 * size);
    }
    double leverage = 0;
    for (const double h : fit.leverage) leverage += h;
    RC_ASSERT(std::abs(leverage - 2) < 1e-9);
}

RC_GTEST_PROP(LeastSquares, NonNegativeIsTheBestOfAllThatAre, ()) {
    const System s = random_sample(*rc::gen::arbitrary<unsigned>(), 10, {1, -2e-3, 1e-6}, 1);
    const auto error = [&](const std::vector<double>& x) {
        double sum = 0;
        for (std::size_t i = 0; i < s.rows.size(); ++i)
            sum += std::pow(s.values[i] - dot(s.rows[i], x), 2);
        return sum;
    };
    const LinearFit fit = fit_linear(s.rows, s.values, {.non_negative = true});
    const double best = error(fit.coefficients);
    for (const double x : fit.coefficients) RC_ASSERT(x >= 0);
    for (unsigned kept = 1; kept < 8; ++kept) {  // every choice of columns, solved freely
        Rows part;
        for (const Row& row : s.rows) {
            part.emplace_back();
            for (std::size_t j = 0; j < 3; ++j)
                if ((kept >> j & 1U) != 0) part.back().push_back(row[j]);
        }
        const LinearFit free = fit_linear(part, s.values);
        std::vector<double> x(3, 0);
        for (std::size_t j = 0, k = 0; j < 3; ++j)
            if ((kept >> j & 1U) != 0) x[j] = free.coefficients[k++];
        if (x[0] >= 0 && x[1] >= 0 && x[2] >= 0) RC_ASSERT(best <= error(x) * (1 + 1e-9));
    }
}

// Many samples with the same noise: coefficients scatter by their standard errors.
TEST(LeastSquares, StandardErrorsAreTheScatter) {
    const std::vector<double> truth{2, 1e-3};
    double sum = 0, told = 0;
    const int samples = 2000;
    const System fixed = random_sample(1, 10, truth, 0);
    std::mt19937_64 random(2);
    std::normal_distribution<double> normal;
    for (int k = 0; k < samples; ++k) {
        std::vector<double> values = fixed.values;
        for (double& value : values) value += 0.3 * normal(random);
        const LinearFit fit = fit_linear(fixed.rows, values);
        sum += std::pow(fit.coefficients[0] - truth[0], 2);
        told += std::pow(fit.standard_errors[0], 2);
    }
    EXPECT_NEAR(sum / told, 1, 0.1);
}

TEST(LeastSquares, AlikeColumnsAreInfinitelyIllConditioned) {
    const LinearFit fit = fit_linear({{1, 2}, {2, 4}, {3, 6}}, {1, 2, 3});
    EXPECT_TRUE(std::isinf(fit.condition));
    EXPECT_NEAR(dot({2, 4}, fit.coefficients), 2, 1e-9);
}

TEST(LeastSquares, CentredAndPlainShareOfTheSquares) {
    const LinearFit fit = fit_linear({{1}, {1}, {1}}, {9, 10, 11});
    EXPECT_NEAR(fit.coefficients[0], 10, 1e-12);
    EXPECT_NEAR(fit.r2_centred, 0, 1e-12);
    EXPECT_NEAR(fit.r2, 300.0 / 302, 1e-12);
    EXPECT_NEAR(fit.residual, 1, 1e-12);
}

}  // namespace
}  // namespace bead
