// Copies of the outline, each one spacing inside the one before; the region's own edge is the
// first. What is left in the middle of the last copy, too narrow for another but wider than a line,
// gets a line along its middle. The angle is where the loops start, as seen from the middle.
#include <algorithm>

#include "core/expects.h"
#include "geom/along.h"
#include "geom/clip.h"
#include "geom/near_order.h"
#include "geom/simplify.h"
#include "infill/cut.h"

namespace bead {
namespace {

Polyline closed_from_seam(const Polyline& loop, Vec2 seam) {
    const auto first = std::max_element(
        loop.begin(), loop.end(), [&](Vec2 a, Vec2 b) { return dot(a, seam) < dot(b, seam); });
    Polyline line(first, loop.end());
    line.insert(line.end(), loop.begin(), first + 1);
    return line;
}

std::size_t farthest_from(const Polyline& points, Vec2 from) {
    const auto nearer = [&](Vec2 a, Vec2 b) { return distance(a, from) < distance(b, from); };
    return static_cast<std::size_t>(std::max_element(points.begin(), points.end(), nearer) -
                                    points.begin());
}

// Half-way between the two sides of a narrow loop, from tip to tip.
Polyline middle_line(const MeasuredLoop& loop, double step) {
    constexpr double detail = 0.01;  // mm
    const std::size_t tip = farthest_from(loop.points, loop.points.front());
    const std::size_t other_tip = farthest_from(loop.points, loop.points[tip]);
    const double ahead = loop.at[other_tip] - loop.at[tip];
    const double one_side = ahead > 0 ? ahead : ahead + loop.length;
    const double other_side = loop.length - one_side;
    const int steps = static_cast<int>(std::ceil(one_side / step)) + 1;
    Polyline line;
    for (int i = 0; i <= steps; ++i) {
        const double part = static_cast<double>(i) / steps;
        line.push_back(0.5 * (point_at(loop, loop.at[tip] + part * one_side) +
                              point_at(loop, loop.at[tip] - part * other_side)));
    }
    return simplified(line, detail);
}

// For the middle of a copy that is too narrow for another one.
std::vector<Polyline> leftover_lines(const Polygon& polygon, double spacing, Vec2 seam) {
    std::vector<Polyline> lines;
    for (const Polygon& left : offset({polygon}, -spacing / 2)) {
        if (!left.holes.empty()) {
            lines.push_back(closed_from_seam(left.outer, seam));
            continue;
        }
        const Polyline middle = middle_line(measured(left.outer), spacing / 4);
        for (CutLine& part : cut_to({middle}, {measured(left.outer)}))
            lines.push_back(std::move(part.points));
    }
    return lines;
}

void append_loops(std::vector<Polyline>& lines, const Polygon& polygon, Vec2 seam) {
    lines.push_back(closed_from_seam(polygon.outer, seam));
    for (const Polyline& hole : polygon.holes) lines.push_back(closed_from_seam(hole, seam));
}

}  // namespace

std::vector<Polyline> concentric(const Region& region, const FillOptions& options) {
    BEAD_EXPECTS(options.spacing > 0);
    // A little beside the angle: a straight side across it has no corner that is farther by
    // rounding.
    const Vec2 seam = unit(options.angle + 1e-3);
    std::vector<Polyline> lines;
    Region copies = region;
    while (!copies.empty()) {
        const Polygon polygon = std::move(copies.back());
        copies.pop_back();
        append_loops(lines, polygon, seam);
        Region inner = offset({polygon}, -options.spacing);
        if (inner.empty())
            for (Polyline& line : leftover_lines(polygon, options.spacing, seam))
                lines.push_back(std::move(line));
        std::move(inner.begin(), inner.end(), std::back_inserter(copies));
    }
    std::erase_if(lines, [](const Polyline& line) { return length(line) < shortest_line; });
    if (lines.empty()) return lines;
    const Vec2 start = lines.front().front();
    return near_order(std::move(lines), start);
}

}  // namespace bead
