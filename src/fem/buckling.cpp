#include "fem/buckling.h"

#include <array>
#include <cmath>
#include <cstdint>

#include "core/expects.h"
#include "fem/pixel_element.h"
#include "fem/start_noise.h"
#include "numeric/block_lanczos.h"

namespace bead {
namespace {

// A 4 x 4 symmetric matrix on the corners' x or y, the same for both.
using CornerMatrix = std::array<double, 16>;

// The integral of dN^T S dN over the square for a stress that is bilinear, by the 2 x 2 Gauss rule.
CornerMatrix geometric_stiffness(const PlaneLaw& law, const SquareModes& modes) {
    CornerMatrix matrix{};
    const double g = 1 / std::sqrt(3.0);
    constexpr double cx[] = {-1, 1, 1, -1}, cy[] = {-1, -1, 1, 1};
    for (const double x : {-g, g})
        for (const double y : {-g, g}) {
            const PlaneTensor s = stress_of(law, strain_at(modes, x, y));
            double nx[4], ny[4];
            for (int c = 0; c < 4; ++c) {
                nx[c] = cx[c] * (1 + cy[c] * y) / 4;
                ny[c] = cy[c] * (1 + cx[c] * x) / 4;
            }
            for (std::size_t a = 0; a < 4; ++a)
                for (std::size_t b = 0; b < 4; ++b)
                    matrix[4 * a + b] += s.xx * nx[a] * nx[b] + s.yy * ny[a] * ny[b] +
                                         s.xy * (nx[a] * ny[b] + ny[a] * nx[b]);
        }
    return matrix;
}

struct Geometric {
    std::vector<std::size_t> pixels;
    std::vector<CornerMatrix> matrices;
};

// Strains come as half a side times strain; the integral's own factors cancel but for 2 / side.
Geometric geometric_of(const PixelModel& model, std::span<const double> displacement) {
    Geometric g;
    for (std::size_t pixel = 0; pixel < model.factor.size(); ++pixel) {
        if (model.factor[pixel] == 0) continue;
        const CornerValues u = corner_values(displacement, model.grid.corners(pixel));
        const double scale = model.thickness * 2 / model.grid.size;
        g.pixels.push_back(pixel);
        g.matrices.push_back(geometric_stiffness(scale * law_of(model, pixel), modes_of(u)));
    }
    return g;
}

PixelVector applied(const Geometric& g, const PixelGrid& grid, std::span<const double> x) {
    PixelVector result(x.size(), 0.0);
    for (std::size_t k = 0; k < g.pixels.size(); ++k) {
        const auto corners = grid.corners(g.pixels[k]);
        for (std::size_t a = 0; a < 4; ++a)
            for (std::size_t b = 0; b < 4; ++b) {
                const double m = g.matrices[k][4 * a + b];
                result[2 * corners[a]] += m * x[2 * corners[b]];
                result[2 * corners[a] + 1] += m * x[2 * corners[b] + 1];
            }
    }
    return result;
}

// -Kg on vectors over the solid nodes only.
class Packed {
  public:
    Packed(const PixelSolver& solver, std::span<const double> displacement)
        : solver_(solver), geometric_(geometric_of(solver.model(), displacement)) {
        const PixelGrid& grid = solver.model().grid;
        std::vector<std::size_t> point(grid.nodes());
        for (std::size_t p = 0; p < nodes().size(); ++p) {
            point[nodes()[p]] = p;
            for (std::size_t c = 0; c < 2; ++c) held_.push_back(solver.held()[2 * nodes()[p] + c]);
        }
        for (const std::size_t pixel : geometric_.pixels) {
            std::array<std::size_t, 4> corners = grid.corners(pixel);
            for (std::size_t& corner : corners) corner = 2 * point[corner];
            corners_.push_back(corners);
        }
    }

    [[nodiscard]] std::size_t size() const { return held_.size(); }

    [[nodiscard]] std::vector<double> turned_forces(std::span<const double> x, int columns) const {
        std::vector<double> f(x.size(), 0.0);
        for (std::size_t first = 0; first < size() * std::size_t(columns); first += size()) {
            for (std::size_t k = 0; k < corners_.size(); ++k)
                subtract(geometric_.matrices[k], corners_[k], &x[first], &f[first]);
            for (std::size_t i = 0; i < size(); ++i)
                if (held_[i] != 0) f[first + i] = 0;
        }
        return f;
    }

    // The guesses and a block of noise.
    [[nodiscard]] std::vector<double> start(const std::vector<PixelVector>& guesses) const {
        constexpr std::size_t whole = 8;  // a block of the solver
        std::vector<double> block;
        for (const PixelVector& guess : guesses)
            for (const std::size_t node : nodes())
                block.insert(block.end(), {guess[2 * node], guess[2 * node + 1]});
        const std::size_t rest = whole - guesses.size() % whole;
        const std::vector<double> more = guesses.empty() || rest < whole
                                             ? start_noise(size() * rest, 20261125)
                                             : std::vector<double>{};
        block.insert(block.end(), more.begin(), more.end());
        return block;
    }

    [[nodiscard]] PixelVector unpacked(const std::vector<double>& x) const {
        PixelVector all(2 * solver_.model().grid.nodes(), 0.0);
        for (std::size_t p = 0; p < nodes().size(); ++p) {
            all[2 * nodes()[p]] = x[2 * p];
            all[2 * nodes()[p] + 1] = x[2 * p + 1];
        }
        return all;
    }

  private:
    [[nodiscard]] const std::vector<std::size_t>& nodes() const { return solver_.solid_nodes(); }

    static void subtract(const CornerMatrix& g, const std::array<std::size_t, 4>& at,
                         const double* x, double* f) {
        for (std::size_t a = 0; a < 4; ++a) {
            double fx = 0, fy = 0;
            for (std::size_t b = 0; b < 4; ++b) {
                fx += g[4 * a + b] * x[at[b]];
                fy += g[4 * a + b] * x[at[b] + 1];
            }
            f[at[a]] -= fx;
            f[at[a] + 1] -= fy;
        }
    }

    const PixelSolver& solver_;
    Geometric geometric_;
    std::vector<std::uint8_t> held_;
    std::vector<std::array<std::size_t, 4>> corners_;  // first unknown of each
};

}  // namespace

PixelVector geometric_forces(const PixelModel& model, std::span<const double> displacement,
                             std::span<const double> shape) {
    return applied(geometric_of(model, displacement), model.grid, shape);
}

Buckling buckling(const PixelSolver& solver, std::span<const double> displacement,
                  const BucklingOptions& options) {
    const PixelModel& model = solver.model();
    BEAD_EXPECTS(displacement.size() == 2 * model.grid.nodes());
    const Packed packed(solver, displacement);
    const BlockMap map = [&](std::span<const double> x, int columns) {
        std::vector<double> f = packed.turned_forces(x, columns);
        std::vector<double> moved = solver.solve_packed(f, columns);
        return BlockImages{std::move(moved), std::move(f)};
    };
    const Modes modes = block_modes(map, packed.start(options.start), packed.size(),
                                    {.count = options.count,
                                     .tolerance = options.tolerance,
                                     .others = options.others,
                                     .most = options.most});
    Buckling result{.modes = {}, .converged = modes.converged, .steps = modes.steps};
    for (const Mode& mode : modes.modes)
        result.modes.push_back({1 / mode.value, packed.unpacked(mode.shape)});
    return result;
}

}  // namespace bead
