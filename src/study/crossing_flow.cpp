#include "study/crossing_flow.h"

#include <algorithm>

#include "geom/crossings.h"
#include "geom/resample.h"

namespace bead {
namespace {

constexpr double shortest_change = 0.1;  // mm; what lies between two crossings and is shorter goes

struct Thin {
    double from = 0, to = 0;
};

std::vector<Thin> thin_stretches(const std::vector<double>& places, double reach, double all) {
    std::vector<Thin> thin;
    for (const double place : places) {
        double from = place - reach, to = place + reach;
        if (from < shortest_change) from = 0;
        if (to > all - shortest_change) to = all;
        if (!thin.empty() && from < thin.back().to + shortest_change)
            thin.back().to = to;
        else
            thin.push_back({from, to});
    }
    return thin;
}

}  // namespace

std::vector<FlowPart> flow_parts(const Polyline& line, const std::vector<double>& places,
                                 double reach, double flow) {
    const double all = length(line);
    std::vector<FlowPart> parts;
    double at = 0;
    const auto append = [&](double to, double share) {
        if (to <= at) return;
        parts.push_back({part_of(line, at, to), share});
        at = to;
    };
    for (const Thin& thin : thin_stretches(places, reach, all)) {
        append(thin.from, 1);
        append(thin.to, flow);
    }
    if (parts.empty()) return {{line, 1}};
    append(all, 1);
    for (std::size_t i = 1; i < parts.size(); ++i)
        parts[i].points.front() = parts[i - 1].points.back();
    return parts;
}

std::vector<std::vector<FlowPart>> flow_parts(const std::vector<Polyline>& lines, LineKind kind,
                                              const std::vector<Polyline>& tension,
                                              const PrintWish& print) {
    const bool is_thinned = kind == LineKind::compressive && print.crossing_flow < 1;
    const Crossings crossed(is_thinned ? std::span<const Polyline>(tension)
                                       : std::span<const Polyline>());
    std::vector<std::vector<FlowPart>> all;
    all.reserve(lines.size());
    for (const Polyline& line : lines)
        all.push_back(flow_parts(line, crossed.on(line), print.bead_width, print.crossing_flow));
    return all;
}

}  // namespace bead
