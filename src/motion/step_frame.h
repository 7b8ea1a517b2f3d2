// Where a machine stands in whole motor steps, and the steps of a move from there: the front of
// every planner that counts steps (Prusa, Marlin). Coordinates are rounded as 8-bit firmware does
// it: the coordinate becomes a 32-bit float, the product with steps/mm is one too, halves go away
// from zero. With three decimals and 100 steps/mm ties are common, so the width of the float
// decides.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>

#include "machine/limits.h"
#include "motion/block.h"

namespace bead {

using Steps = PerAxis<std::int64_t>;

inline std::int64_t steps_at(double mm, double steps_per_mm) {
    const double product = static_cast<float>(mm) * static_cast<float>(steps_per_mm);
    return static_cast<std::int64_t>(product + std::copysign(0.5, product));
}

struct StepMove {
    Steps steps{};             // signed
    std::int64_t longest = 0;  // steps of the axis that makes most of them
    bool head = false;         // X, Y or Z moves at all …
    bool filament = false;     // … but so little that its length is that of the filament
};

class StepFrame {
  public:
    // False for a move too short to be queued; its way joins the next move's.
    bool take(const Position& to, const Limits& limits, StepMove& taken) {
        Steps target;
        taken.longest = 0;
        for (std::size_t i = 0; i < target.size(); ++i) {
            target[i] = steps_at(to[i], limits.steps_per_mm[i]);
            taken.steps[i] = target[i] - steps_[i];
            taken.longest = std::max<std::int64_t>(taken.longest, std::abs(taken.steps[i]));
        }
        if (taken.longest <= limits.drop_segments) return false;
        steps_ = target;
        taken.head = above(taken.steps, 0);
        taken.filament = !above(taken.steps, limits.drop_segments);
        return true;
    }

    void set(Axis axis, double mm, const Limits& limits) {
        steps_[axis] = steps_at(mm, limits.steps_per_mm[axis]);
    }
    void home(Axis axis) { steps_[axis] = 0; }

  private:
    static bool above(const Steps& steps, std::int64_t least) {
        return std::abs(steps[axis_x]) > least || std::abs(steps[axis_y]) > least ||
               std::abs(steps[axis_z]) > least;
    }

    Steps steps_{};
};

}  // namespace bead
