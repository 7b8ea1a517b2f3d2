#include "motion/prusa.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/planned.h"
#include "support/random_program.h"

namespace bead {
namespace {

using test::random_program;

std::vector<Block> prusa_blocks(const std::vector<Command>& program, const PlannerOptions& options,
                                const Limits& limits = {}) {
    return test::planned(limits, options, [&](const CommandSink& sink) {
        for (const Command& command : program) sink(command);
    });
}

const PlannerOptions faithful{Firmware::prusa, false, 16}, corrected_mode{Firmware::prusa, true, 0};

// Every axis' speed steps by no more than its jerk: between two blocks, or from and to a stop.
TEST(Prusa, CorrectedJunctionsKeepTheirJerk) {
    const Limits limits;
    for (const int lookahead : {0, 16})
        for (unsigned seed = 1; seed <= 40; ++seed) {
            const std::vector<Block> blocks =
                prusa_blocks(random_program(seed), {Firmware::prusa, true, lookahead});
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
    for (const Block& b : prusa_blocks(random_program(7), corrected_mode)) {
        const bool head = b.delta[axis_x] != 0 || b.delta[axis_y] != 0 || b.delta[axis_z] != 0;
        for (std::size_t i = 0; head && i < axis_count; ++i)
            ASSERT_LE(b.acceleration * std::abs(b.delta[i]) / b.length,
                      limits.max_acceleration[i] * (1 + 1e-9));
    }
}

TEST(Prusa, StreamingEqualsOneLongQueue) {
    for (const bool corrected : {false, true})
        for (const Firmware firmware :
             {Firmware::prusa, Firmware::prusa_2017, Firmware::marlin_jerk, Firmware::marlin_jd})
            for (unsigned seed = 1; seed <= 6; ++seed) {
                const auto program =
                    random_program(seed, {.moves = 1500, .longest = 2, .drains = false});
                const auto streamed = prusa_blocks(program, {firmware, corrected, 0});
                const auto whole = prusa_blocks(program, {firmware, corrected, 100'000});
                ASSERT_EQ(streamed.size(), whole.size());
                for (std::size_t k = 0; k < whole.size(); ++k) {
                    ASSERT_NEAR(streamed[k].v_entry, whole[k].v_entry, 1e-9) << "seed " << seed;
                    ASSERT_NEAR(streamed[k].v_exit, whole[k].v_exit, 1e-9) << "seed " << seed;
                }
            }
}

TEST(Prusa, ShortMovesJoinTheNextOne) {
    const std::vector<Command> program{{Move{{0.05, 0, 0, 0}, 50, Role::travel, {}}, 1},
                                       {Move{{10, 0, 0, 0}, 50, Role::travel, {}}, 2}};
    const std::vector<Block> blocks = prusa_blocks(program, faithful);
    ASSERT_EQ(blocks.size(), 1U);
    EXPECT_DOUBLE_EQ(blocks[0].length, 10);
}

// The third of three moves of 10 ms finds two in the queue: it takes 10 + 2·(20 - 10)/2 ms.
TEST(Prusa, SlowsShortMovesDownWhileTheQueueIsLow) {
    Limits limits;
    limits.slowdown = true;
    std::vector<Command> program;
    for (int i = 1; i <= 12; ++i)
        program.push_back({Move{{0.5 * i, 0, 0, 0}, 50, Role::travel, {}}, i});
    for (const Firmware firmware : {Firmware::prusa, Firmware::marlin_jerk}) {
        const std::vector<Block> blocks = prusa_blocks(program, {firmware, false, 16}, limits);
        EXPECT_NEAR(blocks[1].v_nominal, 50, 1e-5);
        EXPECT_NEAR(blocks[2].v_nominal, 25, 1e-5);
        EXPECT_GT(blocks[7].v_nominal, blocks[3].v_nominal);
        EXPECT_NEAR(blocks[8].v_nominal, 50, 1e-5);
    }
}

}  // namespace
}  // namespace bead
