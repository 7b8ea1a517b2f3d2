#include "fem/plate_buckling.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <utility>

#include "core/expects.h"
#include "fem/pixel_stress.h"
#include "fem/plate_element.h"
#include "fem/start_noise.h"
#include "numeric/block_lanczos.h"
#include "numeric/frontal_cholesky.h"

namespace bead {
namespace {

constexpr int block = 8;  // start vectors, as many as a solver takes at once

// Pixels and the nodes that they touch, numbered in their order.
struct PlateNumbering {
    std::vector<std::size_t> pixels, nodes;
    std::vector<std::array<int, 4>> corners;  // points of each pixel
};

PlateNumbering plate_numbering(const PixelModel& sheet) {
    PlateNumbering numbering;
    std::vector<int> point(sheet.grid.nodes(), -1);
    for (std::size_t p = 0; p < sheet.factor.size(); ++p) {
        if (sheet.factor[p] == 0) continue;
        numbering.pixels.push_back(p);
        for (const std::size_t node : sheet.grid.corners(p)) point[node] = 0;
    }
    for (std::size_t n = 0; n < point.size(); ++n) {
        if (point[n] < 0) continue;
        point[n] = int(numbering.nodes.size());
        numbering.nodes.push_back(n);
    }
    for (const std::size_t p : numbering.pixels) {
        const auto c = sheet.grid.corners(p);
        numbering.corners.push_back({point[c[0]], point[c[1]], point[c[2]], point[c[3]]});
    }
    return numbering;
}

ElementPattern plate_pattern(const PixelModel& sheet, const PlateNumbering& numbering) {
    ElementPattern pattern;
    pattern.unknowns_per_point = 3;
    pattern.places.reserve(numbering.nodes.size());
    for (const std::size_t node : numbering.nodes) {
        const Vec2 place = sheet.grid.place(node);
        pattern.places.push_back({float(place.x), float(place.y), 0});
    }
    for (const std::array<int, 4>& corners : numbering.corners)
        pattern.points.insert(pattern.points.end(), corners.begin(), corners.end());
    return pattern;
}

// -Kg on packed vectors, from the stress at pixels' centres.
class SidewaysForces {
  public:
    SidewaysForces(const PixelModel& sheet, const PlateNumbering& numbering,
                   std::span<const double> displacement, std::span<const std::uint8_t> held)
        : numbering_(numbering),
          stress_(centre_stress(sheet, displacement)),
          thickness_(sheet.thickness),
          held_(held),
          xx_(plate_geometric_stiffness({1, 0, 0})),
          yy_(plate_geometric_stiffness({0, 1, 0})),
          xy_(plate_geometric_stiffness({0, 0, 1})) {}

    [[nodiscard]] std::vector<double> applied(std::span<const double> x, int columns) const {
        std::vector<double> f(x.size(), 0.0);
        const std::size_t size = held_.size(), end = size * std::size_t(columns);
        for (std::size_t k = 0; k < numbering_.pixels.size(); ++k) {
            const PlateMatrix matrix = geometric_stiffness(k);
            const std::array<std::size_t, plate_unknowns> at = unknowns(k);
            for (std::size_t first = 0; first < end; first += size)
                subtract(matrix, at, &x[first], &f[first]);
        }
        for (std::size_t i = 0; i < f.size(); ++i)
            if (held_[i % size] != 0) f[i] = 0;
        return f;
    }

  private:
    [[nodiscard]] PlateMatrix geometric_stiffness(std::size_t k) const {
        const PlaneTensor n = thickness_ * stress_[numbering_.pixels[k]];
        PlateMatrix matrix;
        for (std::size_t i = 0; i < matrix.size(); ++i)
            matrix[i] = n.xx * xx_[i] + n.yy * yy_[i] + n.xy * xy_[i];
        return matrix;
    }
    [[nodiscard]] std::array<std::size_t, plate_unknowns> unknowns(std::size_t k) const {
        std::array<std::size_t, plate_unknowns> at{};
        for (std::size_t i = 0; i < plate_unknowns; ++i)
            at[i] = 3 * std::size_t(numbering_.corners[k][i / 3]) + i % 3;
        return at;
    }
    static void subtract(const PlateMatrix& matrix,
                         const std::array<std::size_t, plate_unknowns>& at, const double* x,
                         double* f) {
        std::array<double, plate_unknowns> u{};
        for (std::size_t i = 0; i < plate_unknowns; ++i) u[i] = x[at[i]];
        for (std::size_t i = 0; i < plate_unknowns; ++i) {
            double sum = 0;
            for (std::size_t j = 0; j < plate_unknowns; ++j)
                sum += matrix[plate_unknowns * i + j] * u[j];
            f[at[i]] -= sum;
        }
    }

