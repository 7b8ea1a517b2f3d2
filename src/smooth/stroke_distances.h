// An order of strokes by how far they lie apart, wherever they are begun.
#pragma once
#include "smooth/chain.h"

namespace bead {

// Of `strokes` (indices into chains), from near `start` on.
std::vector<std::size_t> short_order(const std::vector<Chain>& chains,
                                     const std::vector<std::size_t>& strokes, Vec2 start);

}  // namespace bead
