#include "fem/grid_multigrid.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/expects.h"
#include "numeric/frontal_cholesky.h"
#include "numeric/product.h"

namespace bead {
namespace {

constexpr std::size_t small = 4000;  // unknowns that are factored
constexpr double smoothed = 6;       // the smoother takes eigenvalues from the largest / this

struct Level {
    ElasticGrid grid;
    std::vector<float> inverse;      // of K's diagonal; 0 where held or nothing is
    std::vector<std::size_t> held;   // unknowns, by component
    std::vector<float> x, r, d, kd;  // of the cycle
};

ElasticGrid coarser(const ElasticGrid& fine) {
    ElasticGrid coarse{fine.dimensions, {}, {}, fine.law, 2 * fine.lambda, 2 * fine.mu};
    for (std::size_t axis = 0; axis < 3; ++axis) coarse.cells[axis] = (fine.cells[axis] + 1) / 2;
    const auto count = [](int cells) { return std::size_t(std::max(cells, 1)); };
    const std::size_t cx = count(coarse.cells[0]), cy = count(coarse.cells[1]);
    coarse.factor.assign(cx * cy * count(coarse.cells[2]), 0.0F);
    const float share = fine.dimensions == 2 ? 0.25F : 0.125F;
    std::size_t cell = 0;
    for (std::size_t z = 0; z < count(fine.cells[2]); ++z)
        for (std::size_t y = 0; y < count(fine.cells[1]); ++y)
            for (std::size_t x = 0; x < count(fine.cells[0]); ++x, ++cell)
                coarse.factor[(z / 2 * cy + y / 2) * cx + x / 2] += share * fine.factor[cell];
    return coarse;
}

std::array<std::size_t, 3> counts(const ElasticGrid& grid) {
    return {std::size_t(grid.cells[0]) + 1, std::size_t(grid.cells[1]) + 1,
            std::size_t(grid.cells[2]) + 1};
}

// A coarse unknown is held where one of the fine nodes that it moves is.
std::vector<std::size_t> coarser_held(const Level& fine, const ElasticGrid& coarse) {
    const auto n = counts(fine.grid), m = counts(coarse);
    std::vector<std::uint8_t> mark(coarse.unknowns(), 0);
    for (const std::size_t unknown : fine.held) {
        const std::size_t node = unknown % fine.grid.nodes(), c = unknown / fine.grid.nodes();
        const std::size_t x = node % n[0], y = node / n[0] % n[1], z = node / (n[0] * n[1]);
        for (std::size_t k = z / 2; k <= (z + 1) / 2; ++k)
            for (std::size_t j = y / 2; j <= (y + 1) / 2; ++j)
                for (std::size_t i = x / 2; i <= (x + 1) / 2; ++i)
                    mark[c * coarse.nodes() + (k * m[1] + j) * m[0] + i] = 1;
    }
    std::vector<std::size_t> held;
    for (std::size_t i = 0; i < mark.size(); ++i)
        if (mark[i] != 0) held.push_back(i);
    return held;
}

Level level_of(ElasticGrid grid, std::vector<std::size_t> held) {
    Level level{std::move(grid), {}, std::move(held), {}, {}, {}, {}};
    level.inverse = diagonal(level.grid);
    for (float& value : level.inverse) value = value > 0 ? 1 / value : 0;
    for (const std::size_t unknown : level.held) level.inverse[unknown] = 0;
    for (std::vector<float>* v : {&level.x, &level.r, &level.d, &level.kd})
        v->assign(level.grid.unknowns(), 0.0F);
    return level;
}

// The coarse nodes that a fine one lies between along one axis, both the same on one of them.
struct Between {
    std::size_t low, high;
};
Between between(std::size_t i) { return {i / 2, (i + 1) / 2}; }

// x += P x_coarse, where there is something to move.
void prolong(const Level& coarse, Level& fine) {
    const auto n = counts(fine.grid), m = counts(coarse.grid);
    for (std::size_t c = 0; c < std::size_t(fine.grid.dimensions); ++c) {
        const float* from = coarse.x.data() + c * coarse.grid.nodes();
        std::size_t at = c * fine.grid.nodes();
        for (std::size_t z = 0; z < n[2]; ++z)
            for (std::size_t y = 0; y < n[1]; ++y) {
                const auto [y0, y1] = between(y);
                const auto [z0, z1] = between(z);
                const float* a = from + (z0 * m[1] + y0) * m[0];
                const float* b = from + (z0 * m[1] + y1) * m[0];
                const float* e = from + (z1 * m[1] + y0) * m[0];
                const float* f = from + (z1 * m[1] + y1) * m[0];
                for (std::size_t x = 0; x < n[0]; ++x, ++at) {
                    if (fine.inverse[at] == 0) continue;
                    const auto [x0, x1] = between(x);
                    fine.x[at] +=
                        0.125F * (a[x0] + a[x1] + b[x0] + b[x1] + e[x0] + e[x1] + f[x0] + f[x1]);
                }
            }
    }
}

// r_coarse = P^T r.
void restrict_to(const Level& fine, Level& coarse) {
    const auto n = counts(fine.grid), m = counts(coarse.grid);
    std::ranges::fill(coarse.r, 0.0F);
    for (std::size_t c = 0; c < std::size_t(fine.grid.dimensions); ++c) {
        float* to = coarse.r.data() + c * coarse.grid.nodes();
        std::size_t at = c * fine.grid.nodes();
        for (std::size_t z = 0; z < n[2]; ++z)
            for (std::size_t y = 0; y < n[1]; ++y) {
                const auto [y0, y1] = between(y);
                const auto [z0, z1] = between(z);
                const std::array<std::size_t, 4> rows{
                    (z0 * m[1] + y0) * m[0], (z0 * m[1] + y1) * m[0], (z1 * m[1] + y0) * m[0],
                    (z1 * m[1] + y1) * m[0]};
                for (std::size_t x = 0; x < n[0]; ++x, ++at) {
                    if (fine.inverse[at] == 0) continue;
                    const float share = 0.125F * fine.r[at];
                    const auto [x0, x1] = between(x);
                    for (const std::size_t row : rows) {
                        to[row + x0] += share;
                        to[row + x1] += share;
                    }
                }
            }
    }
}

class Cycle {
  public:
    Cycle(ElasticGrid grid, std::vector<std::size_t> held) {
        largest_ = largest_eigenvalue(grid);
        levels_.push_back(level_of(std::move(grid), std::move(held)));
        while (levels_.back().grid.unknowns() > small) {
            ElasticGrid next = coarser(levels_.back().grid);
            std::vector<std::size_t> held_there = coarser_held(levels_.back(), next);
            levels_.push_back(level_of(std::move(next), std::move(held_there)));
        }
        factor_coarsest();
    }

