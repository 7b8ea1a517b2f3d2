// The cut of a mesh by a horizontal plane, by walking over the surface: from a triangle through the
// side where the cut leaves it to the triangle beyond that side, until the walk is back or the
// surface ends. Where the cut goes from triangle to triangle is known from the mesh alone, so
// rounding cannot tear an outline apart.
#pragma once
#include <span>
#include <vector>

#include "geom/polygon.h"
#include "mesh/edges.h"

namespace bead {

// For each side (3 * triangle + corner where it begins) the side that runs the other way along the
// same edge; -1 at an open edge. Where more than two meet, they are taken in pairs.
std::vector<int> opposite_sides(const Mesh& mesh, std::span<const Side> sides);

// Directed: the solid is on the left, so outlines run counter-clockwise and holes clockwise.
struct Section {
    std::vector<Polyline> loops;
    std::vector<Polyline> open;  // lines that end at open edges of the mesh
};

// Cuts one mesh at many heights; keeps the memory that a walk needs. Mesh and sides must outlive
// it.
class Cutter {
  public:
    Cutter(const Mesh& mesh, std::span<const int> opposite);
    // `crossed`: the triangles that the plane crosses. No height may come twice.
    Section at(double plane, std::span<const int> crossed);

  private:
    struct Pass;
    [[nodiscard]] Pass pass(int triangle, double plane) const;
    [[nodiscard]] Vec2 crossing(int side, double plane) const;
    [[nodiscard]] int beyond(int side) const;
    bool walk_on(int seed, double plane, Polyline& line);
    void walk_back(int seed, double plane, Polyline& line);

    const Mesh& mesh_;
    std::span<const int> opposite_;
    std::vector<int> seen_;  // per triangle: the last cut that went through it
    int cut_ = 0;
};

}  // namespace bead
