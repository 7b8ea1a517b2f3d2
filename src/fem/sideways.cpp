#include "fem/sideways.h"

#include <cmath>

#include "core/expects.h"
#include "fem/buckling.h"
#include "fem/pixel_boundary.h"
#include "fem/pixel_solver.h"

namespace bead {
namespace {

constexpr double pixels_across = 100;  // of a square of the part's area

bool has_length(const Stretch& on) { return on.arc || !(on.from == on.to); }

// Holds what lies on the stretch; false if it finds no solid.
bool hold(PlateHeld& held, const PixelModel& sheet, const Region& part, const Stretch& on,
          bool clamped, double reach) {
    const auto nodes = held_nodes(sheet, part, {{on, true, true}}, {reach});
    if (!nodes) return false;
    for (std::size_t n = 0; n < sheet.grid.nodes(); ++n) {
        if ((*nodes)[2 * n] == 0) continue;
        held[3 * n] = 1;
        if (clamped) held[3 * n + 1] = held[3 * n + 2] = 1;
    }
    return true;
}

}  // namespace

std::optional<PlateBuckling> sideways_buckling(const PixelModel& sheet,
                                               std::span<const PlaneLaw> rigidity,
                                               const LoadCase& load_case,
                                               const Situation& situation,
                                               std::span<const double> displacement, double reach) {
    PlateHeld held(3 * sheet.grid.nodes(), 0);
    for (const Support& support : situation.supports)
        if (!hold(held, sheet, load_case.part, support.on,
                  support.x && support.y && has_length(support.on), reach))
            return std::nullopt;
    if (auto found = plate_buckling(sheet, rigidity, held, displacement)) return found;
    for (const Load& load : situation.loads)
        if (!hold(held, sheet, load_case.part, load.on, false, reach)) return std::nullopt;
    return plate_buckling(sheet, rigidity, held, displacement);
}

SolidBuckling solid_buckling(const LoadCase& load_case, std::size_t situation, double pixel) {
    SolidBuckling result;
    PixelModel sheet;
    result.pixel = pixel > 0 ? pixel : std::sqrt(area(load_case.part)) / pixels_across;
    sheet.grid = grid_over(bounds(load_case.part), result.pixel);
    sheet.thickness = load_case.thickness;
    sheet.law = isotropic(load_case.material.young, load_case.material.poisson);
    sheet.factor = rastered(load_case.part, sheet.grid);
    Situation of = load_case.situations.at(situation);
    for (Load& load : of.loads) load.turn = load.move = 0;
    const auto held = held_nodes(sheet, load_case.part, of.supports);
    const auto load = load_vector(sheet, load_case.part, of.loads);
    BEAD_EXPECTS(held && load);
    const std::vector<PlaneLaw> rigidity = plate_rigidity(sheet);
    const PixelSolver solver(std::move(sheet), *held);
    BEAD_EXPECTS(!solver.loose_node());
    const PixelVector u = solver.solve(*load).values;
    const Buckling in_plane = buckling(solver, u, {.count = 1});
    if (!in_plane.modes.empty()) result.in_plane = in_plane.modes.front().factor;
    if (const auto sideways = sideways_buckling(solver.model(), rigidity, load_case, of, u))
        result.sideways = sideways->factor;
    return result;
}

}  // namespace bead
