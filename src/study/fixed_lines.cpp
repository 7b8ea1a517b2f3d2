#include "study/fixed_lines.h"

#include <algorithm>

#include "core/expects.h"
#include "fem/stretch.h"
#include "geom/along.h"
#include "geom/clip.h"
#include "geom/line_index.h"
#include "geom/resample.h"

namespace bead {
namespace {

constexpr double longer = 1;        // mm, by which a pad reaches beyond its stretch
constexpr double shortest_pad = 1;  // mm

double inset(double bead_width, int number) {
    return bead_width / 2 + number * (bead_width - bead_overlap);
}

std::vector<Polyline> loops_of(const Region& region) {
    std::vector<Polyline> loops;
    for (const Polygon& polygon : region) {
        loops.push_back(polygon.outer);
        loops.insert(loops.end(), polygon.holes.begin(), polygon.holes.end());
    }
    for (Polyline& loop : loops) loop.push_back(loop.front());
    return loops;
}

// The stretches of a closed line whose points lie within reach of a patch.
void append_near(Layout& pads, const Polyline& loop, const LineIndex& patches, double reach) {
    Polyline even = resampled(loop, line_step);
    even.pop_back();
    const std::size_t n = even.size();
    std::vector<char> near(n);
    for (std::size_t i = 0; i < n; ++i) near[i] = patches.nearest(even[i], reach) ? 1 : 0;
    const auto gap = std::find(near.begin(), near.end(), 0);
    if (gap == near.end()) {
        even.push_back(even.front());
        pads.push_back({LineKind::pad, std::move(even)});
        return;
    }
    const auto first = static_cast<std::size_t>(gap - near.begin());
    Polyline run;
    for (std::size_t k = 0; k <= n; ++k) {
        const std::size_t i = (first + k) % n;
        if (near[i] && k < n) {
            run.push_back(even[i]);
            continue;
        }
        if (run.size() > 1 && length(run) >= shortest_pad) pads.push_back({LineKind::pad, run});
        run.clear();
    }
}

}  // namespace

std::vector<Polyline> patches_of(const LoadCase& load_case) {
    std::vector<Polyline> lines;
    const auto append = [&](const Stretch& stretch) {
        const auto more = stretch_lines(load_case.part, stretch);
        BEAD_EXPECTS(more);
        lines.insert(lines.end(), more->begin(), more->end());
    };
    for (const Situation& situation : load_case.situations) {
        for (const Support& support : situation.supports) append(support.on);
        for (const Load& load : situation.loads) {
            append(load.on);
            if (load.move <= 0) continue;
            append(moved(load_case.part, load.on, load.move));
            append(moved(load_case.part, load.on, -load.move));
        }
    }
    return lines;
}

Layout wall_lines(const Region& part, double bead_width, int walls) {
    Layout lines;
    for (int wall = 0; wall < walls; ++wall)
        for (Polyline& loop : loops_of(offset(part, -inset(bead_width, wall))))
            lines.push_back({LineKind::wall, std::move(loop)});
    return lines;
}

Layout pad_lines(const LoadCase& load_case, int walls, int depth) {
    const double width = load_case.print.bead_width;
    const std::vector<Polyline> patch_lines = patches_of(load_case);
    const LineIndex patches(patch_lines, 2.0);
    Layout pads;
    for (int number = walls; number < depth; ++number) {
        const double in = inset(width, number);
        for (const Polyline& loop : loops_of(offset(load_case.part, -in)))
            append_near(pads, loop, patches, std::hypot(in, longer));
    }
    return pads;
}

}  // namespace bead
