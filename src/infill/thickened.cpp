#include "infill/thickened.h"

#include <cmath>

#include "geom/clip.h"
#include "geom/resample.h"

namespace bead {
namespace {

constexpr double asked_every = 0.25;  // mm along a line, for the load there

struct Run {
    std::size_t first = 0, last = 0;
};

// Stretches of points above the level, gaps closed, short ones dropped.
std::vector<Run> runs_above(const std::vector<double>& load, double level, std::size_t shortest) {
    std::vector<Run> runs;
    for (std::size_t i = 0; i < load.size(); ++i) {
        if (load[i] <= level) continue;
        if (!runs.empty() && i - runs.back().last < shortest)
            runs.back().last = i;
        else
            runs.push_back({i, i});
    }
    std::erase_if(runs, [&](const Run& run) { return run.last - run.first < shortest; });
    return runs;
}

}  // namespace

std::vector<Polyline> thickening(const Polyline& line, const std::function<double(Vec2)>& load,
                                 const ThickenOptions& options) {
    const Polyline even = resampled(line, asked_every);
    std::vector<double> carried;
    carried.reserve(even.size());
    for (const Vec2 p : even) carried.push_back(load(p));
    const auto shortest = static_cast<std::size_t>(std::lround(options.shortest / asked_every));
    std::vector<Polyline> copies;
    for (int k = 1; k <= options.copies; ++k)
        for (const Run& run : runs_above(carried, k * options.threshold, shortest)) {
            const Polyline part(even.begin() + static_cast<long>(run.first),
                                even.begin() + static_cast<long>(run.last) + 1);
            for (const double side : {1.0, -1.0})
                for (Polyline& piece :
                     inside_parts({shifted_aside(part, side * k * options.apart)}, options.inside))
                    if (length(piece) >= options.shortest) copies.push_back(std::move(piece));
        }
    return copies;
}

}  // namespace bead
