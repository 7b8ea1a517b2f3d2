// Wall loops that lie side by side all the way round, from the outermost inwards: what can be wound
// into one stroke.
#pragma once
#include "smooth/lane.h"

namespace bead {

// Every closed level wall once; of each group the first is an outer wall if there is one, and each
// next lies within two beads of the one before everywhere. Groups in the order of their first lane.
std::vector<std::vector<std::size_t>> nested_walls(const std::vector<Lane>& lanes);

}  // namespace bead
