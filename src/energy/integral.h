// Integrals of a few functions at once, where there is no closed form: by the rules of Gauss (3
// points) and Kronrod (7 points, the same three among them), halving where the two disagree.
//
//     const auto [a] = integral([](double x) { return std::array{std::sin(x)}; }, 0, pi, 1e-9);
#pragma once
#include <algorithm>
#include <array>
#include <cmath>

namespace bead {

// The sum of errors stays near `tolerance`, in the units of the result; kinks are found by halving,
// at most `depth` times.
template <class Functions>
auto integral(const Functions& f, double from, double to, double tolerance, int depth = 20) {
    constexpr std::array<double, 4> node{0, 0.434243749346802, 0.774596669241483,
                                         0.960491268708020};
    constexpr std::array<double, 4> kronrod{0.450916538658474, 0.401397414775962, 0.268488089868333,
                                            0.104656226026467};
    constexpr std::array<double, 4> gauss{8.0 / 9, 0, 5.0 / 9, 0};
    const double middle = (from + to) / 2, half = (to - from) / 2;
    decltype(f(from)) sum{}, coarse{};
    const auto add = [&](std::size_t i, double x) {
        const auto value = f(x);
        for (std::size_t k = 0; k < value.size(); ++k) {
            sum[k] += half * kronrod[i] * value[k];
            coarse[k] += half * gauss[i] * value[k];
        }
    };
    add(0, middle);
    for (std::size_t i = 1; i < node.size(); ++i) {
        add(i, middle - half * node[i]);
        add(i, middle + half * node[i]);
    }
    double error = 0;
    for (std::size_t k = 0; k < sum.size(); ++k)
        error = std::max(error, std::abs(sum[k] - coarse[k]));
    if (error <= tolerance || depth == 0) return sum;
    const auto left = integral(f, from, middle, tolerance / 2, depth - 1);
    const auto right = integral(f, middle, to, tolerance / 2, depth - 1);
    for (std::size_t k = 0; k < sum.size(); ++k) sum[k] = left[k] + right[k];
    return sum;
}

}  // namespace bead
