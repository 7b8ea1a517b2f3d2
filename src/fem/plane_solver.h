// A sheet meshed by plane elements: a prepared direct solver, loads and supports on the sides of
// its boundary, stress at its nodes and anywhere.
//
//     const PlaneSolver solver(mesh, isotropic(2200, 0.35), thickness, held);
//     const Displacement u = solver.solve(load);
//     const PlaneStress stress = plane_stress(mesh, law, u.values);
#pragma once
#include <cstdint>
#include <memory>
#include <optional>

#include "fem/displacement.h"
#include "fem/load_case.h"
#include "fem/plane_mesh.h"

namespace bead {

class PlaneSolver {
  public:
    // `held`: per unknown 2 * node (x), 2 * node + 1 (y).
    PlaneSolver(PlaneMesh mesh, const PlaneLaw& law, double thickness,
                std::vector<std::uint8_t> held);
    PlaneSolver(PlaneSolver&&) noexcept;
    ~PlaneSolver();

    // A node that moves without any force, or nothing.
    [[nodiscard]] std::optional<std::size_t> loose_node() const;
    [[nodiscard]] Displacement solve(std::span<const double> load) const;
    // The answer to displacements given on held unknowns instead of 0.
    [[nodiscard]] Displacement solve_moved(std::span<const double> load,
                                           std::span<const double> given) const;
    // K u - f on held unknowns, 0 elsewhere.
    [[nodiscard]] std::vector<double> reactions(std::span<const double> load,
                                                std::span<const double> displacement) const;
    [[nodiscard]] std::vector<double> forces(std::span<const double> displacement) const;

  private:
    struct Factor;
    std::unique_ptr<Factor> factor_;
};

// Sides within the stretch; the mesh must have nodes at its ends. Nothing where a stretch is not on
// the boundary.
std::optional<std::vector<std::uint8_t>> held_nodes(const PlaneMesh& mesh, const Region& part,
                                                    const std::vector<Support>& supports);
// Consistent with the elements' shape functions, along curved sides too.
std::optional<std::vector<double>> load_vector(const PlaneMesh& mesh, const Region& part,
                                               const std::vector<Load>& loads);

// Per node: the mean of what the elements around it extrapolate from their best points.
std::vector<PlaneTensor> node_stress(const PlaneMesh& mesh, const PlaneLaw& law,
                                     std::span<const double> displacement);

// Where a point lies: an element and a place in its parent.
struct MeshPlace {
    std::size_t element = 0;
    Vec2 place;
};
// The element that contains the point, or the nearest within a little of its size.
std::optional<MeshPlace> locate(const PlaneMesh& mesh, Vec2 point);
PlaneTensor stress_at(const PlaneMesh& mesh, std::span<const PlaneTensor> at_nodes,
                      const MeshPlace& place);

}  // namespace bead
