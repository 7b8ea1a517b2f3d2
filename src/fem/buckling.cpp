#include "fem/buckling.h"

#include <cmath>
#include <cstdint>

#include "core/expects.h"
#include "fem/pixel_element.h"
#include "numeric/lowest_modes.h"

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

// The same on every machine; the low bits of a multiplicative generator are not used.
PixelVector noise(std::size_t count) {
    PixelVector values(count);
    std::uint64_t state = 20261125;
    for (double& value : values) {
        state = state * 6364136223846793005ULL + 1442695040888963407ULL;
        value = double(state >> 40) / double(1 << 24) - 0.5;
    }
    return values;
}

}  // namespace

PixelVector geometric_forces(const PixelModel& model, std::span<const double> displacement,
                             std::span<const double> shape) {
    return applied(geometric_of(model, displacement), model.grid, shape);
}

Buckling buckling(const PixelSolver& solver, std::span<const double> displacement,
                  const BucklingOptions& options) {
    const PixelModel& model = solver.model();
    BEAD_EXPECTS(displacement.size() == 2 * model.grid.nodes());
    const Geometric g = geometric_of(model, displacement);
    const LinearMap map = [&](std::span<const double> x) {
        PixelVector f = applied(g, model.grid, x);
        for (double& value : f) value = -value;
        return solver.solve_only(f);
    };
    const LinearMap stiffness = [&](std::span<const double> x) { return forces(model, x); };
    const Modes modes = largest_modes(
        map, stiffness,
        {.count = options.count,
         .tolerance = options.tolerance,
         .most = options.most,
         .start = options.start.empty() ? noise(displacement.size()) : options.start});
    Buckling result{.modes = {}, .converged = modes.converged, .steps = modes.steps};
    for (const Mode& mode : modes.modes) result.modes.push_back({1 / mode.value, mode.shape});
    return result;
}

}  // namespace bead
