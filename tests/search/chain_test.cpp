#include "search/chain.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

namespace bead {
namespace {

// Twin: tries every sequence.
double brute_force(const std::vector<std::vector<double>>& costs, const MayFollow& may_follow,
                   std::size_t step, std::size_t from) {
    if (step == costs.size()) return 0;
    double best = std::numeric_limits<double>::infinity();
    for (std::size_t to = 0; to < costs[step].size(); ++to)
        if (step == 0 || may_follow(step, from, to))
            best = std::min(best, costs[step][to] + brute_force(costs, may_follow, step + 1, to));
    return best;
}

TEST(Chain, IsAsCheapAsTheBestOfAllSequences) {
    for (unsigned seed = 1; seed <= 200; ++seed) {
        std::mt19937 random(seed);
        std::uniform_real_distribution<double> cost(0, 10);
        std::vector<std::vector<double>> costs(1 + random() % 5);
        for (auto& step : costs)
            for (std::size_t i = 0; i < 4; ++i) step.push_back(cost(random));
        const auto odd_sum = [](std::size_t, std::size_t from, std::size_t to) {
            return (from + to) % 2 == 1;
        };
        const std::optional<Chain> chain = cheapest_chain(costs, odd_sum);
        ASSERT_TRUE(chain);
        EXPECT_NEAR(chain->cost, brute_force(costs, odd_sum, 0, 0), 1e-12) << "seed " << seed;
        double sum = 0;
        for (std::size_t i = 0; i < costs.size(); ++i) sum += costs[i][chain->choices[i]];
        EXPECT_NEAR(sum, chain->cost, 1e-12);
        for (std::size_t i = 1; i < costs.size(); ++i)
            EXPECT_TRUE(odd_sum(i, chain->choices[i - 1], chain->choices[i]));
    }
}

TEST(Chain, SaysWhenNothingIsAllowed) {
    const auto never = [](std::size_t, std::size_t, std::size_t) { return false; };
    EXPECT_FALSE(cheapest_chain({{1, 2}, {3, 4}}, never));
    EXPECT_TRUE(cheapest_chain({{1, 2}}, never));
    EXPECT_TRUE(cheapest_chain({}, never));
}

}  // namespace
}  // namespace bead
