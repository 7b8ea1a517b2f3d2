// Four numbers side by side, as many as a wide register holds (numeric/wide_registers.h), read
// and written wherever they lie in memory.
#pragma once

namespace bead {

using Lanes [[gnu::vector_size(32)]] = double;
using LanesAnywhere [[gnu::aligned(8), gnu::may_alias]] = Lanes;

// A pointer, for a reference forgets that it may lie anywhere.
[[gnu::always_inline]] inline const LanesAnywhere* lanes(const double* at) {
    return reinterpret_cast<const LanesAnywhere*>(at);
}
[[gnu::always_inline]] inline LanesAnywhere* lanes(double* at) {
    return reinterpret_cast<LanesAnywhere*>(at);
}

}  // namespace bead
