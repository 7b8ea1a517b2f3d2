// The scalar product of two vectors, summed from front to back.
#pragma once
#include <cstddef>
#include <span>

namespace bead {

inline double product(std::span<const double> a, std::span<const double> b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
    return sum;
}

}  // namespace bead
