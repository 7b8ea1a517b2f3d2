#include "study/candidates.h"

#include <limits>

#include "core/parallel.h"

namespace bead {

std::vector<double> steps_up_to(double end, double step) {
    std::vector<double> values;
    const auto count = std::max(1, static_cast<int>(std::lround(end / step)));
    values.reserve(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) values.push_back(end * i / count);
    return values;
}

std::vector<FillChoice> all_choices(std::span<const NamedPattern> allowed, double angle_step) {
    std::vector<FillChoice> choices;
    for (const NamedPattern& pattern : allowed)
        for (const double angle : steps_up_to(pi, angle_step)) choices.push_back({pattern, angle});
    return choices;
}

double crossing(double a, double b) {
    const double turn = std::fmod(std::abs(a - b), pi);
    return std::min(turn, pi - turn);
}

CostTable class_costs(std::span<const LayerParts> parts, std::span<const LayerClass> classes,
                      std::span<const FillChoice> choices, const Jury& jury, int threads,
                      Effort& effort) {
    constexpr double never = std::numeric_limits<double>::infinity();
    CostTable costs(classes.size(), std::vector<double>(choices.size(), never));
    std::vector<std::pair<std::size_t, std::size_t>> jobs;
    for (std::size_t c = 0; c < classes.size(); ++c)
        for (std::size_t i = 0; i < choices.size(); ++i)
            if (is_distinct(parts[classes[c].example], choices[i], choices.front().pattern))
                jobs.emplace_back(c, i);
    parallel_for(jobs.size(), threads, [&](std::size_t job) {
        const auto [c, i] = jobs[job];
        costs[c][i] = layer_cost(parts[classes[c].example], choices[i], jury);
    });
    effort.candidates += static_cast<long>(choices.size());
    effort.evaluated += static_cast<long>(jobs.size());
    return costs;
}

}  // namespace bead
