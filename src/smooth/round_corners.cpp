#include "smooth/round_corners.h"

#include <algorithm>
#include <optional>

#include "geom/corner_blend.h"
#include "geom/deviation.h"

namespace bead {
namespace {

constexpr double least_turn = 20 * pi / 180, least_leg = 0.03, longest_leg = 20;  // rad, mm
constexpr double share = 0.45;  // of the way to the next corner
constexpr int blend_parts = 32;

bool is_corner(const Polyline& p, std::size_t i) {
    const Vec2 in = p[i] - p[i - 1], out = p[i + 1] - p[i];
    return std::abs(cross(in, out)) > std::tan(least_turn) * dot(in, out);
}

struct RibbonPlaces {
    const Ribbon& ribbon;
    std::vector<double> at;  // mm, of every point
};

RibbonPlaces places_of(const Ribbon& ribbon) {
    RibbonPlaces result{ribbon, {0}};
    for (std::size_t i = 1; i < ribbon.points.size(); ++i)
        result.at.push_back(result.at.back() + distance(ribbon.points[i - 1], ribbon.points[i]));
    return result;
}

// The last point at or before a place, but not the ribbon's last.
std::size_t index_at(const RibbonPlaces& line, double place) {
    const auto after = std::ranges::upper_bound(line.at, place);
    const auto i = static_cast<std::size_t>(after - line.at.begin());
    return std::min(std::max<std::size_t>(i, 1) - 1, line.at.size() - 2);
}

struct Spot {
    Vec2 point, along;
};

Spot spot(const RibbonPlaces& line, double place, bool before) {
    std::size_t i = index_at(line, place);
    if (before && i > 0 && line.at[i] >= place - 1e-9) --i;
    const Vec2 a = line.ribbon.points[i], b = line.ribbon.points[i + 1];
    const double part = line.at[i + 1] - line.at[i];
    return {lerp(a, b, std::clamp((place - line.at[i]) / part, 0.0, 1.0)), (b - a) / part};
}

struct CornerRoom {
    std::size_t index = 0;
    double room = 0;       // mm of leg at most
    double tolerance = 0;  // mm
};

double tolerance_of(const Flow& flow, const CornerTolerances& tolerances) {
    if (flow.role == Role::outer_wall) return tolerances.walls ? tolerances.outer_wall : 0;
    if (flow.role == Role::infill) return tolerances.infill;
    return tolerances.walls ? tolerances.wall : 0;
}

// How far the flow is alike on both sides of a corner, mm along.
double uniform_reach(const RibbonPlaces& line, std::size_t corner, double most) {
    const std::vector<Flow>& flows = line.ribbon.flows;
    const Flow& flow = flows[corner - 1];
    if (!alike(flow, flows[corner]) || flow.ramp > 0) return 0;
    const auto same = [&](std::size_t i) { return alike(flow, flows[i]) && flows[i].ramp == 0; };
    std::size_t first = corner - 1, last = corner;
    while (first > 0 && line.at[corner] - line.at[first] < most && same(first - 1)) --first;
    while (last + 1 < flows.size() && line.at[last + 1] - line.at[corner] < most && same(last + 1))
        ++last;
    return std::min(line.at[corner] - line.at[first], line.at[last + 1] - line.at[corner]);
}

std::vector<CornerRoom> corners_of(const RibbonPlaces& line, const CornerTolerances& tolerances) {
    const Polyline& p = line.ribbon.points;
    std::vector<CornerRoom> corners;
    for (std::size_t i = 1; i + 1 < p.size(); ++i)
        if (is_corner(p, i)) corners.push_back({i, 0, 0});
    const double even =
        0.03 * line.at.back() / std::max<double>(1, static_cast<double>(corners.size()));
    for (std::size_t k = 0; k < corners.size(); ++k) {
        CornerRoom& corner = corners[k];
        const double here = line.at[corner.index];
        corner.room = longest_leg;
        if (k > 0)
            corner.room = std::min(corner.room, share * (here - line.at[corners[k - 1].index]));
        if (k + 1 < corners.size())
            corner.room = std::min(corner.room, share * (line.at[corners[k + 1].index] - here));
        corner.room = std::min(corner.room, uniform_reach(line, corner.index, corner.room));
        corner.tolerance =
            std::min(tolerance_of(line.ribbon.flows[corner.index], tolerances), even);
    }
    return corners;
}

Polyline blend_points(const RibbonPlaces& line, double here, double leg, double k) {
    const Spot a = spot(line, here - leg, true), b = spot(line, here + leg, false);
    CornerBlend blend;
    for (std::size_t i = 0; i < 3; ++i) {
        const double out = static_cast<double>(i) * k * leg;
        blend.points[i] = a.point + out * a.along;
        blend.points[5 - i] = b.point - out * b.along;
    }
    Polyline points;
    for (int i = 0; i <= blend_parts; ++i)
        points.push_back(point_at(blend, static_cast<double>(i) / blend_parts));
    return points;
}

double strays(const RibbonPlaces& line, const CornerRoom& corner, double leg,
              const Polyline& blend) {
    const double here = line.at[corner.index];
    Polyline cut{spot(line, here - leg, true).point};
    for (std::size_t i = index_at(line, here - leg) + 1; line.at[i] < here + leg; ++i)
        cut.push_back(line.ribbon.points[i]);
    cut.push_back(spot(line, here + leg, false).point);
    double most = line_distance(blend, line.ribbon.points[corner.index]);
    for (std::size_t i = 0; i < blend.size(); i += 4)
        most = std::max(most, line_distance(cut, blend[i]));
    return most;
}

struct Cut {
    double from, to;  // places
    Polyline points;
    Flow flow;
};

// The longest legs that keep the tolerance: right at once on straight ones, shortened on curves.
std::optional<Cut> cut_of(const RibbonPlaces& line, const CornerRoom& corner, double sharpest) {
    if (corner.tolerance <= 0 || corner.room < least_leg) return std::nullopt;
    const Polyline& p = line.ribbon.points;
    const Vec2 v = p[corner.index];
    const auto straight =
        corner_blend(p[corner.index - 1], v, p[corner.index + 1],
                     {.deviation = 0.999 * corner.tolerance, .longest_leg = corner.room});
    if (!straight || peak_curvature(*straight) > sharpest) return std::nullopt;
    const double k = 1 - distance(straight->points[1], v) / straight->leg;
    const double here = line.at[corner.index];
    double leg = straight->leg;
    const bool legs_are_straight =
        leg <= here - line.at[corner.index - 1] && leg <= line.at[corner.index + 1] - here;
    for (int attempt = 0; attempt < 12 && leg >= least_leg; ++attempt, leg *= 0.8) {
        Polyline points = blend_points(line, here, leg, k);
        if (legs_are_straight || strays(line, corner, leg, points) <= corner.tolerance)
            return Cut{here - leg, here + leg, std::move(points), line.ribbon.flows[corner.index]};
    }
    return std::nullopt;
}

}  // namespace

RoundedRibbon rounded(const Ribbon& ribbon, const CornerTolerances& tolerances) {
    const RibbonPlaces line = places_of(ribbon);
    RoundedRibbon result;
    std::size_t next = 0;
    const auto copy_until = [&](double place) {
        for (; next < ribbon.points.size() && line.at[next] < place; ++next)
            append_point(result.ribbon, ribbon.points[next],
                         ribbon.flows[std::max<std::size_t>(next, 1) - 1]);
    };
    for (const CornerRoom& corner : corners_of(line, tolerances)) {
        const auto cut = cut_of(line, corner, tolerances.sharpest);
        if (!cut) continue;
        copy_until(cut->from);
        for (const Vec2 point : cut->points) append_point(result.ribbon, point, cut->flow);
        while (next < ribbon.points.size() && line.at[next] <= cut->to) ++next;
        ++result.blends;
    }
    copy_until(line.at.back() + 1);
    return result;
}

}  // namespace bead
