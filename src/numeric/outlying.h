// Rows whose value is far from what most rows agree on, found by least median of squares (Rousseeuw
// 1984): of many fits through as few rows as determine one, the fit is taken whose median error is
// least, and made again from all rows that it does not doubt. Half of the rows may be wrong without
// hiding each other, which they do in a common fit.
#pragma once
#include <cstdint>

#include "numeric/least_squares.h"

namespace bead {

struct OutlyingOptions {
    double sigmas = 8;  // how far is far
    double least =
        0.02;          // standard deviation of relative errors, supposed at least: what meters do
    int trials = 500;  // fits
    std::uint64_t seed = 1;  // of the choice of rows
};

struct OutlyingRow {
    std::size_t row = 0;
    double ratio = 0;   // its value / what the others make of it
    double sigmas = 0;  // standard deviations between the two
};

// Errors are relative; values are above 0. Empty where there are fewer than three rows more than
// coefficients: nobody can say then who is wrong.
std::vector<OutlyingRow> outlying(const Rows& rows, const std::vector<double>& values,
                                  const OutlyingOptions& options = {});

}  // namespace bead
