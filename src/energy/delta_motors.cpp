#include "energy/delta_motors.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "energy/integral.h"
#include "energy/units.h"
#include "motion/delta_arms.h"
#include "motion/phases.h"

namespace bead {
namespace {

constexpr double accuracy = 1e-7;    // J a block
constexpr double gravity = 9806.65;  // mm/s²

using Towers = std::array<double, 3>;
using Slopes = std::array<Carriage::Slope, 3>;

// How the towers share a force on the head: what they give together is the force, along each of X,
// Y and Z.
Towers shared(Vec3 force, const Slopes& h) {
    const Vec2 b = h[1].lean - h[0].lean, c = h[2].lean - h[0].lean;
    const Vec2 rest = flat(force) - force.z * h[0].lean;
    const double scale = 1 / cross(b, c);
    const double on_b = cross(rest, c) * scale, on_c = cross(b, rest) * scale;
    return {force.z - on_b - on_c, on_b, on_c};
}

// Everything about a block that does not change along it.
struct Scene {
    const std::array<Motor, 4>& motors;
    double head_mass;
    Vec3 step;  // of the head per mm of its way
    Carriages carriages;
};

// What the towers draw per mm of the head's way, J/mm: the three by speed, then the three for work.
using Costs = std::array<double, 6>;

Costs cost_at(const Scene& scene, const Phase& phase, double s) {
    const Slopes h{scene.carriages[0].slope(s), scene.carriages[1].slope(s),
                   scene.carriages[2].slope(s)};
    const double a = phase.acceleration, squared = squared_speed(phase, s);
    const Vec3 push = a * scene.step + Vec3{0, 0, gravity};
    const Towers head = shared(scene.head_mass * kg_mm2_per_s2 * push, h);
    Costs cost{};
    for (std::size_t i = 0; i < head.size(); ++i) {
        const Motor& motor = scene.motors[i];
        const double lift = h[i].bend * squared + h[i].rate * a + gravity;
        const double pull = head[i] + motor.moving_mass * kg_mm2_per_s2 * lift;
        const double turning = std::abs(h[i].rate);
        const double work = motor.friction * newton_mm * turning + pull * h[i].rate;
        cost[i] = motor.per_speed * turning;
        cost[i + 3] = std::max(0.0, work) / motor.efficiency;
    }
    return cost;
}

void add_phase(MotorDraw& draw, const Scene& scene, const Phase& phase) {
    const auto cost = [&](double s) {
        const Costs costs = cost_at(scene, phase, s);
        const double speed = std::sqrt(std::max(0.0, squared_speed(phase, s)));
        draw.peak = std::max(draw.peak, std::accumulate(costs.begin(), costs.end(), 0.0) * speed);
        return costs;
    };
    cost(phase.from);
    cost(phase.to);
    const Costs joules = integral(cost, phase.from, phase.to, accuracy / 6);
    for (std::size_t i = 0; i < 3; ++i) {
        draw.speed[i] += joules[i];
        draw.work[i] += joules[i + 3];
    }
}

MotorDraw towers_draw(const std::array<Motor, 4>& motors, const Delta& delta, Vec2 from,
                      const Block& block) {
    const PerAxis<double>& d = block.delta;
    MotorDraw draw;
    if (d[axis_x] == 0 && d[axis_y] == 0 && d[axis_z] == 0) return draw;
    const Vec3 step = (1 / block.length) * Vec3{d[axis_x], d[axis_y], d[axis_z]};
    const Scene scene{motors, delta.head_mass, step, carriages_of(delta, from, block)};
    draw.turns = {true, true, true, false};
    for (const Phase& phase : phases_of(block))
        if (phase.to > phase.from) add_phase(draw, scene, phase);
    return draw;
}

// The extruder has an axis of its own here too.
MotorDraw extruder_draw(const std::array<Motor, 4>& motors, const Block& block) {
    Block alone = block;
    alone.delta[axis_x] = alone.delta[axis_y] = alone.delta[axis_z] = 0;
    return motor_draw(motors, alone);
}

}  // namespace

MotorDraw delta_draw(const std::array<Motor, 4>& motors, const Delta& delta, Vec2 from,
                     const Block& block) {
    if (block.length <= 0) return {};
    MotorDraw draw = towers_draw(motors, delta, from, block);
    const MotorDraw extruder = extruder_draw(motors, block);
    draw.speed[axis_e] = extruder.speed[axis_e];
    draw.work[axis_e] = extruder.work[axis_e];
    draw.turns[axis_e] = extruder.turns[axis_e];
    draw.peak += extruder.peak;
    return draw;
}

}  // namespace bead
