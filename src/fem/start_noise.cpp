#include "fem/start_noise.h"

namespace bead {

// The low bits of a multiplicative generator are not used.
std::vector<double> start_noise(std::size_t count, std::uint64_t seed) {
    std::vector<double> values(count);
    std::uint64_t state = seed;
    for (double& value : values) {
        state = state * 6364136223846793005ULL + 1442695040888963407ULL;
        value = double(state >> 40) / double(1 << 24) - 0.5;
    }
    return values;
}

}  // namespace bead
