// Four numbers side by side, as many as a wide register holds (numeric/wide_registers.h), read from
// wherever they lie in memory.
#pragma once

namespace bead {

using Lanes [[gnu::vector_size(32), gnu::aligned(8), gnu::may_alias]] = double;

[[gnu::always_inline]] inline const Lanes& load(const double* at) {
    return *reinterpret_cast<const Lanes*>(at);
}

}  // namespace bead
