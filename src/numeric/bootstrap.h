// How far a fit's coefficients would scatter if the measurements were made again, by case
// bootstrap (Efron 1979): rows are drawn with replacement, as many as there are, and fitted; the
// middle 95 of 100 of what comes out is the interval. Unlike standard errors it supposes nothing of
// the noise, and it shows when one row decides a coefficient.
#pragma once
#include <cstdint>

#include "numeric/least_squares.h"

namespace bead {

struct BootstrapOptions {
    int draws = 2000;  // above 0
    std::uint64_t seed = 1;
};

struct Percentiles {
    double low = 0, high = 0;  // 2.5 and 97.5 of 100
};

struct Bootstrap {
    std::vector<Percentiles> coefficients;  // empty if no draw could be fitted
    int fitted = 0;  // draws that decide all coefficients; the others are not counted
};

// The same seed draws the same rows, whatever the platform.
Bootstrap bootstrap(const Rows& rows, const std::vector<double>& values, const FitOptions& fit,
                    const BootstrapOptions& options = {});

}  // namespace bead
