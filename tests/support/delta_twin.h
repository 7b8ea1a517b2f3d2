// A linear delta from first principles, in small steps: arms of fixed length, forces along them.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>

#include "geom/vec.h"
#include "machine/kinematics.h"
#include "machine/power.h"
#include "support/blocks.h"

namespace bead::test {

inline constexpr Delta a_delta{.arm = 300, .radius = 160, .head_mass = 0.35};

// A block and a place over the bed for it to start from, within 120 mm of the middle.
struct PlacedBlock {
    Block block;
    Vec2 from;
};
inline PlacedBlock any_placed_block() {
    const Vec2 from = number_between(0, 120) * unit(number_between(0, 2 * pi));
    const Vec2 to = number_between(0, 120) * unit(number_between(0, 2 * pi));
    const double z = *rc::gen::inRange(0, 3) == 0 ? number_between(-30, 30) : 0;
    const PerAxis<double> delta{to.x - from.x, to.y - from.y, z + 1e-3, number_between(-1, 2)};
    const double v = number_between(1, 300), a = number_between(100, 8000);
    Block block = trapezoid(delta, 0, 0, v, a);
    const double v0 = number_between(0, block.v_peak), v1 = number_between(0, block.v_peak);
    return {trapezoid(delta, v0, v1, v, a), from};
}

inline Vec2 tower(const Delta& delta, std::size_t i) {
    return delta.radius * unit((210 + 120 * static_cast<double>(i)) * pi / 180);
}

inline double carriage_height(const Delta& delta, std::size_t i, Vec3 head) {
    const Vec2 flat_arm = flat(head) - tower(delta, i);
    return head.z + std::sqrt(delta.arm * delta.arm - dot(flat_arm, flat_arm));
}

// Way along a block's path (mm) after t seconds.
inline double way_after(const Block& b, double t) {
    const double up = std::min(t, b.t_accel);
    const double cruise = std::clamp(t - b.t_accel, 0.0, b.t_cruise);
    const double down = std::clamp(t - b.t_accel - b.t_cruise, 0.0, b.t_decel);
    const double a_up = b.t_accel > 0 ? (b.v_peak - b.v_entry) / b.t_accel : 0;
    const double a_down = b.t_decel > 0 ? (b.v_peak - b.v_exit) / b.t_decel : 0;
    return b.v_entry * up + a_up * up * up / 2 + b.v_peak * cruise + b.v_peak * down -
           a_down * down * down / 2;
}

inline Vec3 head_at(const PlacedBlock& placed, double way) {
    const PerAxis<double>& d = placed.block.delta;
    const double part = way / placed.block.length;
    return {placed.from.x + part * d[axis_x], placed.from.y + part * d[axis_y], part * d[axis_z]};
}

inline Vec3 head_after(const PlacedBlock& placed, double t) {
    return head_at(placed, way_after(placed.block, t));
}

// Tension of the three arms (N) that together give `force` (N) on the head.
inline std::array<double, 3> tensions(const Delta& delta, Vec3 head, Vec3 force) {
    std::array<Vec3, 3> arm;
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec3 joint = at_height(tower(delta, i), carriage_height(delta, i, head));
        arm[i] = (1 / delta.arm) * (joint - head);
    }
    const double volume = dot(arm[0], cross(arm[1], arm[2]));
    return {dot(force, cross(arm[1], arm[2])) / volume, dot(force, cross(arm[2], arm[0])) / volume,
            dot(force, cross(arm[0], arm[1])) / volume};
}

// J of all three towers above standing.
inline double towers_by_steps(const std::array<Motor, 4>& motors, const Delta& delta,
                              const PlacedBlock& placed, int steps) {
    const double dt = duration(placed.block) / steps;
    double joules = 0;
    for (int k = 0; k < steps; ++k) {
        const double t = (k + 0.5) * dt, h = 0.25 * dt;
        const Vec3 before = head_after(placed, t - h), now = head_after(placed, t),
                   after = head_after(placed, t + h);
        const Vec3 a = (1e-3 / (h * h)) * (after + before - 2 * now);  // m/s²
        const Vec3 force = delta.head_mass * (a + Vec3{0, 0, 9.80665});
        const std::array<double, 3> pull = tensions(delta, now, force);
        for (std::size_t i = 0; i < 3; ++i) {
            const double low = carriage_height(delta, i, before),
                         middle = carriage_height(delta, i, now),
                         high = carriage_height(delta, i, after);
            const double w = (high - low) / (2 * h) * 1e-3;                // m/s
            const double dw = (high + low - 2 * middle) / (h * h) * 1e-3;  // m/s²
            const double upright = (middle - now.z) / delta.arm;
            const double tau = motors[i].moving_mass * (dw + 9.80665) + pull[i] * upright;
            const double work = motors[i].friction * std::abs(w) + tau * w;
            joules += dt * (motors[i].per_speed * 1e3 * std::abs(w) +
                            std::max(0.0, work) / motors[i].efficiency);
        }
    }
    return joules;
}

}  // namespace bead::test