    // The answer is in finest().x.
    void run() { descend(0); }
    Level& finest() { return levels_.front(); }

  private:
    void factor_coarsest();
    void solve_coarsest();
    void descend(std::size_t l);
    void smooth(Level& level, bool from_zero) const;

    std::vector<Level> levels_;
    double largest_ = 1;
    std::optional<FrontalCholesky> coarsest_;
};

void Cycle::factor_coarsest() {
    const ElasticGrid& grid = levels_.back().grid;
    const auto n = counts(grid);
    const auto c = std::size_t(grid.dimensions), corners = std::size_t(1) << c;
    ElasticGrid one{grid.dimensions, {1, 1, grid.dimensions == 3 ? 1 : 0},
                    {1.0F},          grid.law,
                    grid.lambda,     grid.mu};
    const std::size_t size = c * corners;
    std::vector<double> unit_matrix(size * size), unit_value(size), column(size);
    for (std::size_t j = 0; j < size; ++j) {  // by corner, then component
        std::ranges::fill(unit_value, 0.0);
        unit_value[j % c * corners + j / c] = 1;
        multiply(one, unit_value.data(), column.data());
        for (std::size_t i = 0; i < size; ++i)
            unit_matrix[j * size + i] = column[i % c * corners + i / c];
    }
    ElementPattern pattern{int(c), int(corners), {}, {}};
    for (std::size_t i = 0; i < grid.nodes(); ++i) {
        const std::size_t layer = i / (n[0] * n[1]);
        pattern.places.push_back({float(i % n[0]), float(i / n[0] % n[1]), float(layer)});
    }
    std::vector<float> factors;
    for (std::size_t cell = 0; cell < grid.factor.size(); ++cell) {
        if (grid.factor[cell] == 0) continue;
        factors.push_back(grid.factor[cell]);
        const std::size_t x = cell % (n[0] - 1), y = cell / (n[0] - 1) % (n[1] - 1);
        const std::size_t z = cell / ((n[0] - 1) * (n[1] - 1));
        for (std::size_t k = 0; k < corners; ++k)
            pattern.points.push_back(int(((z + k / 4) * n[1] + y + k / 2 % 2) * n[0] + x + k % 2));
    }
    std::vector<std::uint8_t> held(grid.unknowns(), 0);
    for (const std::size_t unknown : levels_.back().held)
        held[unknown % grid.nodes() * c + unknown / grid.nodes()] = 1;
    coarsest_.emplace(
        elimination_tree(std::move(pattern)),
        [&](std::size_t e, std::span<double> values) {
            for (std::size_t i = 0; i < values.size(); ++i)
                values[i] = double(factors[e]) * unit_matrix[i];
        },
        held);
}

void Cycle::solve_coarsest() {
    Level& level = levels_.back();
    const std::size_t nodes = level.grid.nodes(), c = std::size_t(level.grid.dimensions);
    if (coarsest_->singular()) {  // nothing holds it there; Jacobi then
        for (std::size_t i = 0; i < level.x.size(); ++i) level.x[i] = level.inverse[i] * level.r[i];
        return;
    }
    std::vector<double> right(level.r.size());
    for (std::size_t i = 0; i < right.size(); ++i)
        right[i % nodes * c + i / nodes] = double(level.r[i]);
    const std::vector<double> x = coarsest_->solve(right);
    for (std::size_t i = 0; i < right.size(); ++i) level.x[i] = float(x[i % nodes * c + i / nodes]);
}

// Two steps of Chebyshev's iteration on x; r is the residual before and after the first step.
void Cycle::smooth(Level& level, bool from_zero) const {
    const double high = 1.05 * largest_, low = largest_ / smoothed;
    const double theta = (high + low) / 2, delta = (high - low) / 2;
    const double rho = 1 / (2 * theta / delta - delta / theta);
    const auto first = float(1 / theta), keep = float(rho * delta / theta);
    const auto gain = float(2 * rho / delta);
    const std::size_t n = level.x.size();
    for (std::size_t i = 0; i < n; ++i) level.d[i] = first * level.inverse[i] * level.r[i];
    if (from_zero)
        std::ranges::copy(level.d, level.x.begin());
    else
        for (std::size_t i = 0; i < n; ++i) level.x[i] += level.d[i];
    multiply(level.grid, level.d.data(), level.kd.data());
    for (std::size_t i = 0; i < n; ++i) {
        const float d = keep * level.d[i] + gain * level.inverse[i] * (level.r[i] - level.kd[i]);
        level.x[i] += d;
    }
}

void Cycle::descend(std::size_t l) {
    if (l + 1 == levels_.size()) return solve_coarsest();
    Level &level = levels_[l], &below = levels_[l + 1];
    smooth(level, true);
    multiply(level.grid, level.x.data(), level.kd.data());
    // The residual goes down; the right side is needed again on the way up.
    std::swap(level.r, level.d);
    for (std::size_t i = 0; i < level.r.size(); ++i) level.r[i] = level.d[i] - level.kd[i];
    restrict_to(level, below);
    std::swap(level.r, level.d);
    descend(l + 1);
    prolong(below, level);
    multiply(level.grid, level.x.data(), level.kd.data());
    for (std::size_t i = 0; i < level.r.size(); ++i) level.r[i] -= level.kd[i];
    smooth(level, false);
}

class Gradients {
  public:
    Gradients(Cycle& cycle, std::vector<double> right) : cycle_(cycle), r_(std::move(right)) {}

