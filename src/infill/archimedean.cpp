// Archimedes' spiral r = pitch · turns, in chords: neighbouring turns are one spacing apart all the
// way. The chords are as long as they may be for the spiral to stray at most `sagitta` from them;
// their ends depend on centre, angle and spacing only. Where the region is far, the spiral is not
// followed.
//
// With r = a t (t: angle from the start) a chord over dt strays |r' × r''| dt² / (8 |r'|), that is
// a (2 + t²) / √(1 + t²) · dt² / 8, and that is at most a (t + 2) dt² / 8. So the ends lie where
// the integral of √(a (t + 2) / (8 sagitta)), which is a power of t + 2, has whole values.
#include <algorithm>

#include "core/expects.h"
#include "infill/cut.h"

namespace bead {
namespace {

constexpr double sagitta = 0.01;  // mm

double box_distance(const Box2& box, Vec2 p) {
    return length(Vec2{std::max({box.low.x - p.x, 0.0, p.x - box.high.x}),
                       std::max({box.low.y - p.y, 0.0, p.y - box.high.y})});
}

struct Spiral {
    Vec2 centre;
    double angle = 0;
    double rise = 1;  // mm of radius per rad
    [[nodiscard]] double chords_to(double t) const {
        return std::sqrt(rise / (8 * sagitta)) * (std::pow(t + 2, 1.5) - std::pow(2, 1.5)) / 1.5;
    }
    [[nodiscard]] double angle_after(double chords) const {
        return std::pow(chords * 1.5 / std::sqrt(rise / (8 * sagitta)) + std::pow(2, 1.5),
                        2 / 3.0) -
               2;
    }
    [[nodiscard]] Vec2 point(double t) const { return centre + rise * t * unit(angle + t); }
};

// The spiral up to angle `end`, but for the parts that are far from the box.
std::vector<Polyline> near_parts(const Spiral& spiral, const Box2& box, double end) {
    const double nearest = box_distance(box, spiral.centre) / spiral.rise;
    double chord = std::floor(spiral.chords_to(std::max(nearest - 1, 0.0)));
    std::vector<Polyline> parts(1);
    double t = spiral.angle_after(chord);
    while (t < end) {
        const Vec2 p = spiral.point(t);
        parts.back().push_back(p);
        const double next = spiral.angle_after(chord + 1);
        const double off = box_distance(box, p);
        const double longest = spiral.rise * std::sqrt(1 + (t + 1) * (t + 1));  // mm in next rad
        if (off > (next - t) * longest) {
            chord =
                std::max(chord + 1, std::floor(spiral.chords_to(t + std::min(off / longest, 1.0))));
            t = spiral.angle_after(chord);
            parts.emplace_back();
        } else {
            chord += 1;
            t = next;
        }
    }
    return parts;
}

}  // namespace

std::vector<Polyline> archimedean(const Region& region, const FillOptions& options) {
    BEAD_EXPECTS(options.spacing > 0);
    if (region.empty()) return {};
    const Spiral spiral{options.centre, options.angle, options.spacing / (2 * pi)};
    double farthest = 0;
    for (const Polygon& polygon : region)
        for (const Vec2 p : polygon.outer)
            farthest = std::max(farthest, distance(p, options.centre));
    const std::vector<Polyline> parts =
        near_parts(spiral, bounds(region), farthest / spiral.rise + 2 * pi);
    return cut_and_linked(parts, region, options.link);
}

}  // namespace bead
