#include "strength/coarse_modes.h"

#include <algorithm>
#include <cmath>

namespace bead {
namespace {

constexpr double coarsest = 0.5;         // of the bead's width, pixels
constexpr double least_step = 1.5;       // from pixels to coarser ones
constexpr int count = 8;                 // modes, as many as a solver takes at once
constexpr double tolerance = 0.04;       // of the first; the others are guesses anyway
constexpr double start_tolerance = 0.4;  // of the first, where all are guesses
constexpr double other_tolerance = 4;
constexpr int most_vectors = 64;

std::vector<std::uint8_t> solid_nodes(const PixelModel& model) {
    std::vector<std::uint8_t> solid(model.grid.nodes(), 0);
    for (std::size_t pixel = 0; pixel < model.factor.size(); ++pixel)
        if (model.factor[pixel] > 0)
            for (const std::size_t node : model.grid.corners(pixel)) solid[node] = 1;
    return solid;
}

}  // namespace

PixelVector transferred(const PixelModel& coarse, std::span<const double> shape,
                        const PixelGrid& grid) {
    const std::vector<std::uint8_t> solid = solid_nodes(coarse);
    const PixelGrid& from = coarse.grid;
    PixelVector result(2 * grid.nodes(), 0.0);
    for (std::size_t node = 0; node < grid.nodes(); ++node) {
        const Vec2 at = (grid.place(node) - from.origin) / from.size;
        const int i = std::clamp(static_cast<int>(at.x), 0, from.columns - 1);
        const int j = std::clamp(static_cast<int>(at.y), 0, from.rows - 1);
        const double x = std::clamp(at.x - i, 0.0, 1.0), y = std::clamp(at.y - j, 0.0, 1.0);
        const std::array<std::size_t, 4> corners = from.corners(from.pixel(i, j));
        const std::array<double, 4> nearness{(1 - x) * (1 - y), x * (1 - y), x * y, (1 - x) * y};
        double weight = 0;
        Vec2 sum;
        for (std::size_t c = 0; c < 4; ++c) {
            if (solid[corners[c]] == 0) continue;
            weight += nearness[c];
            sum = sum + nearness[c] * Vec2{shape[2 * corners[c]], shape[2 * corners[c] + 1]};
        }
        if (!(weight > 0)) continue;
        result[2 * node] = sum.x / weight;
        result[2 * node + 1] = sum.y / weight;
    }
    return result;
}

CoarseModes::CoarseModes(std::span<const Toolpath> layers, const LoadCase& load_case, double pixel)
    : rig_(TestRig::of(layers, load_case, {.pixel = pixel})) {
    const double coarse = coarsest * load_case.print.bead_width;
    if (least_step * pixel <= coarse)
        coarser_ = std::make_unique<CoarseModes>(layers, load_case, coarse);
}

Buckling CoarseModes::of(std::size_t variant) const { return within(tolerance, variant); }

Buckling CoarseModes::within(double tolerance, std::size_t variant) const {
    if (!rig_) return {};
    const PixelSolver& solver = rig_->solver(variant);
    BucklingOptions how{
        .count = count, .tolerance = tolerance, .others = other_tolerance, .most = most_vectors};
    if (coarser_)
        how.start = coarser_->start(coarser_->within(start_tolerance, variant), rig_->model().grid);
    return buckling(solver, solver.solve_only(rig_->load(variant)), how);
}

std::vector<PixelVector> CoarseModes::start(const Buckling& coarse, const PixelGrid& grid) const {
    std::vector<PixelVector> start;
    for (const BucklingMode& mode : coarse.modes)
        start.push_back(transferred(rig_->model(), mode.shape, grid));
    return start;
}

}  // namespace bead
