#include "smooth/coverage.h"

#include <algorithm>

#include "geom/clip.h"
#include "smooth/chord_error.h"
#include "smooth/segment_lattice.h"

namespace bead {
namespace {

struct Line {
    Polyline points;
    double width;
    bool outer;
};

// Paths that go on from each other with the same bead are one line.
std::vector<Line> wall_lines(const Toolpath& layer) {
    std::vector<Line> lines;
    bool goes_on = false;
    for (const Path& path : layer) {
        if (path.points.empty()) continue;
        const bool outer = path.role == Role::outer_wall;
        if (!outer && path.role != Role::wall) {
            goes_on = false;
            continue;
        }
        goes_on = goes_on && lines.back().width == spacing(path.bead) &&
                  lines.back().outer == outer &&
                  distance(lines.back().points.back(), flat(path.points.front())) < 1e-6;
        if (!goes_on) lines.push_back({{flat(path.points.front())}, spacing(path.bead), outer});
        for (const Vec3& p : path.points)
            if (distance(lines.back().points.back(), flat(p)) > 1e-6)
                lines.back().points.push_back(flat(p));
        goes_on = true;
    }
    std::erase_if(lines, [](const Line& line) { return line.points.size() < 2; });
    return lines;
}

Region covered(const std::vector<Line>& lines, Corner corner = Corner::miter) {
    std::vector<WideLine> wide;
    wide.reserve(lines.size());
    for (const Line& line : lines) wide.push_back({line.points, line.width});
    return covered_by(wide, corner);
}

double laid(const std::vector<Line>& lines) {
    double sum = 0;
    for (const Line& line : lines) sum += length(line.points) * line.width;
    return sum;
}

double farthest(const std::vector<Polyline>& from, const SegmentLattice& to) {
    constexpr double step = 0.1;  // mm
    double result = 0;
    for (const Polyline& line : from) result = to.farthest(places_along(line, step), result);
    return result;
}

// A bead is round where it turns: into a sharper corner of the part it does not reach.
Region reached(const Region& outline, const std::vector<Line>& outer) {
    constexpr double share = 0.47;  // less than half: what is as wide as a bead stays
    double widest = 0;
    for (const Line& line : outer) widest = std::max(widest, line.width);
    const double radius = share * widest;
    return offset(offset(outline, -radius), radius, Corner::round);
}

double outline_deviation(const std::vector<Line>& outer, const Region& outline) {
    const Region beads = covered(outer, Corner::round);
    const std::vector<Polyline> edges = boundary_curves(beads);
    const std::vector<Polyline> outlines = boundary_curves(reached(outline, outer));
    if (edges.empty() || outlines.empty()) return 0;
    const std::vector<Polyline> beyond = boundary_curves(difference(beads, outline));
    return std::max(farthest(outlines, SegmentLattice(edges)),
                    farthest(beyond, SegmentLattice(outlines)));
}

}  // namespace

Coverage wall_coverage(const Toolpath& layer, const Region& outline, double band) {
    const std::vector<Line> lines = wall_lines(layer);
    std::vector<Line> outer;
    std::ranges::copy_if(lines, std::back_inserter(outer), &Line::outer);
    const Region beads = covered(lines);
    const Region wall = difference(outline, offset(outline, -band));
    return {.band = area(wall),
            .underfill = area(difference(wall, beads)),
            .overfill = std::max(0.0, laid(lines) - area(beads)),
            .outside = area(difference(beads, outline)),
            .outline_deviation = outline_deviation(outer, outline)};
}

}  // namespace bead
