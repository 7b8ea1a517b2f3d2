// Numbers in -0.5 … 0.5 for the vectors from which modes are sought: nothing in a part is
// orthogonal to them, and they are the same on every machine.
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

namespace bead {

std::vector<double> start_noise(std::size_t count, std::uint64_t seed);

}  // namespace bead
