#include "motion/marlin.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdlib>

#include "core/expects.h"
#include "geom/vec.h"
#include "motion/arc_chords.h"
#include "motion/limit_changes.h"
#include "motion/obey.h"
#include "motion/slowdown.h"

namespace bead {
namespace {

constexpr float least_speed = 0.05F;        // mm/s, at which a print begins and ends
constexpr double least_marlin_feed = 0.05;  // mm/s; slower is taken as this
constexpr float halt_preference = 0.99F;
constexpr float still = 1e-6F;  // mm/s
constexpr std::int64_t most_of_32_bits = 4294967295;

float square(float v) { return v * v; }

float size_of(const PerAxis<float>& v) {
    float sum = 0;
    for (const float x : v) sum += x * x;
    return std::sqrt(sum);
}

PerAxis<float> unit(PerAxis<float> v) {
    const float factor = 1.0F / size_of(v);
    for (float& x : v) x *= factor;
    return v;
}

// Arc cosine near 1 by straight pieces, each half as wide as the one before: piece k covers 1 - t
// from 2^-k to 2^-(k+1). Slopes and offsets are the firmware's own.
struct Piece {
    float slope, offset;
};
constexpr std::array<Piece, 16> arc_cosine{{{-1.03145837F, 1.57079637F},
                                            {-1.30760646F, 1.70887053F},
                                            {-1.75205851F, 2.04220939F},
                                            {-2.41705704F, 2.62408352F},
                                            {-3.37769222F, 3.52467871F},
                                            {-4.74888992F, 4.85302639F},
                                            {-6.69649887F, 6.77020454F},
                                            {-9.45661736F, 9.50875854F},
                                            {-13.3640480F, 13.4009285F},
                                            {-18.8928222F, 18.9188995F},
                                            {-26.7136841F, 26.7321243F},
                                            {-37.7754593F, 37.7885055F},
                                            {-53.4201813F, 53.4293975F},
                                            {-75.5458374F, 75.5523529F},
                                            {-106.836761F, 106.841369F},
                                            {-218.532821F, 218.534011F}}};

// Angle by which the path turns, rad, from the cosine of the angle between the two legs, which is
// below zero; the firmware's is good to 0.01.
float turning_angle(float cos_corner, bool exact) {
    const float t = -cos_corner;
    if (exact) return std::acos(t);
    constexpr float finest = 1U << (arc_cosine.size() - 1);
    const auto width = static_cast<std::uint16_t>((1 - t) * finest);
    const auto& [slope, offset] = arc_cosine[std::size_t(std::countl_zero(width)) - 1];
    return t * slope + offset;
}

}  // namespace

MarlinPlanner::MarlinPlanner(const Limits& limits, const MarlinOptions& options, MotionSink sink)
    : limits_(limits), options_(options), queue_({.depth = options.lookahead}, std::move(sink)) {
    BEAD_EXPECTS(options.lookahead == 0 || options.lookahead >= 4);
}

void MarlinPlanner::add(const Command& command) { obey(*this, command); }

void MarlinPlanner::set_position(const SetPosition& position) {
    for (const Axis i : {axis_x, axis_y, axis_z, axis_e}) {
        if (!position.to[i]) continue;
        place_[i] = *position.to[i];
        frame_.set(i, place_[i], limits_);
    }
}

void MarlinPlanner::home(const Home& home) {
    for (const Axis i : {axis_x, axis_y, axis_z}) {
        if (!home.axes[i]) continue;
        place_[i] = 0;
        frame_.home(i);
    }
}

void MarlinPlanner::change(const SetLimits& limits) { limits_ = changed(limits_, limits); }

void MarlinPlanner::arc(const Arc& arc, std::int64_t line) {
    each_chord(arc, place_, {ArcStyle::marlin, limits_.arc_resolution},
               [&](const Move& chord) { move(chord, line); });
}

void MarlinPlanner::move(const Move& move, std::int64_t line) {
    place_ = move.to;
    StepMove taken;
    if (!frame_.take(move.to, limits_, taken)) return;
    queue_.make_room();
    Block& block = queue_.block();
    block.line = line;
    block.role = move.role;
    block.bead = move.bead;
    for (std::size_t i = 0; i < block.delta.size(); ++i)
        block.delta[i] = static_cast<double>(taken.steps[i]) / limits_.steps_per_mm[i];
    const Planned planned = measured(taken, move.feed);
    block.length = planned.length;
    block.v_nominal = planned.nominal;
    block.acceleration = planned.acceleration;

    const bool first = queue_.waiting() == 0 || previous_nominal_ < still;
    const float corner = options_.junction_deviation ? corner_by_deviation(planned, first)
                                                     : corner_by_jerk(planned, first);
    const bool at_rest = queue_.empty();
    const float brake = square(least_speed) + 2 * planned.acceleration * planned.length;
    const bool at_nominal = square(planned.nominal) <= brake;
    const float most = at_rest ? square(least_speed) : corner;
    queue_.push({.max_entry = most,
                 .entry = at_nominal ? most : std::min(most, brake),
                 .last_exit = square(least_speed),
                 .at_nominal = at_nominal});
    previous_speed_ = planned.speed;
    previous_nominal_ = planned.nominal;
}

MarlinPlanner::Planned MarlinPlanner::measured(const StepMove& taken, double feed) const {
    Planned p;
    for (std::size_t i = 0; i < p.way.size(); ++i)
        p.way[i] = float(taken.steps[i]) * (1.0F / float(limits_.steps_per_mm[i]));
    p.extrudes = taken.steps[axis_e] != 0;
    p.length =
        taken.filament
            ? std::abs(p.way[axis_e])
            : std::sqrt(square(p.way[axis_x]) + square(p.way[axis_y]) + square(p.way[axis_z]));
    const float per_length = 1.0F / p.length;
    double asked = std::max(feed, least_marlin_feed);
    if (limits_.slowdown) asked = slowed_feed(asked, p.length, queue_.waiting());
    const float per_second = float(asked) * per_length;
    p.nominal = p.length * per_second;
    float factor = 1;
    for (std::size_t i = 0; i < p.speed.size(); ++i) {
        p.speed[i] = p.way[i] * per_second;
        const float size = std::abs(p.speed[i]), most = float(limits_.max_feedrate[i]);
        if (size > most) factor = std::min(factor, most / size);
    }
    if (factor < 1) {
        for (float& v : p.speed) v *= factor;
        p.nominal *= factor;
    }
    const float steps_per_mm = float(taken.longest) * per_length;
    p.acceleration = path_acceleration(taken, steps_per_mm) / steps_per_mm;
    return p;
}

// Steps/s² of the axis that makes most steps: whole ones.
float MarlinPlanner::path_acceleration(const StepMove& taken, float steps_per_mm) const {
    const double asked = !taken.head                ? limits_.retract_acceleration
                         : taken.steps[axis_e] != 0 ? limits_.acceleration
                                                    : limits_.travel_acceleration;
    auto rate = static_cast<std::int64_t>(std::ceil(float(asked) * steps_per_mm));
    if (!taken.head) return float(rate);
    PerAxis<std::int64_t> most;
    for (std::size_t i = 0; i < most.size(); ++i)
        most[i] = std::max<std::int64_t>(
            1, static_cast<std::int64_t>(limits_.max_acceleration[i] * limits_.steps_per_mm[i]));
    const bool whole = taken.longest <= most_of_32_bits / *std::ranges::max_element(most);
    for (const Axis i : {axis_e, axis_x, axis_y, axis_z}) {
        const std::int64_t steps = std::abs(taken.steps[i]);
        if (steps == 0 || most[i] >= rate) continue;
        const std::int64_t allowed =
            whole ? most[i] * taken.longest / steps
                  : std::int64_t(float(most[i]) * float(taken.longest) / float(steps));
        rate = std::min(rate, allowed);
    }
    return float(std::max<std::int64_t>(1, rate));
}

// Speed squared at the corner before the block.
float MarlinPlanner::corner_by_deviation(const Planned& p, bool first) {
    Floats direction = p.way;
    if (p.extrudes)
        direction = unit(direction);
    else
        for (float& x : direction) x *= 1.0F / p.length;
    const Floats before = std::exchange(previous_direction_, direction);
    if (first) return 0;

    float cosine = 0;  // of the angle between the legs: -1 is straight on
    for (std::size_t i = 0; i < direction.size(); ++i) cosine += -before[i] * direction[i];
    if (cosine > 0.999999F) return square(least_speed);
    cosine = std::max(cosine, -0.999999F);

    Floats across;
    for (std::size_t i = 0; i < across.size(); ++i) across[i] = direction[i] - before[i];
    across = unit(across);
    float acceleration = p.acceleration;
    for (std::size_t i = 0; i < across.size(); ++i) {
        const auto most = float(limits_.max_acceleration[i]);
        if (acceleration * std::abs(across[i]) > most) acceleration = std::abs(most / across[i]);
    }
    const float half_sine = std::sqrt(0.5F * (1.0F - cosine));
    float corner =
        acceleration * float(limits_.junction_deviation) * half_sine / (1.0F - half_sine);
    if (p.length < 1 && cosine < -0.7071067812F)
        corner =
            std::min(corner, p.length * acceleration / turning_angle(cosine, options_.corrected));
    return std::min({corner, square(p.nominal), square(previous_nominal_)});
}

float MarlinPlanner::corner_by_jerk(const Planned& p, bool first) {
    float safe = p.nominal;
    for (std::size_t i = 0; i < p.speed.size(); ++i) {
        const float size = std::abs(p.speed[i]), most = float(limits_.jerk[i]);
        if (size > most) safe = std::min(safe, p.nominal * (most / size));
    }
    const float before = std::exchange(previous_safe_, safe);
    if (first) return square(safe);

    float common = std::min(p.nominal, previous_nominal_);
    const float slowed = common / previous_nominal_;
    const float entered = options_.corrected ? common / p.nominal : 1.0F;
    float factor = 1;
    for (std::size_t i = 0; i < p.speed.size(); ++i) {
        const float out = previous_speed_[i] * slowed, in = p.speed[i] * entered;
        const float jerk =
            out * in > 0 ? std::abs(out - in) : std::max(std::abs(out), std::abs(in));
        const float most = float(limits_.jerk[i]);
        if (jerk > most) factor = std::min(factor, most / jerk);
    }
    common *= factor;
    const float threshold = halt_preference * common;
    return square(before > threshold && safe > threshold ? safe : common);
}

}  // namespace bead
