#include "numeric/frontal_cholesky.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <random>
#include <set>

namespace bead {
namespace {

// Random springs between neighbours on a lattice: every element is a random positive matrix.
struct Net {
    ElementPattern pattern;
    std::vector<std::vector<double>> matrices;
};

Net net(unsigned seed, int columns, int rows) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> uniform(-1, 1);
    Net n;
    n.pattern.points_per_element = 3;
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i < columns; ++i) n.pattern.places.push_back({float(i), float(j), 0});
    for (int j = 0; j + 1 < rows; ++j)
        for (int i = 0; i + 1 < columns; ++i) {
            if (uniform(random) < -0.6) continue;
            const int a = j * columns + i;
            for (const int p : {a, a + 1, a + columns}) n.pattern.points.push_back(p);
            std::vector<double> factor(36), matrix(36, 0.0);
            for (double& value : factor) value = uniform(random);
            for (std::size_t r = 0; r < 6; ++r)
                for (std::size_t c = 0; c < 6; ++c)
                    for (std::size_t k = 0; k < 6; ++k)
                        matrix[6 * r + c] += factor[6 * r + k] * factor[6 * c + k];
            n.matrices.push_back(matrix);
        }
    return n;
}

std::vector<double> times(const Net& n, const std::vector<double>& x) {
    std::vector<double> y(x.size(), 0.0);
    for (std::size_t e = 0; e < n.matrices.size(); ++e)
        for (std::size_t r = 0; r < 6; ++r)
            for (std::size_t c = 0; c < 6; ++c) {
                const auto at = [&](std::size_t k) {
                    return 2 * std::size_t(n.pattern.points[3 * e + k / 2]) + k % 2;
                };
                y[at(r)] += n.matrices[e][6 * r + c] * x[at(c)];
            }
    return y;
}

RC_GTEST_PROP(FrontalCholesky, solves_what_the_sum_multiplies, (unsigned seed)) {
    const Net n = net(seed, 5 + int(seed % 13), 4 + int(seed % 7));
    if (n.matrices.empty()) return;
    std::mt19937 random(seed + 1);
    std::uniform_real_distribution<double> uniform(-1, 1);
    std::vector<std::uint8_t> held(2 * n.pattern.places.size(), 0), used = held;
    for (const int p : n.pattern.points)
        used[2 * std::size_t(p)] = used[2 * std::size_t(p) + 1] = 1;
    std::vector<double> x(held.size(), 0.0);
    for (std::size_t i = 0; i < x.size(); ++i) {
        held[i] = uniform(random) < -0.8;
        if (used[i] != 0 && held[i] == 0) x[i] = uniform(random);
    }
    const FrontalCholesky factor(
        elimination_tree(n.pattern),
        [&](std::size_t e, std::span<double> values) {
            std::ranges::copy(n.matrices[e], values.begin());
        },
        held);
    RC_ASSERT(!factor.singular());
    const std::vector<double> b = times(n, x), found = factor.solve(b);
    const std::vector<double> again = times(n, found);
    double error = 0, size = 0;
    for (std::size_t i = 0; i < b.size(); ++i) {
        if (held[i] == 0) error = std::max(error, std::abs(again[i] - b[i]));
        size = std::max(size, std::abs(b[i]));
        if (held[i] != 0 || used[i] == 0) RC_ASSERT(found[i] == 0);
    }
    RC_ASSERT(error <= 1e-9 * size);
}

RC_GTEST_PROP(EliminationTree, takes_every_point_and_element_once, (unsigned seed)) {
    const Net n = net(seed, 6 + int(seed % 20), 5 + int(seed % 11));
    const EliminationTree tree = elimination_tree(n.pattern);
    std::multiset<int> points, elements;
    std::vector<int> front_of(n.pattern.places.size(), -1);
    for (std::size_t f = 0; f < tree.fronts.size(); ++f) {
        points.insert(tree.fronts[f].own.begin(), tree.fronts[f].own.end());
        elements.insert(tree.fronts[f].elements.begin(), tree.fronts[f].elements.end());
        for (const int p : tree.fronts[f].own) front_of[std::size_t(p)] = int(f);
        RC_ASSERT(tree.fronts[f].parent == -1 || tree.fronts[f].parent > int(f));
    }
    const std::set<int> used(n.pattern.points.begin(), n.pattern.points.end());
    RC_ASSERT(points.size() == used.size());
    RC_ASSERT(elements.size() == n.matrices.size());
    for (std::size_t f = 0; f < tree.fronts.size(); ++f)
        for (const int p : tree.fronts[f].border) RC_ASSERT(front_of[std::size_t(p)] > int(f));
}

}  // namespace
}  // namespace bead
