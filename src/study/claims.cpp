#include "study/claims.h"

#include <algorithm>
#include <map>

#include "core/expects.h"

namespace bead {
namespace {

std::size_t place_of(int angle, std::span<const int> angles) {
    const auto found = std::ranges::find(angles, angle);
    BEAD_EXPECTS(found != angles.end());
    return static_cast<std::size_t>(found - angles.begin());
}

std::size_t index_of(const ExperimentRun& run) {
    std::size_t index = static_cast<std::size_t>(run.shape) * experiment_patterns + run.pattern;
    index = index * infill_angles.size() + place_of(run.infill_angle, infill_angles);
    return index * part_angles.size() + place_of(run.part_angle, part_angles);
}

// Energies of the runs that differ from this one in one thing, in its order; nothing if one is
// missing.
using Cell = std::optional<std::vector<double>>;

template <class Values, class Put>
Cell cell(const RunEnergies& energies, ExperimentRun run, const Values& values, const Put& put) {
    std::vector<double> found;
    for (const auto value : values) {
        put(run, value);
        const std::optional<double> energy = energies.of(run);
        if (!energy) return {};
        found.push_back(*energy);
    }
    return found;
}

Cell by_infill(const RunEnergies& energies, const ExperimentRun& run) {
    return cell(energies, run, infill_angles, [](auto& r, int a) { r.infill_angle = a; });
}
Cell by_part(const RunEnergies& energies, const ExperimentRun& run) {
    return cell(energies, run, part_angles, [](auto& r, int a) { r.part_angle = a; });
}
Cell by_pattern(const RunEnergies& energies, const ExperimentRun& run) {
    constexpr std::array<std::size_t, experiment_patterns> all{0, 1, 2, 3, 4};
    return cell(energies, run, all, [](auto& r, std::size_t p) { r.pattern = p; });
}

void count(Tally& tally, const Cell& energies, std::size_t lowest) {
    if (!energies) return;
    tally.of += 1;
    tally.holds += (*energies)[lowest] == std::ranges::min(*energies) ? 1 : 0;
}

void count_highest(Tally& tally, const Cell& energies, std::size_t highest) {
    if (!energies) return;
    tally.of += 1;
    tally.holds += (*energies)[highest] == std::ranges::max(*energies) ? 1 : 0;
}

// The squares by which the means of a factor's levels lie about the mean of all.
template <class Level>
double spread(const std::vector<ExperimentRun>& runs, const RunEnergies& energies,
              const Level& level_of) {
    struct Sum {
        double energy = 0, runs = 0;
    };
    std::map<std::size_t, Sum> levels;
    Sum all;
    for (const ExperimentRun& run : runs)
        for (Sum* sum : {&levels[level_of(run)], &all}) {
            sum->energy += energies.of(run).value_or(0);
            sum->runs += 1;
        }
    double squares = 0;
    for (const auto& [level, sum] : levels) {
        const double off = sum.energy / sum.runs - all.energy / all.runs;
        squares += sum.runs * off * off;
    }
    return squares;
}

void count_spreads(Tallies& result, const RunEnergies& energies, Shape shape) {
    std::vector<ExperimentRun> runs = experiment_runs();
    std::erase_if(runs, [&](const ExperimentRun& run) { return run.shape != shape; });
    if (!std::ranges::all_of(runs, [&](const auto& run) { return energies.of(run).has_value(); }))
        return;
    const double part = spread(runs, energies, [](const ExperimentRun& run) {
        return static_cast<std::size_t>(run.part_angle);
    });
    const double infill = spread(runs, energies, [](const ExperimentRun& run) {
        return static_cast<std::size_t>(run.infill_angle);
    });
    const double pattern =
        spread(runs, energies, [](const ExperimentRun& run) { return run.pattern; });
    result.infill_outweighs_part = result.infill_outweighs_part + Tally{infill > part ? 1 : 0, 1};
    result.pattern_outweighs_part =
        result.pattern_outweighs_part + Tally{pattern > part ? 1 : 0, 1};
}

}  // namespace

Tally operator+(const Tally& a, const Tally& b) { return {a.holds + b.holds, a.of + b.of}; }

void RunEnergies::add(const ExperimentRun& run, double energy) { by_run_[index_of(run)] = energy; }

std::optional<double> RunEnergies::of(const ExperimentRun& run) const {
    return by_run_[index_of(run)];
}

Tallies tallies(const RunEnergies& energies) {
    Tallies result;
    for (const ExperimentRun& run : experiment_runs()) {
        if (run.infill_angle == 0) {
            count_highest(result.diagonal_worst, by_infill(energies, run), 1);
            count(result.ninety_best, by_infill(energies, run), 2);
        }
        if (run.pattern == 0) count(result.rectilinear_lowest, by_pattern(energies, run), 0);
        if (run.part_angle == 0) count(result.part_0_lowest, by_part(energies, run), 0);
    }
    for (std::size_t shape = 0; shape < shape_names.size(); ++shape)
        count_spreads(result, energies, static_cast<Shape>(shape));
    return result;
}

double exchange_effect(const RunEnergies& energies) {
    double sum = 0;
    int count = 0;
    for (const Shape shape : {Shape::square, Shape::rectangle, Shape::oval})
        for (std::size_t pattern = 0; pattern < experiment_patterns; ++pattern) {
            const auto straight = energies.of({shape, pattern, 0, 0});
            const auto turned = energies.of({shape, pattern, 90, 90});
            if (!straight || !turned) continue;
            sum += *turned / *straight - 1;
            ++count;
        }
    return count > 0 ? sum / count : 0;
}

Tally coasting_pays(std::span<const ChargedFeatures> runs) {
    Tally tally;
    for (const ChargedFeatures& one : runs)
        for (const ChargedFeatures& other : runs) {
            const Features &a = one.features, &b = other.features;
            if (a.C <= b.C || a.A + a.B >= b.A + b.B) continue;
            tally.of += 1;
            tally.holds += one.energy < other.energy ? 1 : 0;
        }
    return tally;
}

}  // namespace bead
