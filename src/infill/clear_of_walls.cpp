#include "infill/clear_of_walls.h"

#include <algorithm>
#include <cmath>

#include "geom/line_index.h"
#include "geom/resample.h"

namespace bead {
namespace {

constexpr double sample_step = 0.2;  // mm

struct NearRun {
    std::size_t first = 0, last = 0;  // samples
};

class Walls {
  public:
    Walls(std::span<const Polyline> walls, const ClearOptions& options)
        : walls_(walls, 1.0), options_(options) {}

    // Distances of even points from the walls; none farther than counts.
    [[nodiscard]] std::vector<double> distances(const Polyline& even) const {
        std::vector<double> far;
        far.reserve(even.size());
        for (const Vec2 p : even) {
            const auto near = walls_.nearest(p, options_.near);
            far.push_back(near ? near->distance : 2 * options_.near);
        }
        return far;
    }

    // Stretches that run along a wall for longer than a joint does.
    [[nodiscard]] std::vector<NearRun> runs(const std::vector<double>& far) const {
        const auto longest = static_cast<std::size_t>(std::lround(options_.longest / sample_step));
        std::vector<NearRun> runs;
        for (std::size_t i = 0; i < far.size(); ++i) {
            if (far[i] >= options_.near) continue;
            std::size_t last = i;
            while (last + 1 < far.size() && far[last + 1] < options_.near) ++last;
            if (last - i > longest) runs.push_back({i, last});
            i = last;
        }
        return runs;
    }

    // The run without the joints at its ends that lead on to the rest of the line.
    [[nodiscard]] NearRun between_joints(NearRun run, const std::vector<double>& far) const {
        const auto meets = [&](std::size_t i) { return far[i] <= options_.contact; };
        if (run.first > 0) {
            std::size_t i = run.first;
            while (i < run.last && !meets(i)) ++i;
            if (i < run.last) run.first = i;
        }
        if (run.last + 1 < far.size()) {
            std::size_t i = run.last;
            while (i > run.first && !meets(i)) --i;
            if (i > run.first) run.last = i;
        }
        return run;
    }

  private:
    LineIndex walls_;
    ClearOptions options_;
};

void append_piece(std::vector<FamilyLine>& pieces, int family, const Polyline& even,
                  std::size_t first, std::size_t last) {
    if (last <= first) return;
    pieces.push_back(
        {family,
         {even.begin() + static_cast<long>(first), even.begin() + static_cast<long>(last) + 1}});
}

}  // namespace

std::vector<FamilyLine> clear_of_walls(const std::vector<FamilyLine>& lines,
                                       std::span<const Polyline> walls,
                                       const ClearOptions& options) {
    if (walls.empty()) return lines;
    const Walls near(walls, options);
    std::vector<FamilyLine> pieces;
    for (const FamilyLine& line : lines) {
        const Polyline even = resampled(line.points, sample_step);
        const std::vector<double> far = near.distances(even);
        const std::vector<NearRun> runs = near.runs(far);
        if (runs.empty()) {
            pieces.push_back(line);
            continue;
        }
        std::size_t begin = 0;
        for (const NearRun& run : runs) {
            const NearRun left_out = near.between_joints(run, far);
            append_piece(pieces, line.family, even, begin, left_out.first);
            begin = left_out.last;
        }
        if (runs.back().last + 1 < even.size())
            append_piece(pieces, line.family, even, begin, even.size() - 1);
    }
    return pieces;
}

double length_along_walls(const std::vector<FamilyLine>& lines, std::span<const Polyline> walls,
                          const ClearOptions& options) {
    if (walls.empty()) return 0;
    const Walls near(walls, options);
    double sum = 0;
    for (const FamilyLine& line : lines)
        for (const NearRun& run : near.runs(near.distances(resampled(line.points, sample_step))))
            sum += static_cast<double>(run.last - run.first) * sample_step;
    return sum;
}

}  // namespace bead
