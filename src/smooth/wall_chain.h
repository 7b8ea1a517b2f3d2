// Wall loops wound into one stroke: the outermost goes all the way round at full flow; over a link
// of some mm the nozzle then shifts to the next loop while its flow comes up from 0; from there it
// spirals on, and the last loop gets its missing mm with the flow fading. Flows add up to 1 in
// every lane: the stroke is as long as its loops and one link, its volume theirs.
#pragma once
#include "smooth/chain.h"

namespace bead {

// `rings` are the lanes', nested from the first inwards.
Chain wall_chain(std::vector<std::size_t> lanes, std::vector<Ring> rings,
                 const ChainOptions& options);

Ribbon wound_walls(const Chain& chain, const Winding& winding);

}  // namespace bead
