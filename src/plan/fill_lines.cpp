#include "plan/fill_lines.h"

#include <algorithm>
#include <limits>

#include "core/expects.h"
#include "geom/polygon.h"

namespace bead {
namespace {

constexpr double longest_skin_link = 4;  // spacings
constexpr double edge_gap = 1e-3;        // mm, from the area's edge to a line that runs along it

struct Span {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    [[nodiscard]] double size() const { return high - low; }
};

Span span_across(const Region& region, Vec2 across) {
    Span span;
    for (const Polygon& polygon : region)
        for (const Vec2 p : polygon.outer) {
            span.low = std::min(span.low, dot(p, across));
            span.high = std::max(span.high, dot(p, across));
        }
    return span;
}

// Lines along `angle` that divide the region's breadth evenly, the outer ones on its edge.
FillOptions evenly(const Region& region, double angle, double widest) {
    const Vec2 across = left_of(unit(angle));
    const Span span = span_across(region, across);
    const double breadth = span.size() - 2 * edge_gap;
    if (breadth < widest / 2)  // one line, in the middle
        return {widest, angle, longest_skin_link * widest, (span.low + span.high) / 2 * across};
    const double step = breadth / std::ceil(breadth / widest - 1e-6);
    return {step, angle, longest_skin_link * widest, (span.low + edge_gap) * across};
}

// The bead of the same height with `factor` times the section.
Bead scaled(const Bead& bead, double factor) {
    return {bead.width + (factor - 1) * spacing(bead), bead.height};
}

// The direction in which most of the outline runs.
double long_axis(const Region& region) {
    Vec2 sum;  // of the edges, their angles doubled: the way to and the way back count alike
    for (const Polygon& polygon : region)
        for (std::size_t i = 0, j = polygon.outer.size() - 1; i < polygon.outer.size(); j = i++) {
            const Vec2 edge = polygon.outer[i] - polygon.outer[j];
            const double size = length(edge);
            if (size > 0) sum = sum + rotated(edge, edge) / size;
        }
    return std::atan2(sum.y, sum.x) / 2;
}

// Along a straight strip hardly wider than a bead: crossing it would be all corners.
double line_angle(const FillArea& area, const Bead& bead, double asked) {
    constexpr double narrow = 1.5;  // spacings
    const double wide = narrow * spacing(bead);
    if (2 * bead::area(area.material) > wide * perimeter(area.material)) return asked;
    const double along = long_axis(area.material);
    return span_across(area.material, left_of(unit(along))).size() < wide ? along : asked;
}

double total_length(const std::vector<Polyline>& lines) {
    double sum = 0;
    for (const Polyline& line : lines) sum += length(line);
    return sum;
}

// With the bead that gives the area its volume.
FillLines filled(const FillArea& area, std::vector<Polyline> lines) {
    constexpr double thinnest = 0.5, thickest = 1.5;  // of the section
    const double deposited = total_length(lines) * spacing(area.bead);
    if (deposited <= 0) return {};
    const double factor = std::clamp(bead::area(area.material) / deposited, thinnest, thickest);
    return {std::move(lines), scaled(area.bead, factor)};
}

}  // namespace

FillLines solid_lines(const FillArea& area, double angle) {
    if (area.centre.empty()) return {};
    const Bead& bead = area.bead;
    return filled(area, rectilinear(area.centre, evenly(area.centre, line_angle(area, bead, angle),
                                                        spacing(bead))));
}

FillLines pattern_lines(const FillArea& area, const FillChoice& choice, Vec2 centre) {
    if (choice.pattern.has_direction) return solid_lines(area, choice.angle);
    if (area.centre.empty()) return {};
    const double step = spacing(area.bead);
    return filled(area, choice.pattern.make(
                            area.centre, {step, choice.angle, longest_skin_link * step, centre}));
}

FillLines sparse_lines(const FillArea& area, const LayerParts& layer, const FillChoice& choice,
                       double spacing, double flow) {
    BEAD_EXPECTS(spacing > 0 && flow > 0);
    if (area.centre.empty()) return {};
    return {choice.pattern.make(area.centre, {.spacing = spacing,
                                              .angle = choice.angle + choice.sparse_turn,
                                              .centre = layer.centre,
                                              .height = layer.z}),
            scaled(layer.bead, flow)};
}

std::size_t index_of(const NamedPattern& pattern) {
    const auto row = std::ranges::find(patterns, pattern.name, &NamedPattern::name);
    BEAD_EXPECTS(row != patterns.end());
    return static_cast<std::size_t>(row - patterns.begin());
}

}  // namespace bead
