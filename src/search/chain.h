// The cheapest sequence of choices, one per step, where only some choices may follow each other:
// dynamic programming over steps (R. Bellman 1957; for sequences, A. Viterbi 1967). Exact, O(steps
// · choices²).
//
//     const std::optional<Chain> best = cheapest_chain(costs, [&](auto step, auto from, auto to) {
//     … });
#pragma once
#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

namespace bead {

struct Chain {
    std::vector<std::size_t> choices;  // one per step
    double cost = 0;                   // their sum
};

// costs[step][choice]; may_follow(step, from, to): whether `to` at this step may follow `from` at
// the step before. Of equal chains the one with the lower choice numbers at the last differing
// step. None when no chain is allowed.
using MayFollow = std::function<bool(std::size_t step, std::size_t from, std::size_t to)>;
std::optional<Chain> cheapest_chain(const std::vector<std::vector<double>>& costs,
                                    const MayFollow& may_follow);

}  // namespace bead
