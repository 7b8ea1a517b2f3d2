#include "smooth/link.h"

#include <algorithm>

namespace bead {
namespace {

constexpr int link_parts = 24;
constexpr int ramp_steps = 3;

}  // namespace

double smoothstep(double t) { return t * t * t * (10 + t * (6 * t - 15)); }

const Ring& ring_of(const Chain& chain, const Winding& winding, std::size_t i) {
    return winding.turns[i].backward ? chain.backward[i] : chain.rings[i];
}

StrokeEnd end_at(const Ring& ring, double place) {
    const RingSpot spot = spot_at(ring, place);
    return {spot.point, spot.along};
}

const Flow& flow_at(const Ring& ring, double place) { return ring.flows[segment_at(ring, place)]; }

Flow mixed(const Flow& from, const Flow& to, double share) {
    Flow flow = to;
    flow.section = std::lerp(from.section, to.section, share);
    if (std::abs(from.section - to.section) > 1e-9)
        flow.ramp = 1 + std::min(ramp_steps - 1, static_cast<int>(share * ramp_steps));
    return flow;
}

Vec2 point_at(const Link& link, double t) {
    const Vec2 a = point_at(*link.from, link.leaves + t * link.length);
    const Vec2 b = point_at(*link.to, link.lands - (1 - t) * link.length);
    return lerp(a, b, smoothstep(t));
}

void append_link(Ribbon& ribbon, const Link& link, const Flow& from, const Flow& to) {
    for (int i = 1; i <= link_parts; ++i) {
        const double t = static_cast<double>(i) / link_parts;
        const double middle = smoothstep((i - 0.5) / link_parts);
        append_point(ribbon, point_at(link, t), mixed(from, to, middle));
    }
}

}  // namespace bead
