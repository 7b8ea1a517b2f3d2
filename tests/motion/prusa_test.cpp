#include "motion/prusa.h"

#include <gtest/gtest.h>

#include <cmath>

#include "motion/axis_times.h"
#include "support/planned.h"
#include "support/random_program.h"

namespace bead {
namespace {

using test::random_program;
using test::total_time;

std::vector<Block> blocks_of(const std::vector<Command>& program, const PrusaOptions& options,
                             const Limits& limits = {}) {
    return test::planned(limits, options, [&](const CommandSink& sink) {
        for (const Command& command : program) sink(command);
    });
}

double covered(const Block& b) {
    return b.t_accel * (b.v_entry + b.v_peak) / 2 + b.t_cruise * b.v_peak +
           b.t_decel * (b.v_peak + b.v_exit) / 2;
}

const std::vector<PrusaOptions> every_mode{{faithful_quirks(), 16},
                                           {faithful_quirks(), 0},
                                           {corrected_quirks(), 16},
                                           {corrected_quirks(), 0}};

TEST(Prusa, ProfilesCoverTheirLengthAndKeepTheirLimits) {
    const Limits limits;
    for (const PrusaOptions& mode : every_mode)
        for (unsigned seed = 1; seed <= 20; ++seed)
            for (const Block& b : blocks_of(random_program(seed), mode)) {
                ASSERT_NEAR(covered(b), b.length, 1e-9 * b.length + 1e-12) << "seed " << seed;
                ASSERT_LE(std::max({b.v_entry, b.v_peak, b.v_exit}), b.v_nominal * (1 + 1e-12));
                for (std::size_t i = 0; i < axis_count; ++i)
                    ASSERT_LE(b.v_nominal * std::abs(b.delta[i]) / b.length,
                              limits.max_feedrate[i] * (1 + 1e-9));
            }
}

// Every axis' speed steps by no more than its jerk: between two blocks, or from and to a stop.
TEST(Prusa, CorrectedJunctionsKeepTheirJerk) {
    const Limits limits;
    for (const int lookahead : {0, 16})
        for (unsigned seed = 1; seed <= 40; ++seed) {
            const std::vector<Block> blocks =
                blocks_of(random_program(seed), {corrected_quirks(), lookahead});
            for (std::size_t k = 1; k < blocks.size(); ++k) {
                const Block &a = blocks[k - 1], &b = blocks[k];
                for (std::size_t i = 0; i < axis_count; ++i) {
                    const double out = a.v_exit * a.delta[i] / a.length;
                    const double in = b.v_entry * b.delta[i] / b.length;
                    const bool halts =
                        std::max(std::abs(out), std::abs(in)) <= limits.jerk[i] * (1 + 1e-9);
                    ASSERT_TRUE(halts || std::abs(out - in) <= limits.jerk[i] * (1 + 1e-9))
                        << "seed " << seed << " lookahead " << lookahead << " block " << k
                        << " axis " << i << ": " << out << " -> " << in;
                }
            }
        }
}

TEST(Prusa, CorrectedAxesKeepTheirAcceleration) {
    const Limits limits;
    for (const Block& b : blocks_of(random_program(7), {corrected_quirks(), 0})) {
        const bool head = b.delta[axis_x] != 0 || b.delta[axis_y] != 0 || b.delta[axis_z] != 0;
        for (std::size_t i = 0; head && i < axis_count; ++i)
            ASSERT_LE(b.acceleration * std::abs(b.delta[i]) / b.length,
                      limits.max_acceleration[i] * (1 + 1e-9));
    }
}

TEST(Prusa, StreamingEqualsOneLongQueue) {
    for (const PrusaQuirks& quirks : {faithful_quirks(), corrected_quirks()})
        for (unsigned seed = 1; seed <= 6; ++seed) {
            const auto program =
                random_program(seed, {.moves = 1500, .longest = 2, .drains = false});
            const auto streamed = blocks_of(program, {quirks, 0});
            const auto whole = blocks_of(program, {quirks, 100'000});
            ASSERT_EQ(streamed.size(), whole.size());
            for (std::size_t k = 0; k < whole.size(); ++k) {
                ASSERT_NEAR(streamed[k].v_entry, whole[k].v_entry, 1e-9) << "seed " << seed;
                ASSERT_NEAR(streamed[k].v_exit, whole[k].v_exit, 1e-9) << "seed " << seed;
            }
        }
}

TEST(Prusa, UnlimitedLookaheadForgetsWhatIsSettled) {
    std::size_t given = 0, passed = 0, most = 0;
    PrusaPlanner planner({}, {faithful_quirks(), 0}, [&](const MotionEvent&) { ++passed; });
    for (int i = 0; i < 100'000; ++i) {  // a circle of 0.1 mm chords, which never halts
        const double angle = 0.1 / 50 * i;
        planner.add(
            {Move{{50 * std::cos(angle), 50 * std::sin(angle), 0, 0}, 150, Role::infill, {}}, i});
        ++given;
        most = std::max(most, given - passed);
    }
    planner.finish();
    EXPECT_LT(most, 2000U);
    EXPECT_EQ(passed, given);
}

// Halving every length and every acceleration's time scale: T -> T/2 when lengths, speeds and jerks
// stay and accelerations double.
TEST(Prusa, TimeScalesWithLengthOverSpeed) {
    Limits fast;
    for (double& a : fast.max_acceleration) a *= 2;
    fast.acceleration = fast.retract_acceleration = fast.travel_acceleration = 2500;
    std::vector<Command> large = random_program(3, {.shortest = 1}), small = large;
    for (Command& command : small)
        if (Move* move = std::get_if<Move>(&command.what))
            for (double& x : move->to) x /= 2;
    Limits fine = fast;
    for (double& s : fine.steps_per_mm) s *= 2;  // the same whole steps
    fine.drop_segments = fast.drop_segments;
    const double there = total_time(blocks_of(large, {corrected_quirks(), 0}));
    EXPECT_NEAR(total_time(blocks_of(small, {corrected_quirks(), 0}, fine)), there / 2,
                1e-6 * there);
}

TEST(Prusa, AxisTimesSumToTheWholeForEveryAxis) {
    PerAxis<AxisTimes> times;
    double whole = 0;
    for (const Block& block : blocks_of(random_program(5), {})) {
        add(times, block);
        whole += duration(block);
    }
    for (const AxisTimes& axis : times)
        EXPECT_NEAR(axis.accelerate + axis.coast + axis.decelerate + axis.hold, whole,
                    1e-9 * whole);
}

TEST(Prusa, ShortMovesJoinTheNextOne) {
    const std::vector<Command> program{{Move{{0.05, 0, 0, 0}, 50, Role::travel, {}}, 1},
                                       {Move{{10, 0, 0, 0}, 50, Role::travel, {}}, 2}};
    const std::vector<Block> blocks = blocks_of(program, {});
    ASSERT_EQ(blocks.size(), 1U);
    EXPECT_DOUBLE_EQ(blocks[0].length, 10);
}

TEST(Prusa, EventsKeepTheirPlaceBetweenMoves) {
    std::vector<std::string> seen;
    PrusaPlanner planner({}, {}, [&](const MotionEvent& event) {
        seen.emplace_back(std::holds_alternative<Block>(event)    ? "move"
                          : std::holds_alternative<SetFan>(event) ? "fan"
                          : std::holds_alternative<Dwell>(event)  ? "dwell"
                                                                  : "layer");
    });
    planner.add({Move{{10, 0, 0, 0}, 50, Role::travel, {}}, 1});
    planner.add({SetFan{1}, 2});
    planner.add({Move{{20, 0, 0, 0}, 50, Role::travel, {}}, 3});
    planner.add({LayerStart{0.4, 0.2}, 4});
    planner.add({Dwell{1}, 5});
    planner.finish();
    EXPECT_EQ(seen, (std::vector<std::string>{"move", "fan", "move", "layer", "dwell"}));
}

TEST(Prusa, LimitsChangeForWhatFollows) {
    const std::vector<Command> program{{Move{{100, 0, 0, 0}, 500, Role::travel, {}}, 1},
                                       {SetLimits{.max_feedrate = {{50, {}, {}, {}}}}, 2},
                                       {Move{{0, 0, 0, 0}, 500, Role::travel, {}}, 3}};
    const std::vector<Block> blocks = blocks_of(program, {});
    ASSERT_EQ(blocks.size(), 2U);
    EXPECT_DOUBLE_EQ(blocks[0].v_nominal, 200);
    EXPECT_DOUBLE_EQ(blocks[1].v_nominal, 50);
}

}  // namespace
}  // namespace bead
