#include "geom/arc_recovery.h"

#include <algorithm>

#include "core/expects.h"

namespace bead {
namespace {

double angle_of(Vec2 a) { return std::atan2(a.y, a.x); }

// The circle through both ends that is nearest to what lies between: with the middle of the ends
// at the origin and the ends at ±c on the first axis, x² + y² - c² = 2 h y for a centre (0, h).
std::optional<PlanarArc> circle_through_ends(const Polyline& line, std::size_t first,
                                             std::size_t last) {
    const Vec2 middle = lerp(line[first], line[last], 0.5), half = line[last] - middle;
    const double c = length(half);
    if (c <= 0) return std::nullopt;
    double products = 0, squares = 0;
    for (std::size_t i = first + 1; i < last; ++i) {
        const Vec2 p = line[i] - middle;
        const double y = cross(half, p) / c;
        products += y * (dot(p, p) - c * c);
        squares += y * y;
    }
    if (squares <= 1e-18 * c * c) return std::nullopt;
    const double h = products / (2 * squares);
    return PlanarArc{middle + (h / c) * left_of(half), std::sqrt(h * h + c * c), 0, 0};
}

std::optional<PlanarArc> arc_of(const Polyline& line, std::size_t first, std::size_t last,
                                const ArcOptions& options) {
    std::optional<PlanarArc> arc = circle_through_ends(line, first, last);
    if (!arc || arc->radius > options.largest_radius) return std::nullopt;
    arc->start = angle_of(line[first] - arc->centre);
    for (std::size_t i = first; i < last; ++i) {
        const Vec2 a = line[i] - arc->centre, b = line[i + 1] - arc->centre;
        const double step = std::atan2(cross(a, b), dot(a, b));
        if (step == 0 || step * arc->sweep < 0) return std::nullopt;  // to and fro
        if (std::abs(length(b) - arc->radius) > options.tolerance) return std::nullopt;
        if (sagitta(arc->radius, distance(a, b)) > options.rise) return std::nullopt;
        arc->sweep += step;
    }
    if (std::abs(arc->sweep) > 1.5 * pi) return std::nullopt;
    return arc;
}

// Twice as far as long as it goes, then halving what is between.
PathPiece longest_arc(const Polyline& line, std::size_t first, const ArcOptions& options) {
    const auto least = static_cast<std::size_t>(options.least_points) - 1;
    PathPiece best{first, first + 1, std::nullopt};
    std::size_t good = first, bad = line.size();
    for (std::size_t step = least; good + step < line.size(); step *= 2) {
        const auto arc = arc_of(line, first, good + step, options);
        if (!arc) {
            bad = good + step;
            break;
        }
        good += step;
        best = {first, good, arc};
    }
    while (best.arc && good + 1 < bad) {
        const std::size_t middle = (good + bad) / 2;
        if (const auto arc = arc_of(line, first, middle, options)) {
            good = middle;
            best = {first, good, arc};
        } else {
            bad = middle;
        }
    }
    return best;
}

}  // namespace

std::vector<PathPiece> arcs_and_lines(const Polyline& line, const ArcOptions& options) {
    BEAD_EXPECTS(options.least_points >= 4 && options.tolerance > 0 && options.rise > 0);
    std::vector<PathPiece> pieces;
    for (std::size_t i = 0; i + 1 < line.size(); i = pieces.back().last)
        pieces.push_back(longest_arc(line, i, options));
    return pieces;
}

}  // namespace bead
