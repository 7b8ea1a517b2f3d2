#include "study/choose_rotation.h"

#include <algorithm>
#include <limits>

namespace bead {
namespace {

constexpr std::size_t sampled_classes = 10;
constexpr double sample_angle_step = pi / 4;

// At most so many classes, from the most common to the rarest.
std::vector<LayerClass> sample(std::vector<LayerClass> classes) {
    std::ranges::stable_sort(classes, std::greater{},
                             [](const LayerClass& c) { return c.members.size(); });
    if (classes.size() <= sampled_classes) return classes;
    std::vector<LayerClass> spread;
    for (std::size_t i = 0; i < sampled_classes; ++i)
        spread.push_back(classes[i * classes.size() / sampled_classes]);
    return spread;
}

// The cheapest way for one class, the mean of two crossing choices where lines have a direction.
double least_cost(const LayerParts& layer, std::span<const double> costs,
                  std::span<const FillChoice> choices) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < choices.size(); ++i)
        for (std::size_t k = 0; k < choices.size(); ++k) {
            const bool alternate = has_direction(layer, choices[i].pattern);
            const bool crosses = choices[k].pattern.name == choices[i].pattern.name &&
                                 crossing(choices[k].angle, choices[i].angle) > pi / 2 - 1e-6;
            if (alternate ? crosses : i == k) least = std::min(least, (costs[i] + costs[k]) / 2);
        }
    return least;
}

}  // namespace

std::vector<double> promising_rotations(std::span<const LayerParts> parts, const Jury& jury,
                                        const OptimizeOptions& options, std::size_t count,
                                        Effort& effort) {
    const std::vector<LayerClass> classes = sample(alike_layers(parts));
    const std::vector<FillChoice> choices = all_choices(options.patterns, sample_angle_step);
    std::vector<std::pair<double, double>> ranking;  // cost, rotation
    const auto attempt = [&](double rotation) {
        const std::vector<LayerParts> placed = on_bed(parts, rotation, jury.machine.printer);
        if (!fits_bed(placed, jury.machine.printer)) return;
        const CostTable costs =
            class_costs(placed, classes, choices, jury, options.threads, effort);
        double sum = 0;
        for (std::size_t c = 0; c < classes.size(); ++c)
            sum += least_cost(placed[classes[c].example], costs[c], choices) *
                   static_cast<double>(classes[c].members.size());
        ranking.emplace_back(sum, rotation);
    };
    const std::vector<double> grid = steps_up_to(pi, options.rotation_step);
    for (std::size_t i = 0; i < grid.size(); ++i) {
        tell(options.progress, 0.5 * static_cast<double>(i) / static_cast<double>(grid.size()),
             "turning the part");
        attempt(grid[i]);
    }
    std::ranges::sort(ranking);
    if (!ranking.empty()) {
        const double best = ranking.front().second;
        for (const double side : {-0.5, 0.5}) attempt(best + side * options.rotation_step);
    }
    std::ranges::sort(ranking);
    std::vector<double> promising;
    for (std::size_t i = 0; i < std::min(count, ranking.size()); ++i)
        promising.push_back(ranking[i].second);
    return promising;
}

}  // namespace bead
