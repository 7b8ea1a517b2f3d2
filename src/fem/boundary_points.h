// A part's boundary as points for a mesh: at its corners, at the ends of stretches that are held or
// loaded, and between those as far apart as the elements are to be large.
#pragma once
#include <vector>

#include "fem/load_case.h"
#include "fem/mesh_size.h"
#include "fem/stretch.h"
#include "geom/along.h"

namespace bead {

struct BoundaryPoint {
    Vec2 place;
    std::size_t loop = 0;
    double at = 0;  // mm along it
};

struct Boundary {
    std::vector<MeasuredLoop> loops;
    std::vector<Circle> circles;
    std::vector<BoundaryPoint> points;
    std::vector<std::pair<int, int>> sides;  // from point to point, the solid on the left

    // On the loop, or on the circle that the loop follows there.
    [[nodiscard]] Vec2 on_curve(std::size_t loop, double at) const;
    void halve(std::size_t side);
    [[nodiscard]] Region region() const;
};

Boundary boundary_of(std::vector<MeasuredLoop> loops, std::vector<Circle> circles,
                     const std::vector<BoundarySpan>& stretches, const SizeField& sizes);

}  // namespace bead