    const PlateNumbering& numbering_;
    std::vector<PlaneTensor> stress_;
    double thickness_;
    std::span<const std::uint8_t> held_;
    PlateMatrix xx_, yy_, xy_;
};

// Whether the plate, which is one piece, can move as a whole: a deflection a + b x + c y that the
// held unknowns do not see.
bool is_loose(const PixelModel& sheet, const PlateNumbering& numbering, const PlateHeld& held) {
    const Vec2 middle =
        sheet.grid.origin +
        sheet.grid.size / 2 * Vec2{double(sheet.grid.columns), double(sheet.grid.rows)};
    const double scale = std::max(sheet.grid.columns, sheet.grid.rows) * sheet.grid.size;
    Eigen::Matrix3d seen = Eigen::Matrix3d::Zero();
    for (const std::size_t node : numbering.nodes) {
        const Vec2 p = (sheet.grid.place(node) - middle) / scale;
        const Eigen::Vector3d rows[] = {{1, p.x, p.y}, {0, 1, 0}, {0, 0, 1}};
        for (std::size_t c = 0; c < 3; ++c)
            if (held[3 * node + c] != 0) seen += rows[c] * rows[c].transpose();
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> parts(seen);
    return parts.eigenvalues()[0] <= 1e-9 * parts.eigenvalues()[2];
}

}  // namespace

std::vector<PlaneLaw> plate_rigidity(const PixelModel& sheet) {
    const double t = sheet.thickness;
    std::vector<PlaneLaw> rigidity(sheet.factor.size());
    for (std::size_t p = 0; p < rigidity.size(); ++p)
        if (sheet.factor[p] > 0) rigidity[p] = t * t * t / 12 * law_of(sheet, p);
    return rigidity;
}

std::optional<PlateBuckling> plate_buckling(const PixelModel& sheet,
                                            std::span<const PlaneLaw> rigidity,
                                            const PlateHeld& held,
                                            std::span<const double> displacement,
                                            const PlateOptions& options) {
    BEAD_EXPECTS(held.size() == 3 * sheet.grid.nodes() && rigidity.size() == sheet.factor.size());
    const PlateNumbering numbering = plate_numbering(sheet);
    if (numbering.pixels.empty() || is_loose(sheet, numbering, held)) return std::nullopt;
    std::vector<std::uint8_t> packed_held;
    packed_held.reserve(3 * numbering.nodes.size());
    for (const std::size_t node : numbering.nodes)
        for (std::size_t c = 0; c < 3; ++c) packed_held.push_back(held[3 * node + c]);
    std::pair<PlaneLaw, PlateMatrix> last{rigidity[numbering.pixels.front()], {}};
    last.second = plate_stiffness(last.first, sheet.grid.size);
    const ElementMatrix matrix = [&](std::size_t element, std::span<double> values) {
        const PlaneLaw& law = rigidity[numbering.pixels[element]];
        if (!(law == last.first)) last = {law, plate_stiffness(law, sheet.grid.size)};
        for (std::size_t i = 0; i < last.second.size(); ++i) values[i] = last.second[i];
    };
    const FrontalCholesky factor(elimination_tree(plate_pattern(sheet, numbering)), matrix,
                                 packed_held);
    if (factor.singular()) return std::nullopt;
    const SidewaysForces forces(sheet, numbering, displacement, packed_held);
    const BlockMap map = [&](std::span<const double> x, int columns) {
        std::vector<double> f = forces.applied(x, columns);
        std::vector<double> moved = factor.solve(f, columns);
        return BlockImages{std::move(moved), std::move(f)};
    };
    const std::size_t size = packed_held.size();
    const Modes modes =
        block_modes(map, start_noise(size * block, 20261126), size,
                    {.count = 1, .tolerance = options.tolerance, .most = options.most});
    PlateBuckling result;
    result.converged = modes.converged;
    if (modes.modes.empty()) return result;
    result.factor = 1 / modes.modes.front().value;
    result.deflection.assign(sheet.grid.nodes(), 0.0);
    for (std::size_t p = 0; p < numbering.nodes.size(); ++p)
        result.deflection[numbering.nodes[p]] = modes.modes.front().shape[3 * p];
    return result;
}

}  // namespace bead