    Displacement run(const MultigridOptions& options) {
        Displacement s;
        x_.assign(r_.size(), 0.0);
        p_ = kp_ = x_;
        const double size = std::sqrt(product(r_, r_));
        double rz = 0, now = size;
        while (now > options.tolerance * size && s.iterations < options.most) {
            const double next = precondition(now);
            if (!(next > 0)) break;
            const Level& fine = cycle_.finest();
            const double beta = rz > 0 ? next / rz : 0;
            for (std::size_t i = 0; i < p_.size(); ++i)
                p_[i] = now * double(fine.x[i]) + beta * p_[i];
            rz = next;
            now = advance(rz);
            ++s.iterations;
        }
        s.residual = size > 0 ? now / size : 0;
        s.converged = now <= options.tolerance * size;
        s.values = std::move(x_);
        return s;
    }

  private:
    // Scaled by the residual's size, so that single precision does not run out of range.
    double precondition(double now) {
        Level& fine = cycle_.finest();
        for (std::size_t i = 0; i < r_.size(); ++i) fine.r[i] = float(r_[i] / now);
        cycle_.run();
        double sum = 0;
        for (std::size_t i = 0; i < r_.size(); ++i) sum += r_[i] * double(fine.x[i]);
        return sum * now;
    }
    double advance(double rz) {
        const Level& fine = cycle_.finest();
        multiply(fine.grid, p_.data(), kp_.data());
        for (const std::size_t unknown : fine.held) kp_[unknown] = 0;
        const double step = rz / product(p_, kp_);
        double sum = 0;
        for (std::size_t i = 0; i < r_.size(); ++i) {
            x_[i] += step * p_[i];
            r_[i] -= step * kp_[i];
            sum += r_[i] * r_[i];
        }
        return std::sqrt(sum);
    }

    Cycle& cycle_;
    std::vector<double> x_, r_, p_, kp_;
};

}  // namespace

Displacement multigrid_solution(ElasticGrid grid, std::span<const std::uint8_t> held,
                                std::span<const double> load, const MultigridOptions& options) {
    const std::size_t nodes = grid.nodes(), c = std::size_t(grid.dimensions);
    BEAD_EXPECTS(held.size() == grid.unknowns() && load.size() == grid.unknowns());
    std::vector<std::size_t> held_there;
    for (std::size_t i = 0; i < held.size(); ++i)
        if (held[i] != 0) held_there.push_back(i % c * nodes + i / c);
    std::ranges::sort(held_there);
    Cycle cycle(std::move(grid), std::move(held_there));
    std::vector<double> right(load.size());
    for (std::size_t i = 0; i < load.size(); ++i)
        if (const std::size_t at = i % c * nodes + i / c; cycle.finest().inverse[at] != 0)
            right[at] = load[i];
    Displacement s = Gradients(cycle, std::move(right)).run(options);
    std::vector<double> by_node(load.size());
    for (std::size_t i = 0; i < by_node.size(); ++i) by_node[i] = s.values[i % c * nodes + i / c];
    s.values = std::move(by_node);
    return s;
}

}  // namespace bead
