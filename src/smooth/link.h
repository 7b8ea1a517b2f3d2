// The way from one ring to the next at the end of a turn, and what it costs where the rings bend.
#pragma once
#include "smooth/chain.h"

namespace bead {

struct Link {
    const Ring *from, *to;
    double leaves, lands;  // places, of its start and of its end
    double length;         // mm along either ring
};

Vec2 point_at(const Link& link, double part);  // 0 … 1; across by a quintic smoothstep
void append_link(Ribbon& ribbon, const Link& link, const Flow& from, const Flow& to);

// From one cross-section to the other in a few steps.
Flow mixed(const Flow& from, const Flow& to, double share);
double smoothstep(double t);

StrokeEnd end_at(const Ring& ring, double place);
const Flow& flow_at(const Ring& ring, double place);
const Ring& ring_of(const Chain& chain, const Winding& winding, std::size_t i);

}  // namespace bead
