#include "fem/pixel_sheet.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "fem/grid_multigrid.h"
#include "fem/pixel_boundary.h"
#include "fem/pixel_solver.h"
#include "fem/pixel_stress.h"
#include "fem/plane_solver.h"
#include "fem/stretch.h"

namespace bead {
namespace {

constexpr double least_share = 0.1;  // of a pixel; less is left out

PixelModel model_of(const LoadCase& load_case, double size) {
    PixelModel model;
    model.grid = grid_over(bounds(load_case.part), size);
    model.thickness = load_case.thickness;
    model.law = isotropic(load_case.material.young, load_case.material.poisson);
    model.factor = coverage(load_case.part, model.grid);
    for (double& share : model.factor)
        if (share < least_share) share = 0;
    std::vector<Vec2> places;
    for (const Situation& situation : load_case.situations)
        for (const Support& support : situation.supports)
            if (const auto lines = stretch_lines(load_case.part, support.on))
                places.push_back(lines->front().front());
    model.factor = connected(model.factor, model.grid, places, 2 * model.grid.size);
    return model;
}

// The pixels that are there, as a mesh; and which node of the grid each of its nodes is.
struct PixelMesh {
    PlaneMesh mesh;
    std::vector<std::size_t> nodes;
};

PixelMesh mesh_of(const PixelModel& model) {
    PixelMesh result;
    result.mesh.kind = PlaneElement::q4;
    std::vector<int> number(model.grid.nodes(), -1);
    for (std::size_t pixel = 0; pixel < model.factor.size(); ++pixel) {
        if (model.factor[pixel] == 0) continue;
        for (const std::size_t node : model.grid.corners(pixel)) {
            if (number[node] < 0) {
                number[node] = int(result.nodes.size());
                result.nodes.push_back(node);
                result.mesh.nodes.push_back(model.grid.place(node));
            }
            result.mesh.elements.push_back(number[node]);
        }
    }
    return result;
}

ElasticGrid grid_of(const PixelModel& model) {
    ElasticGrid grid{
        2, {model.grid.columns, model.grid.rows, 0}, {}, model.thickness * model.law, 0, 0};
    grid.factor.assign(model.factor.begin(), model.factor.end());
    return grid;
}

std::vector<Vec2> reactions_of(const PixelModel& model, const LoadCase& load_case,
                               const Situation& situation, PixelVector forces) {
    std::vector<Vec2> result;
    for (const Support& support : situation.supports) {
        const auto held = held_nodes(model, load_case.part, {support});
        Vec2 sum;
        for (std::size_t i = 0; held && i < forces.size(); ++i)
            if ((*held)[i] != 0) (i % 2 == 0 ? sum.x : sum.y) += std::exchange(forces[i], 0.0);
        result.push_back(sum);
    }
    return result;
}

void add_probes(const LoadCase& load_case, const PixelModel& model, const PixelVector& u,
                const std::vector<PlaneTensor>& stress, SheetAnswer& answer) {
    for (const Vec2 at : load_case.probes) {
        std::size_t pixel = 0;
        double nearest = 1e300;
        for (std::size_t k = 0; k < model.factor.size(); ++k) {
            if (model.factor[k] == 0) continue;
            const double far = distance(model.grid.centre(k), at);
            if (far < nearest) {
                nearest = far;
                pixel = k;
            }
        }
        const Vec2 place = 2 / model.grid.size * (at - model.grid.centre(pixel));
        const Shapes shapes = shapes_at(
            PlaneElement::q4, {std::clamp(place.x, -1.0, 1.0), std::clamp(place.y, -1.0, 1.0)});
        const auto corners = model.grid.corners(pixel);
        SheetProbe probe{at, {}, {}};
        for (std::size_t c = 0; c < 4; ++c) {
            probe.displacement = probe.displacement +
                                 shapes.value[c] * Vec2{u[2 * corners[c]], u[2 * corners[c] + 1]};
            probe.stress = probe.stress + shapes.value[c] * stress[corners[c]];
        }
        answer.probes.push_back(probe);
    }
}

std::optional<SheetAnswer> answer_of(const LoadCase& load_case, const PixelModel& model,
                                     const PixelMesh& pixels, const Situation& situation,
                                     const SheetOptions& options) {
    const auto held = held_nodes(model, load_case.part, situation.supports);
    const auto load = load_vector(model, load_case.part, situation.loads);
    if (!held || !load) return std::nullopt;
    SheetAnswer answer;
    Displacement u = multigrid_solution(grid_of(model), *held, *load,
                                        {.tolerance = options.tolerance, .most = options.most});
    answer.converged = u.converged;
    answer.residual = u.residual;
    answer.iterations = u.iterations;
    answer.work = work(*load, u.values);
    answer.reactions =
        reactions_of(model, load_case, situation, reactions(model, *held, *load, u.values));
    // What part of a pixel there is bears the pixel's force, not its stress.
    PixelModel whole{model.grid, model.thickness, model.factor, model.law, {}};
    for (double& factor : whole.factor) factor = factor > 0 ? 1 : 0;
    const std::vector<PlaneTensor> stress = node_stress(whole, u.values);
    add_probes(load_case, model, u.values, stress, answer);
    for (const std::size_t node : pixels.nodes) {
        const double x = u.values[2 * node], y = u.values[2 * node + 1];
        answer.displacement.insert(answer.displacement.end(), {x, y});
        answer.stress.push_back(stress[node]);
        answer.largest = std::max(answer.largest, std::hypot(x, y));
    }
    return answer;
}

}  // namespace

Sheet pixel_sheet(const LoadCase& load_case, double size, const SheetOptions& options) {
    const PixelModel model = model_of(load_case, size);
    PixelMesh pixels = mesh_of(model);
    Sheet sheet;
    sheet.size = model.grid.size;
    for (const Situation& situation : load_case.situations) {
        auto answer = answer_of(load_case, model, pixels, situation, options);
        if (!answer) {
            sheet.failure = "a stretch of a load or support touches no pixel; make pixels smaller";
            return sheet;
        }
        sheet.answers.push_back(std::move(*answer));
    }
    sheet.mesh = std::move(pixels.mesh);
    return sheet;
}

}  // namespace bead
