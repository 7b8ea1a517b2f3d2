#include "fem/grid_operator.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "fem/grid_multigrid.h"
#include "numeric/frontal_cholesky.h"

namespace bead {
namespace {

// The hex8's stiffness as textbooks have it: 2 x 2 x 2 Gauss points of B^T D B; by node, then
// component; nodes with x running fastest.
std::vector<double> textbook_cube(double lambda, double mu, double size) {
    std::vector<double> k(24 * 24, 0.0);
    const double g = 1 / std::sqrt(3.0);
    for (int point = 0; point < 8; ++point) {
        const double at[3] = {point & 1 ? g : -g, point & 2 ? g : -g, point & 4 ? g : -g};
        double slope[8][3];
        for (int n = 0; n < 8; ++n) {
            const double s[3] = {n & 1 ? 1. : -1., n & 2 ? 1. : -1., n & 4 ? 1. : -1.};
            for (int a = 0; a < 3; ++a) {
                slope[n][a] = s[a] / 8 * 2 / size;
                for (int b = 0; b < 3; ++b)
                    if (b != a) slope[n][a] *= 1 + s[b] * at[b];
            }
        }
        const double weight = size * size * size / 8;
        for (int m = 0; m < 8; ++m)
            for (int n = 0; n < 8; ++n)
                for (int a = 0; a < 3; ++a)
                    for (int b = 0; b < 3; ++b) {
                        double value =
                            lambda * slope[m][a] * slope[n][b] + mu * slope[m][b] * slope[n][a];
                        if (a == b)
                            for (int c = 0; c < 3; ++c) value += mu * slope[m][c] * slope[n][c];
                        k[std::size_t((3 * m + a) * 24 + 3 * n + b)] += weight * value;
                    }
    }
    return k;
}

struct Cubes {
    ElasticGrid grid;
    ElementPattern pattern;
    std::vector<double> element;
    std::vector<std::size_t> cells;  // of the pattern's elements
};

Cubes cubes(std::array<int, 3> n, unsigned seed) {
    const double lambda = 1.3, mu = 0.7, size = 0.5;
    Cubes c{{3, n, {}, {}, lambda * size, mu * size},
            {3, 8, {}, {}},
            textbook_cube(lambda, mu, size),
            {}};
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> uniform(0, 1);
    const int nx = n[0] + 1, ny = n[1] + 1;
    for (int z = 0; z <= n[2]; ++z)
        for (int y = 0; y < ny; ++y)
            for (int x = 0; x < nx; ++x) c.pattern.places.push_back({float(x), float(y), float(z)});
    for (int z = 0; z < n[2]; ++z)
        for (int y = 0; y < n[1]; ++y)
            for (int x = 0; x < n[0]; ++x) {
                const bool solid = x == 0 || uniform(random) > 0.1F;
                c.grid.factor.push_back(solid ? 0.5F + uniform(random) : 0);
                if (!solid) continue;
                c.cells.push_back(c.grid.factor.size() - 1);
                for (int k = 0; k < 8; ++k)
                    c.pattern.points.push_back(((z + (k >> 2)) * ny + y + (k >> 1) % 2) * nx + x +
                                               k % 2);
            }
    return c;
}

std::vector<double> summed(const Cubes& c, const std::vector<double>& u) {
    std::vector<double> f(u.size(), 0.0);
    for (std::size_t e = 0; e < c.cells.size(); ++e)
        for (std::size_t i = 0; i < 24; ++i)
            for (std::size_t j = 0; j < 24; ++j) {
                const auto at = [&](std::size_t k) {
                    return 3 * std::size_t(c.pattern.points[8 * e + k / 3]) + k % 3;
                };
                f[at(i)] += double(c.grid.factor[c.cells[e]]) * c.element[24 * i + j] * u[at(j)];
            }
    return f;
}

TEST(CubeOperator, IsTheTextbooksStiffness) {
    const Cubes c = cubes({4, 3, 5}, 1);
    const std::size_t nodes = c.grid.nodes();
    std::mt19937 random(2);
    std::uniform_real_distribution<double> uniform(-1, 1);
    std::vector<double> u(3 * nodes), split(3 * nodes), result(3 * nodes);
    for (std::size_t i = 0; i < u.size(); ++i) {
        u[i] = uniform(random);
        split[i % 3 * nodes + i / 3] = u[i];
    }
    multiply(c.grid, split.data(), result.data());
    const std::vector<double> wanted = summed(c, u);
    for (std::size_t i = 0; i < u.size(); ++i)
        EXPECT_NEAR(result[i % 3 * nodes + i / 3], wanted[i], 1e-12);
    const std::vector<float> d = diagonal(c.grid);
    for (std::size_t i = 0; i < u.size(); ++i) {
        std::vector<double> one(u.size(), 0.0);
        one[i] = 1;
        EXPECT_NEAR(double(d[i % 3 * nodes + i / 3]), summed(c, one)[i], 1e-5);
    }
}

TEST(CubeMultigrid, AgreesWithTheDirectSolver) {
    const Cubes c = cubes({21, 14, 11}, 3);
    std::vector<std::uint8_t> held(c.grid.unknowns(), 0);
    std::vector<double> load(held.size(), 0.0);
    for (std::size_t node = 0; node < c.grid.nodes(); ++node) {
        if (node % 22 == 0) held[3 * node] = held[3 * node + 1] = held[3 * node + 2] = 1;
    }
    for (const int point : c.pattern.points) load[3 * std::size_t(point) + 1] = -1;
    const Displacement u = multigrid_solution(c.grid, held, load, {.tolerance = 1e-10});
    EXPECT_TRUE(u.converged) << u.iterations << " " << u.residual;
    const FrontalCholesky direct(
        elimination_tree(c.pattern),
        [&](std::size_t e, std::span<double> values) {
            for (std::size_t i = 0; i < values.size(); ++i)
                values[i] = double(c.grid.factor[c.cells[e]]) * c.element[i];
        },
        held);
    ASSERT_FALSE(direct.singular());
    const std::vector<double> exact = direct.solve(load);
    double gap = 0, size = 0;
    for (std::size_t i = 0; i < exact.size(); ++i) {
        gap = std::max(gap, std::abs(u.values[i] - exact[i]));
        size = std::max(size, std::abs(exact[i]));
    }
    EXPECT_LT(gap, 1e-6 * size);
}

}  // namespace
}  // namespace bead
