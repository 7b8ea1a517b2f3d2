// How well a linear fit says what it was not shown: rows are left out, the rest is fitted, and the
// fit is asked for them. One row at a time tests noise; all rows of a group at a time test whether
// the columns are the right ones.
//
//     const auto told = left_out(rows, values, {0, 0, 1, 2}, {});   // the first two together
#pragma once
#include <cstddef>
#include <optional>

#include "numeric/least_squares.h"

namespace bead {

// Per row, what the fit of all rows with other labels says of it; nothing where those are fewer
// than the coefficients or decide them only as combinations.
std::vector<std::optional<double>> left_out(const Rows& rows, const std::vector<double>& values,
                                            const std::vector<std::size_t>& labels,
                                            const FitOptions& options);

// 0, 1, 2, …: every row by itself.
std::vector<std::size_t> each_alone(std::size_t count);

struct RelativeErrors {
    std::size_t told = 0;      // rows of which something was said
    double mean_absolute = 0;  // of (said - value) / value, over those
    double worst = 0;          // the largest, with its sign
    std::size_t worst_row = 0;
};

// Nothing if nothing was said. Values are not 0.
std::optional<RelativeErrors> relative_errors(const std::vector<std::optional<double>>& told,
                                              const std::vector<double>& values);

}  // namespace bead
