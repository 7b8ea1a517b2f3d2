#include "energy/block_part.h"

#include <algorithm>

#include "core/expects.h"

namespace bead {
namespace {

// How the head goes: speeds (mm/s) and ways (mm) after a time. Slopes come from the phases' own
// ends, so that blocks whose times are rounded are cut at no loss.
class Motion {
  public:
    explicit Motion(const Block& block) : b_(block) {}

    [[nodiscard]] double speed(double t) const {
        if (t < b_.t_accel) return b_.v_entry + rise() * t;
        const double braking = t - b_.t_accel - b_.t_cruise;
        return braking <= 0 || b_.t_decel <= 0 ? b_.v_peak : b_.v_peak - fall() * braking;
    }
    [[nodiscard]] double way(double t) const {
        const double up = std::min(t, b_.t_accel);
        const double level = std::clamp(t - b_.t_accel, 0.0, b_.t_cruise);
        const double down = std::clamp(t - b_.t_accel - b_.t_cruise, 0.0, b_.t_decel);
        return (b_.v_entry + speed_up(up)) / 2 * up + b_.v_peak * level +
               (b_.v_peak - (b_.t_decel > 0 ? fall() * down / 2 : 0)) * down;
    }

  private:
    [[nodiscard]] double rise() const { return (b_.v_peak - b_.v_entry) / b_.t_accel; }
    [[nodiscard]] double fall() const { return (b_.v_peak - b_.v_exit) / b_.t_decel; }
    [[nodiscard]] double speed_up(double t) const {
        return b_.t_accel > 0 ? b_.v_entry + rise() * t : b_.v_peak;
    }

    const Block& b_;
};

// How much of [from, to] lies in the phase that begins at `start`.
double overlap(double from, double to, double start, double lasting) {
    return std::max(0.0, std::min(to, start + lasting) - std::max(from, start));
}

}  // namespace

Block part_of(const Block& block, double from, double to) {
    BEAD_EXPECTS(from <= to);
    const Motion motion(block);
    const double whole = motion.way(duration(block));
    const double share = whole > 0 ? (motion.way(to) - motion.way(from)) / whole : 0;
    const double level = block.t_accel, down = block.t_accel + block.t_cruise;
    Block part = block;
    for (double& d : part.delta) d *= share;
    part.length *= share;
    part.v_entry = motion.speed(from);
    part.v_exit = motion.speed(to);
    part.v_peak = motion.speed(std::clamp(level, from, to));
    part.t_accel = overlap(from, to, 0, block.t_accel);
    part.t_cruise = overlap(from, to, level, block.t_cruise);
    part.t_decel = overlap(from, to, down, block.t_decel);
    return part;
}

}  // namespace bead
