#include "study/stress_field.h"

#include <algorithm>
#include <utility>

#include "core/expects.h"
#include "fem/pixel_boundary.h"
#include "fem/pixel_solver.h"
#include "fem/pixel_stress.h"

namespace bead {
namespace {

constexpr int nodes_beyond = 4;

PixelModel solid_model(const LoadCase& load_case, double cell) {
    PixelModel model;
    model.grid = grid_over(bounds(load_case.part), cell);
    model.thickness = load_case.thickness;
    model.law = isotropic(load_case.material.young, load_case.material.poisson);
    model.factor = rastered(load_case.part, model.grid);
    return model;
}

// One row of nodes farther.
void extend(Sampled<PlaneTensor>& field, std::vector<char>& known) {
    const std::vector<char> before = known;
    const auto at = [&](int i, int j) {
        return static_cast<std::size_t>(j) * static_cast<std::size_t>(field.columns) +
               static_cast<std::size_t>(i);
    };
    for (int j = 0; j < field.rows; ++j)
        for (int i = 0; i < field.columns; ++i) {
            if (before[at(i, j)] != 0) continue;
            PlaneTensor sum;
            double count = 0;
            for (int y = std::max(j - 1, 0); y <= std::min(j + 1, field.rows - 1); ++y)
                for (int x = std::max(i - 1, 0); x <= std::min(i + 1, field.columns - 1); ++x)
                    if (before[at(x, y)] != 0) {
                        sum = sum + field.values[at(x, y)];
                        count += 1;
                    }
            if (count == 0) continue;
            field.values[at(i, j)] = (1 / count) * sum;
            known[at(i, j)] = 1;
        }
}

}  // namespace

Sampled<PlaneTensor> solid_stress(const LoadCase& load_case, std::size_t situation, double cell) {
    PixelModel model = solid_model(load_case, cell);
    const Situation& of = load_case.situations.at(situation);
    const auto held = held_nodes(model, load_case.part, of.supports);
    std::vector<Load> loads = of.loads;
    for (Load& load : loads) load.turn = load.move = 0;
    const auto load = load_vector(model, load_case.part, loads);
    BEAD_EXPECTS(held && load);
    const PixelSolver solver(std::move(model), *held);
    BEAD_EXPECTS(!solver.loose_node());
    const PixelGrid& grid = solver.model().grid;
    Sampled<PlaneTensor> field{grid.origin, grid.size, grid.columns + 1, grid.rows + 1,
                               node_stress(solver.model(), solver.solve(*load).values)};
    std::vector<char> known(grid.nodes(), 0);
    for (const std::size_t node : solver.solid_nodes()) known[node] = 1;
    for (int i = 0; i < nodes_beyond; ++i) extend(field, known);
    return field;
}

}  // namespace bead
