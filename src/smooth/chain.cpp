#include "smooth/chain.h"

#include <algorithm>
#include <optional>

#include "core/expects.h"

namespace bead {
namespace {

constexpr int link_parts = 24;
constexpr int ramp_steps = 3;

double smoothstep(double t) { return t * t * t * (10 + t * (6 * t - 15)); }

const Ring& ring_of(const Chain& chain, const Winding& winding, std::size_t i) {
    return winding.turns[i].backward ? chain.backward[i] : chain.rings[i];
}

StrokeEnd end_at(const Ring& ring, double place) {
    return {point_at(ring, place), direction_at(ring, place)};
}

const Flow& flow_at(const Ring& ring, double place) { return ring.flows[segment_at(ring, place)]; }

Flow mixed(const Flow& from, const Flow& to, double share) {
    Flow flow = to;
    flow.section = std::lerp(from.section, to.section, share);
    if (std::abs(from.section - to.section) > 1e-9)
        flow.ramp = 1 + std::min(ramp_steps - 1, static_cast<int>(share * ramp_steps));
    return flow;
}

struct Link {
    const Ring *from, *to;
    double leaves, lands;  // places
    double length;         // mm
};

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

// The last wall's own end, with the flow fading.
void append_fading(Ribbon& ribbon, const Ring& ring, double from, double length) {
    Flow none = flow_at(ring, from);
    none.section = 0;
    for (int i = 1; i <= link_parts; ++i) {
        const double t = static_cast<double>(i) / link_parts;
        const double place = from + t * length;
        append_point(ribbon, point_at(ring, place),
                     mixed(flow_at(ring, place - 1e-6), none, smoothstep((i - 0.5) / link_parts)));
    }
}

Ribbon wound_walls(const Chain& chain, const Winding& winding) {
    Ribbon ribbon;
    const std::size_t n = chain.rings.size();
    for (std::size_t i = 0; i < n; ++i) {
        const Ring& ring = ring_of(chain, winding, i);
        const double place = winding.turns[i].place;
        const double end = place + ring.length - (i > 0 ? chain.link : 0);
        append_way(ribbon, ring, place, end);
        if (i + 1 < n) {
            const Ring& next = ring_of(chain, winding, i + 1);
            const double lands = winding.turns[i + 1].place;
            const Flow to = flow_at(next, lands);
            Flow from = flow_at(ring, end);
            if (i == 0) from.section = 0;
            append_link(ribbon, {&ring, &next, end, lands, chain.link}, from, to);
        } else if (i > 0) {
            append_fading(ribbon, ring, end, chain.link);
        }
    }
    return ribbon;
}

Ribbon wound_infill(const Chain& chain, const Winding& winding) {
    Ribbon ribbon;
    for (std::size_t i = 0; i < chain.rings.size(); ++i) {
        const Ring& ring = ring_of(chain, winding, i);
        const double place = winding.turns[i].place;
        const double end = place + ring.length - std::min(chain.gap, 0.08 * ring.length);
        append_way(ribbon, ring, place, end);
        if (i + 1 == chain.rings.size()) break;
        const Ring& next = ring_of(chain, winding, i + 1);
        const double lands = winding.turns[i + 1].place;
        append_link(ribbon, {&ring, &next, end, lands, chain.link}, flow_at(ring, end),
                    flow_at(next, lands));
    }
    return ribbon;
}

// How much the ring turns around a place, beyond what a curve does: links and seams avoid corners.
double corner_cost(const Ring& ring, double place, double before, double after) {
    constexpr double dear = 6, gentle = 0.76;  // mm, cosine
    Vec2 along = direction_at(ring, place - before);
    for (int i = 1; i <= 4; ++i) {
        const Vec2 next = direction_at(ring, place - before + (before + after) * i / 4);
        if (dot(along, next) < gentle) return dear;
        along = next;
    }
    return 0;
}

Winding wall_winding(const Chain& chain, double seam, bool backward) {
    Winding winding;
    const std::vector<Ring>& rings = backward ? chain.backward : chain.rings;
    const std::size_t n = rings.size();
    double leaves = seam;
    winding.turns.push_back({backward, seam});
    winding.in = end_at(rings[0], seam);
    winding.worse = corner_cost(rings[0], seam, 1, n > 1 ? chain.link + 1 : 1);
    for (std::size_t i = 1; i < n; ++i) {
        const double there = nearest_place(rings[i], point_at(rings[i - 1], leaves));
        winding.turns.push_back({backward, there + chain.link});
        winding.worse += corner_cost(rings[i], there, 1, chain.link + 1) / 2;
        leaves = there;
    }
    winding.out = end_at(rings[n - 1], n > 1 ? winding.turns.back().place : seam);
    return winding;
}

std::vector<Ring> all_reversed(const std::vector<Ring>& rings) {
    std::vector<Ring> result;
    result.reserve(rings.size());
    for (const Ring& ring : rings) result.push_back(reversed(ring));
    return result;
}

// ---- infill ----

constexpr double least_agreement = 0.7;  // cosine between neighbours where a link joins them

struct InfillContext {
    double spacing;
    const SegmentGrid& grid;
    double clearance;
};

bool clear(const Link& link, std::size_t from, std::size_t to, const InfillContext& context) {
    for (int i = 1; i < 8; ++i)
        for (const NearLine& near : context.grid.near(point_at(link, i / 8.0)))
            if (near.line != from && near.line != to && near.distance < context.clearance)
                return false;
    return true;
}

bool near_each_other(const Link& link, double spacing) {
    for (const double t : {0.0, 0.5, 1.0}) {
        const double a = link.leaves + t * link.length, b = link.lands - (1 - t) * link.length;
        if (distance(point_at(*link.from, a), point_at(*link.to, b)) > 1.5 * spacing) return false;
        if (dot(direction_at(*link.from, a), direction_at(*link.to, b)) < least_agreement)
            return false;
    }
    return true;
}

// The winding with one more ring, if a link from its end reaches it.
std::optional<Winding> extended(const Chain& chain, const Winding& winding, const InfillRing& next,
                                const Ring& backward, const InfillContext& context) {
    const std::size_t last = chain.rings.size() - 1;
    const Ring& ring = ring_of(chain, winding, last);
    const double leaves =
        winding.turns[last].place + ring.length - std::min(chain.gap, 0.08 * ring.length);
    const Vec2 from = point_at(ring, leaves), along = direction_at(ring, leaves);
    double there = nearest_place(next.ring, from);
    if (distance(point_at(next.ring, there), from) > 1.3 * context.spacing) return std::nullopt;
    const bool turned = dot(direction_at(next.ring, there), along) < 0;
    if (turned) there = next.ring.length - there;
    const Link link{&ring, turned ? &backward : &next.ring, leaves, there + chain.link, chain.link};
    if (!near_each_other(link, context.spacing)) return std::nullopt;
    if (!clear(link, chain.lanes[last], next.lane, context)) return std::nullopt;
    Winding longer = winding;
    longer.turns.push_back({turned, link.lands});
    const double gap = std::min(chain.gap, 0.08 * link.to->length);
    longer.out = end_at(*link.to, link.lands - gap);
    longer.worse += corner_cost(*link.to, link.lands, chain.link, 1);
    return longer;
}

bool near_boxes(const Box2& a, const Box2& b, double reach) {
    return a.low.x <= b.high.x + reach && b.low.x <= a.high.x + reach &&
           a.low.y <= b.high.y + reach && b.low.y <= a.high.y + reach;
}

Chain infill_start(const InfillRing& first, const ChainOptions& options, double link) {
    Chain chain;
    chain.lanes = {first.lane};
    chain.rings = {first.ring};
    chain.backward = {reversed(first.ring)};
    chain.link = link;
    chain.gap = options.link;
    for (const bool backward : {false, true}) {
        const Ring& ring = backward ? chain.backward[0] : chain.rings[0];
        const double gap = std::min(chain.gap, 0.08 * ring.length);
        for (int i = 0; i < options.seams; ++i) {
            const double seam = ring.length * i / options.seams;
            chain.windings.push_back({{{backward, seam}},
                                      end_at(ring, seam),
                                      end_at(ring, seam - gap),
                                      corner_cost(ring, seam, gap + 0.5, 1)});
        }
    }
    return chain;
}

}  // namespace

Chain wall_chain(std::vector<std::size_t> lanes, std::vector<Ring> rings,
                 const ChainOptions& options) {
    BEAD_EXPECTS(!rings.empty() && lanes.size() == rings.size());
    Chain chain;
    chain.walls = true;
    chain.lanes = std::move(lanes);
    chain.rings = std::move(rings);
    chain.backward = all_reversed(chain.rings);
    chain.link = options.link;
    for (const Ring& ring : chain.rings) chain.link = std::min(chain.link, ring.length / 4);
    for (const bool backward : {false, true})
        for (int i = 0; i < options.seams; ++i)
            chain.windings.push_back(
                wall_winding(chain, chain.rings[0].length * i / options.seams, backward));
    return chain;
}

Chain line_chain(std::size_t lane, Ribbon line, bool reversible) {
    BEAD_EXPECTS(line.points.size() > 1);
    Chain chain;
    chain.lanes = {lane};
    chain.line = std::move(line);
    const Polyline& p = chain.line.points;
    const std::size_t n = p.size();
    const Vec2 first = (p[1] - p[0]) / distance(p[0], p[1]);
    const Vec2 last = (p[n - 1] - p[n - 2]) / distance(p[n - 1], p[n - 2]);
    chain.windings.push_back({{{false, 0}}, {p[0], first}, {p[n - 1], last}, 0});
    if (reversible) chain.windings.push_back({{{true, 0}}, {p[n - 1], -last}, {p[0], -first}, 0});
    return chain;
}

std::vector<Chain> infill_chains(std::vector<InfillRing> rings, double spacing,
                                 const SegmentGrid& grid, double clearance,
                                 const ChainOptions& options) {
    const InfillContext context{spacing, grid, clearance};
    const double link = std::min(6.0, 1.3 * spacing);
    std::vector<Ring> backward;
    std::vector<Box2> boxes;
    for (const InfillRing& ring : rings) {
        backward.push_back(reversed(ring.ring));
        boxes.push_back(bounds(ring.ring.points));
    }
    std::vector<bool> used(rings.size(), false);
    std::vector<Chain> chains;
    for (std::size_t first = 0; first < rings.size(); ++first) {
        if (used[first]) continue;
        used[first] = true;
        Chain chain = infill_start(rings[first], options, link);
        for (;;) {
            std::vector<Winding> best;
            std::size_t chosen = 0;
            const Box2 here = bounds(chain.rings.back().points);
            for (std::size_t next = 0; next < rings.size(); ++next) {
                if (used[next] || rings[next].ring.length < 4 * link) continue;
                if (!near_boxes(here, boxes[next], 1.3 * spacing)) continue;
                std::vector<Winding> longer;
                for (const Winding& winding : chain.windings)
                    if (auto more = extended(chain, winding, rings[next], backward[next], context))
                        longer.push_back(*std::move(more));
                if (longer.size() <= best.size()) continue;
                best = std::move(longer);
                chosen = next;
            }
            if (best.size() < 4 || chain.rings.back().length < 4 * link) break;
            used[chosen] = true;
            chain.lanes.push_back(rings[chosen].lane);
            chain.rings.push_back(rings[chosen].ring);
            chain.backward.push_back(backward[chosen]);
            chain.windings = std::move(best);
        }
        chains.push_back(std::move(chain));
    }
    return chains;
}

Ribbon wound(const Chain& chain, const Winding& winding) {
    if (!chain.rings.empty())
        return chain.walls ? wound_walls(chain, winding) : wound_infill(chain, winding);
    Ribbon line = chain.line;
    if (winding.turns[0].backward) {
        std::ranges::reverse(line.points);
        std::ranges::reverse(line.flows);
    }
    return line;
}

}  // namespace bead
