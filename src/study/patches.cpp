#include "study/patches.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "geom/clip.h"
#include "geom/resample.h"
#include "study/brace_candidates.h"

namespace bead {
namespace {

constexpr std::size_t stretch = 4;                          // samples over which strain is measured
constexpr std::array<double, 5> lengths{4, 7, 12, 20, 34};  // mm, of second beads
constexpr double between = 1;                               // mm, starts of second beads
constexpr int most_copies = 2;                              // beads aside at which one may lie
constexpr double outward = 0.05;         // mm, where a second bead's room is looked at
constexpr double roomy = 0.7;            // share of solid below which there is room
constexpr double inside_share = 0.9;     // of its points that must be inside
constexpr double shortest_patch = 1.5;   // mm, of second beads cut off at the part's edge
constexpr int most_crossed = 3;          // that one bar may cross
constexpr double cool = 0.9;             // of the highest index, where a bead may end
constexpr std::size_t looked_at = 3000;  // candidates
constexpr double over_budget = 1.5;      // of the budget, by the last one

struct Patch {
    Polyline points;  // of a second bead: the stretch that it lies beside
    bool is_bar = false;
    double size = 0;   // mm
    double worth = 0;  // of the norm, per mm
};

class Patcher {
  public:
    Patcher(const Layout& layout, const TestRig& rig, std::span<const Tested> tested,
            std::span<const PixelVector> adjoint, const LoadCase& load_case,
            const PatchLineOptions& options)
        : layout_(layout),
          model_(rig.model()),
          tested_(tested),
          adjoint_(adjoint),
          case_(load_case),
          options_(options),
          inside_(offset(load_case.part, -load_case.print.bead_width / 2 + 1e-4)),
          width_(load_case.print.bead_width),
          aside_(solid_pitch * width_),
          highest_(0),
          bar_(load_case.material.young * load_case.thickness * width_) {
        for (const Tested& of : tested) highest_ = std::max(highest_, of.index[of.weakest]);
    }

    Layout found() const {
        Layout chosen;
        std::vector<Patch> taken;
        double used = 0;
        int skipped = 0;
        const std::size_t most = std::size_t(options_.most) + std::size_t(options_.skipped);
        for (const Patch& candidate : best_candidates()) {
            if (taken.size() >= most || used >= options_.area) break;
            const auto is_near = [&](const Patch& other) {
                return distance(middle(other), middle(candidate)) <
                       std::max(other.size, candidate.size) / 2;
            };
            if (std::ranges::any_of(taken, is_near)) continue;
            const std::optional<Polyline> line =
                candidate.is_bar ? candidate.points : second_bead(candidate.points);
            if (!line || !is_affordable(length(*line) * width_, used)) continue;
            taken.push_back(candidate);
            if (skipped++ < options_.skipped) continue;
            used += length(*line) * width_;
            chosen.push_back({LineKind::patch, *line});
        }
        return chosen;
    }

  private:
    bool is_affordable(double area, double used) const {
        return area <= options_.most_area &&
               (used == 0 || used + area <= over_budget * options_.area);
    }

    static Vec2 middle(const Patch& candidate) {
        return candidate.points[candidate.points.size() / 2];
    }

    std::vector<Patch> best_candidates() const {
        std::vector<Patch> found;
        for (const LayoutLine& line : layout_) append_second_beads(found, line.points);
        for (const CrossedLine& line : crossed_lines(model_, case_, options_.pitch))
            append_bars(found, line.crossings);
        std::ranges::stable_sort(found, std::greater{}, &Patch::worth);
        if (found.size() > looked_at) found.resize(looked_at);
        return found;
    }

    void append_second_beads(std::vector<Patch>& found, const Polyline& points) const {
        const Polyline line = resampled(points, line_step);
        if (line.size() <= stretch) return;
        const double step = length(line) / static_cast<double>(line.size() - 1);
        std::vector<double> sums{0};  // of the gain up to each sample
        for (std::size_t i = 0; i + 1 < line.size(); ++i) {
            const std::size_t from =
                std::min(i - std::min(i, stretch / 2), line.size() - 1 - stretch);
            const std::size_t to = from + stretch;
            const double size = distance(line[from], line[to]);
            sums.push_back(sums.back() + (size > 0 ? step / size * gain(line[from], line[to]) : 0));
        }
        const auto samples = [&](double l) {
            return static_cast<std::size_t>(std::lround(l / step));
        };
        for (const double size : lengths) {
            if (size > options_.longest) break;
            const std::size_t count = samples(size),
                              hop = std::max<std::size_t>(1, samples(between));
            for (std::size_t from = 0; from + count < line.size(); from += hop)
                if (is_cool(line[from]) && is_cool(line[from + count]))
                    append(found, {{line.begin() + static_cast<long>(from),
                                    line.begin() + static_cast<long>(from + count + 1)},
                                   false,
                                   size,
                                   sums[from + count] - sums[from]});
        }
    }

