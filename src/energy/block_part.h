// A stretch of time cut out of a block: what is done in it, as a block of its own.
#pragma once
#include "motion/block.h"

namespace bead {

// From `from` to `to`, s after the block's beginning and within it. Parts that follow each other
// come to the block itself: in time, way and energy.
Block part_of(const Block& block, double from, double to);

}  // namespace bead
