#include "smooth/wall_chain.h"

#include <algorithm>

#include "core/expects.h"
#include "smooth/link.h"

namespace bead {
namespace {

constexpr int fading_parts = 24;

// The last wall's own end, with the flow fading.
void append_fading(Ribbon& ribbon, const Ring& ring, double from, double length) {
    Flow none = flow_at(ring, from);
    none.section = 0;
    for (int i = 1; i <= fading_parts; ++i) {
        const double t = static_cast<double>(i) / fading_parts;
        const double place = from + t * length;
        append_point(
            ribbon, point_at(ring, place),
            mixed(flow_at(ring, place - 1e-6), none, smoothstep((i - 0.5) / fading_parts)));
    }
}

Winding wall_winding(const Chain& chain, double seam, bool backward) {
    Winding winding;
    const std::vector<Ring>& rings = backward ? chain.backward : chain.rings;
    const std::size_t n = rings.size();
    double leaves = seam;
    winding.turns.push_back({backward, seam});
    winding.in = end_at(rings[0], seam);
    for (std::size_t i = 1; i < n; ++i) {
        const double there = nearest_place(rings[i], point_at(rings[i - 1], leaves));
        winding.turns.push_back({backward, there + chain.link});
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
    for (const bool backward : {false, true}) {
        const Ring& first = backward ? chain.backward[0] : chain.rings[0];
        for (int i = 0; i < (options.seam ? 1 : options.seams); ++i) {
            const double place = options.seam ? nearest_place(first, *options.seam)
                                              : first.length * i / options.seams;
            chain.windings.push_back(wall_winding(chain, place, backward));
        }
    }
    return chain;
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

}  // namespace bead