    void append_bars(std::vector<Patch>& found, const std::vector<BeadCrossing>& at) const {
        for (std::size_t a = 0; a + 1 < at.size(); ++a) {
            double sum = 0;
            for (std::size_t b = a + 1; b < at.size() && b <= a + most_crossed; ++b) {
                sum += soft_joints * gain(at[b - 1].at, at[b].at);
                const double size = distance(at[a].at, at[b].at);
                if (size >= options_.shortest_bar && size <= options_.longest &&
                    is_cool(at[a].at) && is_cool(at[b].at))
                    append(found, {{at[a].at, at[b].at}, true, size, sum});
            }
        }
    }

    // No place for a bead to end: stress is high, and an end raises it.
    bool is_cool(Vec2 p) const {
        const std::optional<std::size_t> pixel = pixel_at(model_.grid, p);
        if (!pixel) return true;
        double index = 0;
        for (const Tested& of : tested_) index = std::max(index, of.index[*pixel]);
        return index < cool * highest_;
    }

    static void append(std::vector<Patch>& found, Patch candidate) {
        candidate.worth /= candidate.size + end_cost;
        if (candidate.worth > 0) found.push_back(std::move(candidate));
    }

    // By a bar from a to b.
    double gain(Vec2 a, Vec2 b) const {
        const double size = distance(a, b);
        const std::optional<std::size_t> pa = pixel_at(model_.grid, a),
                                         pb = pixel_at(model_.grid, b);
        if (!(size > 0) || !pa || !pb) return 0;
        const Vec2 t = (b - a) / size;
        double sum = 0;
        for (std::size_t v = 0; v < tested_.size(); ++v)
            sum += stretched(tested_[v].displacement, *pa, *pb, t) *
                   stretched(adjoint_[v], *pa, *pb, t);
        return bar_ / size * sum;
    }

    double stretched(const PixelVector& u, std::size_t from, std::size_t to, Vec2 t) const {
        return dot(displacement_at(model_.grid, to, u) - displacement_at(model_.grid, from, u), t);
    }

    // Of the line, moved aside step by step until there is room, to the emptier side first.
    std::optional<Polyline> second_bead(const Polyline& line) const {
        for (int number = 1; number <= most_copies; ++number) {
            const double left = fullness(line, number, 1), right = fullness(line, number, -1);
            if (std::min(left, right) < roomy)
                return clipped(shifted_aside(line, (left <= right ? 1 : -1) * number * aside_));
        }
        return std::nullopt;
    }

    // How much of a copy's outer side is solid already; 1 if the copy is not inside.
    double fullness(const Polyline& line, int number, double side) const {
        const double off = side * number * aside_;
        const Polyline copy = shifted_aside(line, off);
        if (share(copy, [&](Vec2 p) { return contains(inside_, p); }) < inside_share) return 1;
        return share(shifted_aside(line, off + side * outward), [&](Vec2 p) {
            const std::optional<std::size_t> pixel = pixel_at(model_.grid, p);
            return pixel && model_.factor[*pixel] > 0;
        });
    }

    template <class Test>
    static double share(const Polyline& line, const Test& test) {
        return static_cast<double>(std::ranges::count_if(line, test)) /
               static_cast<double>(line.size());
    }

    std::optional<Polyline> clipped(const Polyline& copy) const {
        Polyline longest;
        for (Polyline& part : inside_parts({copy}, inside_))
            if (length(part) > length(longest)) longest = std::move(part);
        if (length(longest) < shortest_patch) return std::nullopt;
        return smoothed(resampled(longest, line_step), 2);
    }

    const Layout& layout_;
    const PixelModel& model_;
    std::span<const Tested> tested_;
    std::span<const PixelVector> adjoint_;
    const LoadCase& case_;
    const PatchLineOptions& options_;
    Region inside_;
    double width_;
    double aside_;  // mm between copies
    double highest_;
    double bar_;  // N, stiffness times length
};

}  // namespace

Layout patches(const Layout& layout, const TestRig& rig, std::span<const Tested> tested,
               std::span<const PixelVector> adjoint, const LoadCase& load_case,
               const PatchLineOptions& options) {
    return Patcher(layout, rig, tested, adjoint, load_case, options).found();
}

}  // namespace bead
