#include "numeric/block_lanczos.h"

#include <gtest/gtest.h>

#include <cmath>

namespace bead {
namespace {

// A chain of springs: K is tridiagonal (2, -1), A = K⁻¹; its largest eigenvalues are
// 1 / (2 - 2 cos(k π / (n + 1))), k = 1, 2, …
constexpr std::size_t links = 60;

std::vector<double> solved(const double* f) {
    std::vector<double> c(links), x(links);
    double pivot = 2;
    x[0] = f[0] / pivot;
    for (std::size_t i = 1; i < links; ++i) {
        c[i - 1] = -1 / pivot;
        pivot = 2 + c[i - 1];
        x[i] = (f[i] + x[i - 1]) / pivot;
    }
    for (std::size_t i = links - 1; i-- > 0;) x[i] -= c[i] * x[i + 1];
    return x;
}

BlockImages images(std::span<const double> x, int columns) {
    BlockImages result{{}, {x.begin(), x.end()}};
    for (int k = 0; k < columns; ++k) {
        const std::vector<double> a = solved(&x[std::size_t(k) * links]);
        result.a.insert(result.a.end(), a.begin(), a.end());
    }
    return result;
}

std::vector<double> start(std::size_t columns) {
    std::vector<double> block;
    for (std::size_t i = 0; i < columns * links; ++i)
        block.push_back(std::sin(double(i * i % 101)));
    return block;
}

TEST(BlockLanczos, FindsTheSlowestWavesOfAChain) {
    const Modes found =
        block_modes(images, start(4), links, {.count = 3, .tolerance = 1e-8, .others = 1e-8});
    ASSERT_TRUE(found.converged);
    ASSERT_EQ(found.modes.size(), 3u);
    for (std::size_t k = 0; k < 3; ++k) {
        const double exact = 1 / (2 - 2 * std::cos(double(k + 1) * std::acos(-1.0) / (links + 1)));
        EXPECT_NEAR(found.modes[k].value / exact, 1, 1e-8);
    }
}

TEST(BlockLanczos, IsDoneSoonerFromWhereItWas) {
    const BlockOptions options{.count = 3, .tolerance = 1e-6, .others = 1e-6};
    const Modes first = block_modes(images, start(4), links, options);
    std::vector<double> known;
    for (const Mode& mode : first.modes)
        known.insert(known.end(), mode.shape.begin(), mode.shape.end());
    const Modes again = block_modes(images, known, links, options);
    ASSERT_TRUE(again.converged);
    EXPECT_LE(again.steps, first.steps);
    EXPECT_NEAR(again.modes[0].value, first.modes[0].value, 1e-6 * first.modes[0].value);
}

}  // namespace
}  // namespace bead
