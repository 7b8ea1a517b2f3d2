#include "search/chain.h"

#include <algorithm>
#include <limits>

namespace bead {
namespace {

constexpr double impossible = std::numeric_limits<double>::infinity();

struct Step {
    std::vector<double> cost;       // cheapest chain that ends in this choice
    std::vector<std::size_t> from;  // its choice at the step before
};

Step extended(const Step& before, const std::vector<double>& costs, std::size_t step,
              const MayFollow& may_follow) {
    Step after{std::vector<double>(costs.size(), impossible),
               std::vector<std::size_t>(costs.size())};
    for (std::size_t to = 0; to < costs.size(); ++to)
        for (std::size_t from = 0; from < before.cost.size(); ++from) {
            const double cost = before.cost[from] + costs[to];
            if (cost >= after.cost[to] || !may_follow(step, from, to)) continue;
            after.cost[to] = cost;
            after.from[to] = from;
        }
    return after;
}

}  // namespace

std::optional<Chain> cheapest_chain(const std::vector<std::vector<double>>& costs,
                                    const MayFollow& may_follow) {
    if (costs.empty()) return Chain{};
    std::vector<Step> steps{{costs[0], std::vector<std::size_t>(costs[0].size())}};
    for (std::size_t step = 1; step < costs.size(); ++step)
        steps.push_back(extended(steps.back(), costs[step], step, may_follow));

    const std::vector<double>& ends = steps.back().cost;
    const auto best = std::ranges::min_element(ends);
    if (best == ends.end() || *best == impossible) return std::nullopt;
    Chain chain{std::vector<std::size_t>(costs.size()), *best};
    auto choice = static_cast<std::size_t>(best - ends.begin());
    for (std::size_t step = costs.size(); step-- > 0; choice = steps[step].from[choice])
        chain.choices[step] = choice;
    return chain;
}

}  // namespace bead
