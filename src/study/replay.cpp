#include "study/replay.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numeric>

#include "core/expects.h"
#include "core/parallel.h"

namespace bead {
namespace {

std::vector<double> ranks(std::span<const double> values) {
    std::vector<std::size_t> order(values.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::sort(order, {}, [&](std::size_t i) { return values[i]; });
    std::vector<double> rank(values.size());
    for (std::size_t first = 0; first < order.size();) {
        std::size_t end = first + 1;
        while (end < order.size() && values[order[end]] == values[order[first]]) ++end;
        for (std::size_t i = first; i < end; ++i)
            rank[order[i]] = static_cast<double>(first + end - 1) / 2;
        first = end;
    }
    return rank;
}

double correlation(const std::vector<double>& a, const std::vector<double>& b) {
    const auto mean = [](const std::vector<double>& v) {
        return std::accumulate(v.begin(), v.end(), 0.0) / static_cast<double>(v.size());
    };
    const double mean_a = mean(a), mean_b = mean(b);
    double aa = 0, bb = 0, ab = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        aa += (a[i] - mean_a) * (a[i] - mean_a);
        bb += (b[i] - mean_b) * (b[i] - mean_b);
        ab += (a[i] - mean_a) * (b[i] - mean_b);
    }
    return aa > 0 && bb > 0 ? ab / std::sqrt(aa * bb) : 0;
}

struct Sides {
    std::vector<double> published, ours;
};

Sides sides_of(std::span<const ReplayedRun> runs, const RunFilter& wanted) {
    Sides sides;
    for (const ReplayedRun& run : runs) {
        if (!wanted(run.published)) continue;
        sides.published.push_back(run.published.energy);
        sides.ours.push_back(run.ours.energy);
    }
    return sides;
}

}  // namespace

bool usable(const ExperimentRun& run) {
    const bool copied_rectangle =
        run.shape == Shape::rectangle && run.infill_angle != 0 && run.part_angle != 0;
    const bool is_spiral = patterns.at(run.pattern).name == "archimedean";
    return !copied_rectangle && !(run.shape == Shape::drop && is_spiral);
}

RunCost run_cost(const Print& print) {
    const Assessment cost = judged(print, experiment_machine(), Judging::motion);
    return {published_energy(cost.features), standing_form(cost.features), cost.motion.duration,
            cost.features};
}

std::vector<ReplayedRun> replayed(std::span<const PublishedRun> runs, int threads,
                                  const Progress& progress) {
    std::vector<ReplayedRun> result(runs.size());
    std::atomic<int> done = 0;
    parallel_for(runs.size(), threads, [&](std::size_t i) {
        const ExperimentRun& run = runs[i].run;
        result[i] = {runs[i], run_cost(experiment_print(outline_of(run.shape), setup_of(run)))};
        tell(progress, ++done / static_cast<double>(runs.size()), "replaying");
    });
    return result;
}

Agreement agreement(std::span<const ReplayedRun> runs, const RunFilter& wanted) {
    const Sides all = sides_of(runs, wanted);
    Agreement result;
    result.rows = static_cast<int>(all.ours.size());
    for (std::size_t i = 0; i < all.ours.size(); ++i) {
        const double off = std::abs(all.ours[i] / all.published[i] - 1);
        result.mape += off / result.rows;
        result.worst = std::max(result.worst, off);
    }
    result.spearman = spearman(all.published, all.ours);
    for (std::size_t shape = 0; shape < shape_names.size(); ++shape) {
        const Sides some = sides_of(runs, [&](const PublishedRun& run) {
            return wanted(run) && run.run.shape == static_cast<Shape>(shape);
        });
        result.by_shape[shape] = spearman(some.published, some.ours);
    }
    return result;
}

double spearman(std::span<const double> a, std::span<const double> b) {
    BEAD_EXPECTS(a.size() == b.size());
    return a.empty() ? 0 : correlation(ranks(a), ranks(b));
}

}  // namespace bead
