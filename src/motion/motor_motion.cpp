#include "motion/motor_motion.h"

#include <algorithm>

#include "core/expects.h"
#include "motion/delta_arms.h"
#include "motion/integral.h"
#include "motion/linear_drive.h"
#include "motion/phases.h"

namespace bead {
namespace {

constexpr double standstill = 1e-9;  // mm; positions are whole steps, less is rounding
constexpr double accuracy = 1e-6;    // of the greatest speed squared

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

// A motor that goes with speed q = h'(s) v(s) gains ∫ q (dq/dt) dt; over the way that is
// ∫ h' (h'' v² + h' a) ds, its positive part while q grows in size.
void add_changes(MotorMotion& motion, const Carriage& carriage, const Phase& phase,
                 double tolerance) {
    const auto change = [&](double s) {
        const Carriage::Slope h = carriage.slope(s);
        const double dq = h.rate * (h.bend * squared_speed(phase, s) + h.rate * phase.acceleration);
        return std::array{std::max(0.0, dq), std::max(0.0, -dq)};
    };
    const auto [gained, lost] = integral(change, phase.from, phase.to, tolerance);
    motion.gained += gained;
    motion.lost += lost;
}

MotorMotion carriage_motion(const Carriage& carriage, const Block& block) {
    const std::array<Phase, 3> phases = phases_of(block);
    MotorMotion motion;
    motion.displacement = carriage.height(block.length) - carriage.height(0);
    motion.way = way(carriage, 0, block.length);
    motion.coast = way(carriage, phases[1].from, phases[1].to);
    if (motion.way < standstill) motion.hold = duration(block);
    for (const Phase& phase : phases)
        if (phase.to > phase.from)
            add_changes(motion, carriage, phase, accuracy * square(block.v_peak) / 3);
    return motion;
}

bool moves_head(const Block& block) {
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
    if (!moves_head(block)) return motions;
    const Carriages carriages = carriages_of(delta, from, block);
    for (std::size_t i = 0; i < carriages.size(); ++i)
        motions[i] = carriage_motion(carriages[i], block);
    return motions;
}

}  // namespace bead
