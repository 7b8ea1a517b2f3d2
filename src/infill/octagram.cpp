// Eight-pointed stars {8/3} one around the other; the last side of each leads to the next, so that
// all are one line. A star's sides are the outer parts of the octagon's chords that skip two
// corners: with tips at radius 1 they lie on lines cos(3π/8) from the centre, and inner corners are
// √2 as far. Stars of one shape whose radii differ by d have their sides cos(3π/8) · d apart
// everywhere: that is the spacing, and every point of the plane but the centre lies between two
// stars, so that there is 1 / spacing of line per area.
#include <algorithm>
#include <array>

#include "core/expects.h"
#include "infill/cut.h"

namespace bead {
namespace {

constexpr int corners = 16;
const double side_distance = std::cos(3 * pi / 8);  // of a star with its tips at radius 1
const double inner_radius = std::numbers::sqrt2 * side_distance;

std::array<Vec2, corners> star(double angle) {
    std::array<Vec2, corners> points;
    for (int i = 0; i < corners; ++i)
        points[static_cast<std::size_t>(i)] =
            (i % 2 == 0 ? 1.0 : inner_radius) * unit(angle + i * 2 * pi / corners);
    return points;
}

}  // namespace

std::vector<Polyline> octagram(const Region& region, const FillOptions& options) {
    BEAD_EXPECTS(options.spacing > 0);
    if (region.empty()) return {};
    const double step = options.spacing / side_distance;
    const double nearest =
        contains(region, options.centre) ? 0 : boundary_distance(region, options.centre);
    double farthest = 0;
    for (const Polygon& polygon : region)
        for (const Vec2 p : polygon.outer)
            farthest = std::max(farthest, distance(p, options.centre));

    const std::array<Vec2, corners> unit_star = star(options.angle);
    Polyline line;
    const auto first = static_cast<long>(std::max(0.0, nearest / step - 2));
    const auto last = static_cast<long>(farthest / (inner_radius * step)) + 1;
    for (long i = first; i <= last; ++i)
        for (const Vec2 corner : unit_star)
            line.push_back(options.centre + (static_cast<double>(i) + 0.5) * step * corner);
    return cut_and_linked({line}, region, options.link);
}

}  // namespace bead
