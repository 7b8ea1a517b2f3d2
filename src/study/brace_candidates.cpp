#include "study/brace_candidates.h"

#include "geom/clip.h"
#include "geom/resample.h"
#include "infill/fill.h"
#include "study/layout.h"

namespace bead {
namespace {

constexpr int directions = 12;

CrossedLine crossed(const PixelModel& model, const Polyline& line) {
    CrossedLine result;
    std::vector<BeadCrossing> run;
    const auto end_run = [&] {
        if (!run.empty()) result.crossings.push_back(run[run.size() / 2]);
        run.clear();
    };
    for (const Vec2 p : resampled(line, line_step)) {
        const std::optional<std::size_t> pixel = pixel_at(model.grid, p);
        if (pixel && model.factor[*pixel] > 0)
            run.push_back({p, *pixel});
        else
            end_run();
    }
    end_run();
    return result;
}

}  // namespace

Vec2 displacement_at(const PixelGrid& grid, std::size_t pixel, const PixelVector& displacement) {
    Vec2 mean;
    for (const std::size_t node : grid.corners(pixel))
        mean = mean + 0.25 * Vec2{displacement[2 * node], displacement[2 * node + 1]};
    return mean;
}

std::vector<CrossedLine> crossed_lines(const PixelModel& model, const LoadCase& load_case,
                                       double pitch) {
    const Region inside = offset(load_case.part, -load_case.print.bead_width / 2);
    std::vector<CrossedLine> lines;
    for (int i = 0; i < directions; ++i)
        for (const Polyline& line : rectilinear(inside, {.spacing = pitch,
                                                        .angle = pi * i / directions,
                                                        .link = 0,
                                                        .centre = bounds(inside).centre()}))
            if (length(line) > 2 * line_step) lines.push_back(crossed(model, line));
    return lines;
}

}  // namespace bead
