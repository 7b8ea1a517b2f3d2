// Linear least squares: coefficients x that make rows·x nearest to the values, with what a reader
// needs to judge them. Columns are scaled to equal size first, so units do not matter to accuracy.
// No intercept: add a column of ones if there is to be one.
//
//     const LinearFit fit = fit_linear({{1, 0}, {1, 1}, {1, 2}}, {0.1, 1.9, 4.1});
#pragma once
#include <vector>

namespace bead {

using Row = std::vector<double>;
using Rows = std::vector<Row>;  // all of the same length, the number of coefficients

struct FitOptions {
    std::vector<double> weights{};  // one above 0 per row; empty: all 1
    bool non_negative = false;      // coefficients below 0 are held at 0 (Lawson and Hanson 1974)
};

struct LinearFit {
    std::vector<double> coefficients;
    std::vector<double> standard_errors;  // 0 for those held at 0
    std::vector<std::vector<double>> covariance;
    double residual = 0;            // standard deviation of the values about the fit
    double r2 = 0, r2_centred = 0;  // part of the values' squares explained; about their mean
    double condition = 0;           // of the scaled columns; 1 is perfect, above 30 they are alike
    std::vector<double> leverage;   // per row, 0 … 1: how much its value decides its own estimate
};

// Needs at least as many rows as coefficients. Columns that are combinations of others give the
// shortest of all solutions and an infinite condition; check it before you believe a coefficient.
LinearFit fit_linear(const Rows& rows, const std::vector<double>& values,
                     const FitOptions& options = {});

double dot(const Row& row, const std::vector<double>& coefficients);

}  // namespace bead
