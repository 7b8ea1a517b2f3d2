#include "smooth/dense.h"

#include <algorithm>

#include "geom/cubic_spline.h"
#include "geom/curve_recovery.h"

namespace bead {
namespace {

// The chords of m equal parts stray by about |second derivative| / 8 m².
int parts_of(const Cubic& c, double chord) {
    const Vec2 first = c[0] - 2.0 * c[1] + c[2], last = c[1] - 2.0 * c[2] + c[3];
    const double bend = 6 * std::max(length(first), length(last));
    return std::clamp(static_cast<int>(std::ceil(std::sqrt(bend / (8 * chord)))), 1, 64);
}

void append_run(DenseLine& line, const RecoveredRun& run, const Lane& lane, std::size_t& segment,
                double chord) {
    for (std::size_t i = 0; i + 1 < run.points.size(); ++i) {
        const Flow flow = lane.flows[segment++ % lane.flows.size()];
        int parts = 1;
        Cubic cubic{};
        if (run.curve) {
            cubic = cubic_of(*run.curve, run.points, i);
            parts = parts_of(cubic, chord);
        }
        for (int k = 1; k < parts; ++k) {
            line.points.push_back(point_at(cubic, static_cast<double>(k) / parts));
            line.flows.push_back(flow);
        }
        line.points.push_back(run.points[i + 1]);
        line.flows.push_back(flow);
    }
}

}  // namespace

DenseLine dense_line(const Lane& lane, const DenseOptions& options) {
    if (!options.curves || lane.points.size() < 3) return {lane.points, lane.flows, 0, 0};
    RecoveryOptions recovery;
    recovery.tolerance = options.tolerance;
    const std::vector<RecoveredRun> runs =
        lane.closed ? recovered_loop(lane.points, recovery) : recovered_runs(lane.points, recovery);
    const Vec2 first = runs.front().points.front();
    auto segment =
        static_cast<std::size_t>(std::ranges::find(lane.points, first) - lane.points.begin());
    DenseLine line;
    line.points.push_back(first);
    for (const RecoveredRun& run : runs) {
        append_run(line, run, lane, segment, options.chord);
        if (run.points.size() < 3) continue;
        ++(run.curve ? line.curves : line.rejected);
    }
    if (lane.closed) line.points.pop_back();
    return line;
}

}  // namespace bead
