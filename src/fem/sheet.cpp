#include "fem/sheet.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "fem/pixel_sheet.h"
#include "fem/plane_solver.h"
#include "fem/region_mesh.h"

namespace bead {
namespace {

constexpr double most_triangle_unknowns = 3e5;
constexpr double pixels_per_triangle = 4;  // along a side, where no triangles can be made

std::vector<BoundarySpan> stretches_of(const LoadCase& load_case) {
    std::vector<BoundarySpan> all;
    const auto add = [&](const Stretch& stretch) {
        const auto spans = stretch_spans(load_case.part, stretch);
        if (spans) all.insert(all.end(), spans->begin(), spans->end());
    };
    for (const Situation& situation : load_case.situations) {
        for (const Support& support : situation.supports) add(support.on);
        for (const Load& load : situation.loads) add(load.on);
    }
    return all;
}

std::vector<Vec2> shared_reactions(const PlaneMesh& mesh, const LoadCase& load_case,
                                   const Situation& situation, std::vector<double> forces) {
    std::vector<Vec2> result;
    for (const Support& support : situation.supports) {
        const auto held = held_nodes(mesh, load_case.part, {support});
        Vec2 sum;
        for (std::size_t i = 0; held && i < forces.size(); ++i) {
            if ((*held)[i] == 0) continue;
            (i % 2 == 0 ? sum.x : sum.y) += std::exchange(forces[i], 0.0);
        }
        result.push_back(sum);
    }
    return result;
}

void add_probes(const LoadCase& load_case, const PlaneMesh& mesh, SheetAnswer& answer) {
    for (const Vec2 at : load_case.probes) {
        const std::optional<MeshPlace> place = locate(mesh, at);
        if (!place) continue;
        const Shapes shapes = shapes_at(mesh.kind, place->place);
        const std::span<const int> nodes = mesh.element(place->element);
        SheetProbe probe{at, {}, stress_at(mesh, answer.stress, *place)};
        for (std::size_t a = 0; a < nodes.size(); ++a) {
            const auto node = std::size_t(nodes[a]);
            probe.displacement =
                probe.displacement + shapes.value[a] * Vec2{answer.displacement[2 * node],
                                                            answer.displacement[2 * node + 1]};
        }
        answer.probes.push_back(probe);
    }
}

void measure(std::span<const double> load, SheetAnswer& answer) {
    for (std::size_t i = 0; i < load.size(); ++i) answer.work += load[i] * answer.displacement[i];
    for (std::size_t i = 0; i + 1 < load.size(); i += 2)
        answer.largest = std::max(answer.largest,
                                  std::hypot(answer.displacement[i], answer.displacement[i + 1]));
}

std::string loose_words(Vec2 place) {
    return "the supports let the part move at (" + std::to_string(place.x) + ", " +
           std::to_string(place.y) + "); hold it in more places or directions";
}

void solve_triangles(const LoadCase& load_case, Sheet& sheet) {
    const PlaneLaw law = isotropic(load_case.material.young, load_case.material.poisson);
    std::optional<PlaneSolver> solver;
    std::vector<std::uint8_t> held_before;
    for (const Situation& situation : load_case.situations) {
        auto held = held_nodes(sheet.mesh, load_case.part, situation.supports);
        const auto load = load_vector(sheet.mesh, load_case.part, situation.loads);
        if (!held || !load) {
            sheet.failure =
                "a stretch of a load or support has no side of an element; make "
                "elements smaller";
            return;
        }
        if (!solver || *held != held_before) {
            held_before = *held;
            solver.emplace(sheet.mesh, law, load_case.thickness, std::move(*held));
        }
        if (const auto loose = solver->loose_node()) {
            sheet.failure = loose_words(sheet.mesh.nodes[*loose]);
            return;
        }
        SheetAnswer answer;
        Displacement u = solver->solve(*load);
        answer.converged = u.converged;
        answer.residual = u.residual;
        answer.displacement = std::move(u.values);
        answer.stress = node_stress(sheet.mesh, law, answer.displacement);
        answer.reactions = shared_reactions(sheet.mesh, load_case, situation,
                                            solver->reactions(*load, answer.displacement));
        measure(*load, answer);
        add_probes(load_case, sheet.mesh, answer);
        sheet.answers.push_back(std::move(answer));
    }
}

// Triangles of second order have about 2.3 points on every half element's square.
double triangle_unknowns(const LoadCase& load_case, double size) {
    return 2 * 4.7 * area(load_case.part) / (size * size);
}

}  // namespace

double usual_size(const LoadCase& load_case) { return std::sqrt(area(load_case.part)) / 60; }

Sheet solved_sheet(const LoadCase& load_case, const SheetOptions& options) {
    Sheet sheet;
    sheet.size = options.size > 0 ? options.size : usual_size(load_case);
    const bool pixels = options.elements == Elements::pixels ||
                        (options.elements == Elements::automatic &&
                         triangle_unknowns(load_case, sheet.size) > most_triangle_unknowns);
    if (pixels) return pixel_sheet(load_case, sheet.size, options);
    std::optional<PlaneMesh> mesh = region_mesh(load_case.part, load_case.circles,
                                                stretches_of(load_case), {.size = sheet.size});
    if (!mesh && options.elements == Elements::automatic)
        return pixel_sheet(load_case, sheet.size / pixels_per_triangle, options);
    if (!mesh) {
        sheet.failure = "the outline has a corner too sharp for triangles; say --elements pixels";
        return sheet;
    }
    sheet.mesh = std::move(*mesh);
    solve_triangles(load_case, sheet);
    return sheet;
}

}  // namespace bead
