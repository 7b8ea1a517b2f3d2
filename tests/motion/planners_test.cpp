// Laws that every planner keeps, over the same random programs.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "motion/axis_times.h"
#include "support/planned.h"
#include "support/random_program.h"

namespace bead {
namespace {

using test::ProgramShape;
using test::random_program;
using test::total_time;

std::vector<Block> blocks_of(const std::vector<Command>& program, const PlannerOptions& options,
                             const Limits& limits = {}) {
    return test::planned(limits, options, [&](const CommandSink& sink) {
        for (const Command& command : program) sink(command);
    });
}

double covered(const Block& b) {
    return b.t_accel * (b.v_entry + b.v_peak) / 2 + b.t_cruise * b.v_peak +
           b.t_decel * (b.v_peak + b.v_exit) / 2;
}

bool moves_head(const Block& b) {
    return b.delta[axis_x] != 0 || b.delta[axis_y] != 0 || b.delta[axis_z] != 0;
}

double axis_speed(double v, const Block& b, std::size_t axis) {
    return v * b.delta[axis] / b.length;
}

class EveryPlanner : public testing::TestWithParam<PlannerOptions> {
  protected:
    [[nodiscard]] Firmware firmware() const { return GetParam().firmware; }
    [[nodiscard]] bool counts_steps() const {
        return firmware() != Firmware::klipper && firmware() != Firmware::s_curve;
    }
    // Quirks in which the firmware's speed jumps where two blocks meet.
    [[nodiscard]] bool may_jump() const {
        const bool jerk = firmware() == Firmware::prusa || firmware() == Firmware::prusa_2017 ||
                          firmware() == Firmware::marlin_jerk;
        return jerk;
    }
};

TEST_P(EveryPlanner, ProfilesCoverTheirLengthBelowNominalSpeed) {
    const bool trapezoids = firmware() != Firmware::s_curve;
    for (unsigned seed = 1; seed <= 15; ++seed)
        for (const Block& b : blocks_of(random_program(seed), GetParam())) {
            if (trapezoids) {
                ASSERT_NEAR(covered(b), b.length, 1e-9 * b.length + 1e-12) << "seed " << seed;
            }
            ASSERT_LE(std::max({b.v_entry, b.v_peak, b.v_exit}), b.v_nominal * (1 + 1e-9));
            ASSERT_GE(b.v_peak, std::max(b.v_entry, b.v_exit));
            ASSERT_GE(std::min({b.t_accel, b.t_cruise, b.t_decel}), 0);
            ASSERT_GE(duration(b) * b.v_nominal, b.length * (1 - 1e-9));
            ASSERT_GT(duration(b), 0);
        }
}

TEST_P(EveryPlanner, SpeedChangesNoFasterThanTheAccelerationAllows) {
    for (unsigned seed = 1; seed <= 15; ++seed)
        for (const Block& b : blocks_of(random_program(seed), GetParam()))
            ASSERT_LE(std::abs(b.v_exit * b.v_exit - b.v_entry * b.v_entry),
                      2 * b.acceleration * b.length * (1 + 1e-9) + 1e-9)
                << "seed " << seed << " line " << b.line;
}

TEST_P(EveryPlanner, KeepsTheLimitsOfSpeed) {
    const Limits limits;
    for (unsigned seed = 1; seed <= 10; ++seed)
        for (const Block& b : blocks_of(random_program(seed), GetParam())) {
            for (const Axis i : {axis_x, axis_y, axis_z, axis_e}) {
                // Klipper limits the filament only where it moves alone or backwards.
                const bool free = firmware() == Firmware::klipper && i == axis_e && moves_head(b);
                if (!free) {
                    ASSERT_LE(std::abs(axis_speed(b.v_nominal, b, i)),
                              limits.max_feedrate[i] * (1 + 1e-6));
                }
            }
        }
}

TEST_P(EveryPlanner, SpeedIsTheSameOnBothSidesOfAJunction) {
    if (may_jump()) GTEST_SKIP() << "a jerk's speeds may step; see the tests of jerk";
    for (unsigned seed = 1; seed <= 15; ++seed) {
        const std::vector<Block> blocks =
            blocks_of(random_program(seed, {.drains = false}), GetParam());
        for (std::size_t k = 1; k < blocks.size(); ++k)
            ASSERT_NEAR(blocks[k].v_entry, blocks[k - 1].v_exit, 1e-4)
                << "seed " << seed << " line " << blocks[k].line;
    }
}

TEST_P(EveryPlanner, BeginsAndEndsAtRestOrASafeSpeed) {
    const Limits limits;
    for (unsigned seed = 1; seed <= 10; ++seed) {
        const std::vector<Block> blocks = blocks_of(random_program(seed), GetParam());
        // 2.5 times: a quirk lets a path begin at an axis' jerk, whatever its direction.
        const auto most = limits.jerk[axis_x] * 1.0001;
        for (std::size_t i = 0; i < 2; ++i) {
            ASSERT_LE(std::abs(axis_speed(blocks.front().v_entry, blocks.front(), i)), most);
            ASSERT_LE(std::abs(axis_speed(blocks.back().v_exit, blocks.back(), i)), most);
        }
    }
}

TEST_P(EveryPlanner, GoesAllTheWay) {
    for (unsigned seed = 1; seed <= 10; ++seed) {
        const std::vector<Command> program = random_program(seed);
        Position start{100, 100, 0.2, 0}, end{};
        std::vector<Command> all{{Move{start, 50, Role::travel, {}}, 0}};
        for (const Command& command : program) {
            all.push_back(command);
            if (const Move* const move = std::get_if<Move>(&command.what)) end = move->to;
        }
        Position way{};
        for (const Block& b : blocks_of(all, GetParam()))
            for (std::size_t i = 0; i < way.size(); ++i) way[i] += b.delta[i];
        for (std::size_t i = 0; i < way.size(); ++i)  // the last moves may be too short to be made
            ASSERT_NEAR(way[i], end[i], counts_steps() ? 0.1 : 1e-6) << "seed " << seed;
    }
}

TEST_P(EveryPlanner, AxisTimesSumToTheWhole) {
    PerAxis<AxisTimes> times;
    double whole = 0;
    for (const Block& block : blocks_of(random_program(5), GetParam())) {
        add(times, block);
        whole += duration(block);
    }
    for (const AxisTimes& axis : times)
        EXPECT_NEAR(axis.accelerate + axis.coast + axis.decelerate + axis.hold, whole,
                    1e-9 * whole);
}

// Twice the lengths, speeds, accelerations and jerks: the same times.
TEST_P(EveryPlanner, EverythingTwiceAsLargeTakesAsLong) {
    Limits large;
    for (auto* values : {&large.max_feedrate, &large.max_acceleration, &large.jerk})
        for (double& value : *values) value *= 2;
    for (double* value :
         {&large.acceleration, &large.retract_acceleration, &large.travel_acceleration,
          &large.junction_deviation, &large.square_corner_velocity, &large.extrude_only_velocity,
          &large.extrude_only_acceleration, &large.instantaneous_corner_velocity, &large.path_jerk})
        *value *= 2;
    for (double& steps : large.steps_per_mm) steps /= 2;  // the same whole steps
    for (unsigned seed = 1; seed <= 5; ++seed) {
        // Not below 1 mm, where Marlin counts a move as a chord of an arc.
        const std::vector<Command> program = random_program(seed, {.shortest = 2});
        std::vector<Command> doubled = program;
        for (Command& command : doubled)
            if (Move* const move = std::get_if<Move>(&command.what)) {
                for (double& x : move->to) x *= 2;
                move->feed *= 2;
            }
        const double once = total_time(blocks_of(program, GetParam()));
        EXPECT_NEAR(total_time(blocks_of(doubled, GetParam(), large)), once, 2e-4 * once);
    }
}

TEST_P(EveryPlanner, HigherLimitsTakeNoLonger) {
    if (!GetParam().corrected && counts_steps()) GTEST_SKIP() << "the firmware's quirks break it";
    Limits fast;
    for (double& a : fast.max_acceleration) a *= 3;
    for (double* a : {&fast.acceleration, &fast.retract_acceleration, &fast.travel_acceleration,
                      &fast.extrude_only_acceleration})
        *a *= 3;
    // Klipper's and our own corners are set by a speed, whatever the acceleration.
    for (unsigned seed = 1; seed <= 5; ++seed) {
        const std::vector<Command> program = random_program(seed);
        EXPECT_LE(total_time(blocks_of(program, GetParam(), fast)),
                  total_time(blocks_of(program, GetParam())) * (1 + 1e-9));
    }
}

TEST_P(EveryPlanner, EventsKeepTheirPlaceBetweenMoves) {
    std::vector<std::string> seen;
    const auto planner = make_planner({}, GetParam(), [&](const MotionEvent& event) {
        seen.emplace_back(std::holds_alternative<Block>(event)    ? "move"
                          : std::holds_alternative<SetFan>(event) ? "fan"
                          : std::holds_alternative<Dwell>(event)  ? "dwell"
                                                                  : "layer");
    });
    planner->add({LayerStart{0.2, 0.2}, 1});
    planner->add({Move{{10, 0, 0, 0}, 50, Role::travel, {}}, 1});
    planner->add({SetFan{1}, 2});
    planner->add({Move{{20, 0, 0, 0}, 50, Role::travel, {}}, 3});
    planner->add({LayerStart{0.4, 0.2}, 4});
    planner->add({Dwell{1}, 5});
    planner->finish();
    EXPECT_EQ(seen, (std::vector<std::string>{"layer", "move", "fan", "move", "layer", "dwell"}));
}

TEST_P(EveryPlanner, LimitsChangeForWhatFollows) {
    SetLimits change{.max_feedrate = {{50, {}, {}, {}}}};
    change.max_velocity = 50;
    const std::vector<Command> program{{Move{{100, 0, 0, 0}, 500, Role::travel, {}}, 1},
                                       {change, 2},
                                       {Move{{0, 0, 0, 0}, 500, Role::travel, {}}, 3}};
    const std::vector<Block> blocks = blocks_of(program, GetParam());
    ASSERT_EQ(blocks.size(), 2U);
    EXPECT_NEAR(blocks[0].v_nominal, 200, 1e-4);
    EXPECT_NEAR(blocks[1].v_nominal, 50, 1e-4);
}

TEST_P(EveryPlanner, AFullCircleIsAsLongAsItsArc) {
    Arc arc;
    arc.end = {{10, 0, 0, 5}, 40, Role::wall, {}};
    const std::vector<Command> program{{Move{{10, 0, 0, 0}, 40, Role::travel, {}}, 1}, {arc, 2}};
    double way = 0;
    for (const Block& b : blocks_of(program, GetParam()))
        if (b.line == 2) way += b.length;
    EXPECT_NEAR(way, 20 * pi, 0.1);
}

TEST_P(EveryPlanner, HoldsNoMoreThanAWindow) {
    std::size_t given = 0, passed = 0, most = 0;
    const auto planner = make_planner({}, GetParam(), [&](const MotionEvent&) { ++passed; });
    for (int i = 0; i < 30'000; ++i) {  // a circle of 0.1 mm chords, which never halts
        const double angle = 0.1 / 50 * i;
        planner->add(
            {Move{{50 * std::cos(angle), 50 * std::sin(angle), 0, 0}, 150, Role::infill, {}}, i});
        ++given;
        most = std::max(most, given - passed);
    }
    planner->finish();
    EXPECT_LT(most, 5000U);
}

std::vector<PlannerOptions> every_planner() {
    std::vector<PlannerOptions> all;
    for (std::size_t i = 0; i < firmware_names.size(); ++i)
        for (const bool corrected : {false, true})
            for (const int depth : {16, 0}) all.push_back({Firmware(i), corrected, depth});
    return all;
}

INSTANTIATE_TEST_SUITE_P(All, EveryPlanner, testing::ValuesIn(every_planner()),
                         [](const auto& instance) {
                             std::string name(name_of(instance.param.firmware));
                             std::erase(name, '-');
                             return name + (instance.param.corrected ? "Corrected" : "Faithful") +
                                    (instance.param.lookahead == 0 ? "Unlimited" : "Ring");
                         });

}  // namespace
}  // namespace bead
