#include "study/case_study.h"

#include <algorithm>
#include <map>

#include "core/expects.h"
#include "core/parallel.h"
#include "energy/published.h"
#include "geom/clip.h"
#include "study/replay.h"

namespace bead {
namespace {

Polyline circle(Vec2 centre, double radius) {
    constexpr int corners = 96;
    Polyline loop;
    for (int i = 0; i < corners; ++i) loop.push_back(centre + radius * unit(2 * pi * i / corners));
    return loop;
}

Region disc(Vec2 centre, double radius) { return {{circle(centre, radius), {}}}; }

Region box(double half_width, double half_depth) {
    return {{{{-half_width, -half_depth},
              {half_width, -half_depth},
              {half_width, half_depth},
              {-half_width, half_depth}},
             {}}};
}

using Energies = std::map<std::pair<int, int>, std::map<std::size_t, double>>;  // (infill, part)

Energies by_angles(std::span<const BracketRun> runs) {
    Energies energies;
    for (const BracketRun& run : runs)
        energies[{run.run.infill_angle, run.run.part_angle}][run.run.pattern] = run.energy;
    return energies;
}

bool has(const Energies& energies, int infill, int part, std::size_t pattern) {
    const auto found = energies.find({infill, part});
    return found != energies.end() && found->second.contains(pattern);
}

constexpr std::array case_part_angles{0, 45, 90};

void count_pattern(BracketFindings& found, const Energies& energies, std::size_t pattern) {
    for (const int angle : case_part_angles)
        if (!has(energies, angle, 0, pattern) || !has(energies, 0, angle, pattern)) return;
    const auto of = [&](int infill, int part) { return energies.at({infill, part}).at(pattern); };
    const double straight = of(0, 0);
    ++found.patterns;
    found.diagonal_worse += of(45, 0) > std::max(straight, of(90, 0)) ? 1 : 0;
    found.ninety_better += of(90, 0) < straight ? 1 : 0;
    found.part_0_lowest += straight <= std::min(of(0, 45), of(0, 90)) ? 1 : 0;
}

void count_set_ups(BracketFindings& found, const Energies& energies) {
    for (const auto& set_up : energies) {
        const std::map<std::size_t, double>& patterns_there = set_up.second;
        if (patterns_there.size() < experiment_patterns) continue;
        ++found.set_ups;
        const bool lowest = std::ranges::all_of(patterns_there, [&](const auto& other) {
            return patterns_there.at(0) <= other.second;
        });
        found.rectilinear_lowest += lowest ? 1 : 0;
    }
}

}  // namespace

Region bracket_outline() {
    Region part = united(box(33, 15), united(disc({-31, 0}, 18), disc({31, 0}, 18)));
    part = united(part, intersection(box(22, 25), disc({0, 6}, 21)));
    for (const double side : {-1.0, 1.0}) part = difference(part, disc({31 * side, 0}, 8));
    part = difference(part, united(box(9, 4), united(disc({-9, 0}, 4), disc({9, 0}, 4))));
    return difference(part, disc({0, 18}, 4));
}

std::vector<double> bracket_energies(std::span<const ExperimentRun> runs, int threads) {
    const Region outline = bracket_outline();
    std::vector<double> energies(runs.size());
    parallel_for(runs.size(), threads, [&](std::size_t i) {
        energies[i] = run_cost(experiment_print(outline, setup_of(runs[i]))).energy;
    });
    return energies;
}

BracketFindings bracket_findings(std::span<const BracketRun> runs) {
    BracketFindings found;
    const Energies energies = by_angles(runs);
    for (std::size_t pattern = 0; pattern < experiment_patterns; ++pattern)
        count_pattern(found, energies, pattern);
    count_set_ups(found, energies);
    std::vector<BracketRun> straight;  // the part's angle is 0
    std::ranges::copy_if(runs, std::back_inserter(straight),
                         [](const BracketRun& run) { return run.run.part_angle == 0; });
    BEAD_EXPECTS(!straight.empty());
    const auto [best, worst] = std::ranges::minmax(straight, {}, &BracketRun::energy);
    found.best = best.run;
    found.worst = worst.run;
    found.below_worst = 1 - best.energy / worst.energy;
    if (has(energies, 45, 0, 0)) found.below_usual = 1 - best.energy / energies.at({45, 0}).at(0);
    return found;
}

}  // namespace bead
