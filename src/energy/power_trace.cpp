#include "energy/power_trace.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "core/expects.h"

namespace bead {
namespace {

constexpr double longest_dip = 120;  // s
constexpr double gap_intervals = 3;

double ranked(std::vector<double> values, double share) {
    const auto place = values.begin() + std::ptrdiff_t(share * double(values.size() - 1));
    std::ranges::nth_element(values, place);
    return *place;
}

struct Stretch {
    std::size_t first = 0, last = 0;  // samples
};

std::vector<Stretch> stretches_above(const PowerTrace& trace, double threshold) {
    std::vector<Stretch> found;
    const double bridged = std::max(longest_dip, gap_intervals * trace.usual_interval);
    for (std::size_t i = 0; i < trace.samples.size(); ++i) {
        if (trace.samples[i].watts <= threshold) continue;
        if (!found.empty() &&
            (found.back().last + 1 == i ||
             trace.samples[i].time - trace.samples[found.back().last].time <= bridged))
            found.back().last = i;
        else
            found.push_back({i, i});
    }
    return found;
}

// Half-way to the neighbour beyond, which is below the threshold.
double edge(const PowerTrace& trace, std::size_t inside, std::size_t outside) {
    const double in = trace.samples[inside].time, out = trace.samples[outside].time;
    return is_gap(trace, std::abs(in - out)) ? in : (in + out) / 2;
}

FoundPrint print_at(const PowerTrace& trace, const Stretch& stretch) {
    FoundPrint print;
    print.cut_begin = stretch.first == 0;
    print.cut_end = stretch.last + 1 == trace.samples.size();
    print.from = print.cut_begin ? trace.samples.front().time
                                 : edge(trace, stretch.first, stretch.first - 1);
    print.to =
        print.cut_end ? trace.samples.back().time : edge(trace, stretch.last, stretch.last + 1);
    return print;
}

}  // namespace

PowerTrace power_trace(std::vector<PowerSample> samples) {
    BEAD_EXPECTS(samples.size() > 1);
    std::vector<double> intervals;
    for (std::size_t i = 1; i < samples.size(); ++i) {
        BEAD_EXPECTS(samples[i].time >= samples[i - 1].time);
        if (samples[i].time > samples[i - 1].time)
            intervals.push_back(samples[i].time - samples[i - 1].time);
    }
    BEAD_EXPECTS(!intervals.empty());
    return {std::move(samples), ranked(std::move(intervals), 0.5)};
}

bool is_gap(const PowerTrace& trace, double interval) {
    return interval > gap_intervals * trace.usual_interval;
}

Metered metered(const PowerTrace& trace, double from, double to) {
    Metered sum;
    const auto& samples = trace.samples;
    const auto gap = [&](double begin, double end) {
        begin = std::max(begin, from);
        end = std::min(end, to);
        if (begin < end) sum.gaps.push_back({begin, end});
    };
    gap(from, samples.front().time);
    for (std::size_t i = 1; i < samples.size(); ++i) {
        const PowerSample &a = samples[i - 1], &b = samples[i];
        const double begin = std::max(a.time, from), end = std::min(b.time, to);
        if (begin >= end) continue;
        if (is_gap(trace, b.time - a.time)) {
            gap(a.time, b.time);
            continue;
        }
        const double middle = ((begin + end) / 2 - a.time) / (b.time - a.time);
        sum.energy += std::lerp(a.watts, b.watts, middle) * (end - begin);
        sum.recorded += end - begin;
    }
    gap(samples.back().time, to);
    return sum;
}

FoundPrint find_print(const PowerTrace& trace, double expected) {
    BEAD_EXPECTS(expected > 0);
    std::vector<double> watts;
    for (const PowerSample& sample : trace.samples) watts.push_back(sample.watts);
    const double standby = ranked(watts, 0.05), most = std::ranges::max(watts);
    if (most - standby < std::max(2.0, 0.2 * standby))
        throw Error(
            fmt::format("the log stays between {:.1f} and {:.1f} W, so no print's start "
                        "stands out; log from before the print is started until after it",
                        standby, most));
    const double threshold = standby + (most - standby) / 7;
    const std::vector<Stretch> all = stretches_above(trace, threshold);
    FoundPrint best;
    double nearest = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
        FoundPrint print = print_at(trace, all[i]);
        const double length = std::max(print.to - print.from, 1e-3 * trace.usual_interval);
        const double off = std::abs(std::log(length / expected));
        if (i > 0 && off >= nearest) continue;
        nearest = off;
        print.scale = length / expected;
        best = print;
    }
    best.standby = standby;
    best.threshold = threshold;
    best.others = all.size() - 1;
    return best;
}

}  // namespace bead
