#include "plan/skirt.h"

#include "geom/clip.h"
#include "geom/simplify.h"
#include "plan/walls.h"

namespace bead {

std::vector<Polyline> skirt_round(const Region& footprint, const Bead& bead,
                                  const PlanOptions& options) {
    constexpr double tolerance = 0.01, bay = 5;  // mm; narrower bays than twice that are passed by
    std::vector<Polyline> loops;
    for (int i = options.skirt_loops; i-- > 0;) {
        const double away = options.skirt_gap + bead.width / 2 + i * spacing(bead);
        const Region rounded =
            offset(offset(footprint, away + bay, Corner::round), -bay, Corner::round);
        for (const Polygon& polygon : rounded) {
            Polyline loop = simplified_loop(polygon.outer, tolerance);
            if (loop.size() >= 3) loops.push_back(from_seam(std::move(loop)));
        }
    }
    return loops;
}

}  // namespace bead
