#include "outline_curves.h"

#include "geom/curve_recovery.h"

namespace bead::cli {
namespace {

constexpr double fine = 0.0005;  // mm
constexpr double same_place = 1e-6;

Polyline without_doubles(const Polyline& loop) {
    Polyline clean;
    for (const Vec2 point : loop)
        if (clean.empty() || distance(clean.back(), point) > same_place) clean.push_back(point);
    while (clean.size() > 1 && distance(clean.front(), clean.back()) <= same_place)
        clean.pop_back();
    return clean;
}

}  // namespace

std::vector<Polyline> outline_curves(const std::vector<Polyline>& loops) {
    std::vector<Polyline> curves;
    for (const Polyline& loop : loops) {
        const Polyline clean = without_doubles(loop);
        if (clean.size() < 3) continue;
        for (const RecoveredRun& run : recovered_loop(clean, {}))
            curves.push_back(run.curve ? flattened(*run.curve, fine) : run.points);
    }
    return curves;
}

}  // namespace bead::cli
