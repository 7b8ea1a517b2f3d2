// Firmware stretches short moves while its queue runs low (SLOWDOWN in Prusa's and Marlin's
// configuration): from 2 blocks to less than half the ring, a move of less than 20 ms takes longer,
// the more so the fewer wait. With a feeder that keeps up it happens only after a stop.
#pragma once
#include <cstddef>

namespace bead {

// The feed (mm/s) that is left of `feed` for a move of this length (mm).
inline double slowed_feed(double feed, double length, std::size_t queued) {
    constexpr double least_time = 0.02;  // s
    constexpr std::size_t half_ring = 8;
    const double time = length / feed;
    if (queued < 2 || queued >= half_ring || time >= least_time) return feed;
    return length / (time + 2 * (least_time - time) / double(queued));
}

}  // namespace bead
