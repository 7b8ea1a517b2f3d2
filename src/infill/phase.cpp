#include "infill/phase.h"

#include <cmath>
#include <random>
#include <span>

#include "core/expects.h"
#include "numeric/frontal_cholesky.h"

namespace bead {
namespace {

constexpr double softness = 1e-7;  // keeps the matrix definite where a perfect phase exists

ElementPattern pattern_of(const StripeGrid& grid) {
    ElementPattern pattern;
    pattern.points_per_element = 2;
    for (const Vec2 p : grid.places)
        pattern.places.push_back({static_cast<float>(p.x), static_cast<float>(p.y), 0.0F});
    for (const auto& edge : grid.edges)
        pattern.points.insert(pattern.points.end(), edge.begin(), edge.end());
    return pattern;
}

// |ψ_j - R ψ_i|² as a matrix of (Re ψ_i, Im ψ_i, Re ψ_j, Im ψ_j).
void fill_edge(const PhaseStep& step, std::span<double> matrix) {
    const double c = std::cos(step.growth), s = std::sin(step.growth), sign = step.flips ? -1 : 1;
    const double r[2][2] = {{c, -s}, {sign * s, sign * c}};
    for (double& entry : matrix) entry = 0;
    for (std::size_t a = 0; a < 4; ++a) matrix[4 * a + a] = 1 + softness;
    for (std::size_t a = 0; a < 2; ++a)
        for (std::size_t b = 0; b < 2; ++b)
            matrix[4 * (2 + a) + b] = matrix[4 * b + 2 + a] = -r[a][b];
}

void normalize(std::vector<double>& x) {
    double square = 0;
    for (const double v : x) square += v * v;
    for (double& v : x) v /= std::sqrt(square);
}

}  // namespace

std::vector<double> best_phase(const StripeGrid& grid, std::uint32_t seed, int iterations) {
    const std::vector<std::uint8_t> held(2 * grid.places.size(), 0);
    const FrontalCholesky factor(
        elimination_tree(pattern_of(grid)),
        [&](std::size_t e, std::span<double> matrix) {
            fill_edge(phase_step(grid, grid.edges[e][0], grid.edges[e][1]), matrix);
        },
        held);
    BEAD_EXPECTS(!factor.singular());
    std::mt19937 random(seed);
    std::vector<double> x(held.size());
    for (double& v : x) v = static_cast<double>(random()) / 4294967296.0 - 0.5;
    for (int i = 0; i < iterations; ++i) {
        normalize(x);
        x = factor.solve(x);
    }
    std::vector<double> phase;
    for (std::size_t v = 0; v < grid.places.size(); ++v)
        phase.push_back(std::atan2(x[2 * v + 1], x[2 * v]));
    return phase;
}

}  // namespace bead
