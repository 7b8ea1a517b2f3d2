#include "motion/motor_motion.h"

#include <algorithm>

#include "core/expects.h"
#include "motion/delta_arms.h"
#include "motion/linear_drive.h"
#include "motion/phases.h"

namespace bead {
namespace {

constexpr double standstill = 1e-9;  // mm; positions are whole steps, less is rounding

double square(double x) { return x * x; }

MotorMotion even_motion(double displacement, const Block& block) {
    MotorMotion motion{.displacement = displacement, .way = std::abs(displacement)};
    if (motion.way < standstill) motion.hold = duration(block);
    if (block.length <= 0) return motion;
    const double share = motion.way / block.length;
    const double peak = square(block.v_peak);
    motion.gained = square(share) * (peak - square(block.v_entry)) / 2;
    motion.lost = square(share) * (peak - square(block.v_exit)) / 2;
    motion.coast = share * block.v_peak * block.t_cruise;
    return motion;
}

PerAxis<MotorMotion> even_motions(const PerAxis<double>& displacement, const Block& block) {
    PerAxis<MotorMotion> motions;
    for (std::size_t i = 0; i < motions.size(); ++i)
        motions[i] = even_motion(displacement[i], block);
    return motions;
}

double way(const Carriage& carriage, double from, double to) {
    const double turn = carriage.turning_point();
    const double start = carriage.height(from), end = carriage.height(to);
    if (!(turn > from && turn < to)) return std::abs(end - start);
    const double top = carriage.height(turn);
    return (top - start) + (top - end);
}

double between(double from, double value, double to) {
    return value > from && value < to ? value : from;
}

// Where f, of one sign at `from` and of the other at `to`, is zero; `from` if it does not change.
template <class Function>
double crossing(const Function& f, double from, double to) {
    const bool positive = f(from) > 0;
    if (positive == (f(to) > 0)) return from;
    for (int i = 0; i < 60; ++i) {
        const double middle = (from + to) / 2;
        ((f(middle) > 0) == positive ? from : to) = middle;
    }
    return from;
}

// A motor's speed is q = h'(s) v(s). Its square has an end of rise or fall only where q is zero
// or does not change, h'' v² + h' a = 0; in between, half the difference is what it gains or loses.
void add_changes(MotorMotion& motion, const Carriage& carriage, const Phase& phase) {
    const auto pace = [&](double s) {
        const Carriage::Slope h = carriage.slope(s);
        return h.bend * squared_speed(phase, s) + h.rate * phase.acceleration;
    };
    const double split = between(phase.from, carriage.splitting_point(), phase.to);
    std::array<double, 5> stops{phase.from, between(phase.from, carriage.turning_point(), phase.to),
                                crossing(pace, phase.from, split), crossing(pace, split, phase.to),
                                phase.to};
    std::ranges::sort(stops);
    double before = 0;
    for (const double s : stops) {
        const double now = square(carriage.slope(s).rate) * squared_speed(phase, s) / 2;
        if (s > phase.from) (now > before ? motion.gained : motion.lost) += std::abs(now - before);
        before = now;
    }
}

MotorMotion carriage_motion(const Carriage& carriage, const Block& block) {
    const std::array<Phase, 3> phases = phases_of(block);
    MotorMotion motion;
    motion.displacement = carriage.height(block.length) - carriage.height(0);
    motion.way = way(carriage, 0, block.length);
    motion.coast = way(carriage, phases[1].from, phases[1].to);
    if (motion.way < standstill) motion.hold = duration(block);
    for (const Phase& phase : phases)
        if (phase.to > phase.from) add_changes(motion, carriage, phase);
    return motion;
}

bool head_moves(const Block& block) {
    return block.delta[axis_x] != 0 || block.delta[axis_y] != 0 || block.delta[axis_z] != 0;
}

}  // namespace

PerAxis<MotorMotion> motor_motion(Kinematics kinematics, const Block& block) {
    BEAD_EXPECTS(kinematics != Kinematics::delta);
    if (kinematics == Kinematics::corexy)
        return even_motions(motors_of<Kinematics::corexy>(block.delta), block);
    if (kinematics == Kinematics::corexz)
        return even_motions(motors_of<Kinematics::corexz>(block.delta), block);
    return even_motions(block.delta, block);
}

PerAxis<MotorMotion> motor_motion(const Delta& delta, Vec2 from, const Block& block) {
    PerAxis<MotorMotion> motions = even_motions({0, 0, 0, block.delta[axis_e]}, block);
    if (!head_moves(block)) return motions;
    const Carriages carriages = carriages_of(delta, from, block);
    for (std::size_t i = 0; i < carriages.size(); ++i)
        motions[i] = carriage_motion(carriages[i], block);
    return motions;
}

}  // namespace bead
