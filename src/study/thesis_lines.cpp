#include "study/thesis_lines.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "geom/clip.h"
#include "infill/edge_seeds.h"
#include "infill/spaced_lines.h"
#include "infill/thickened.h"
#include "study/fixed_lines.h"
#include "study/stress_field.h"

namespace bead {
namespace {

constexpr double single_share = 0.5;            // of the lines' area that is not copies
constexpr double closest = 0.5, farthest = 40;  // mm between seeds
constexpr double widest = 12;                   // mm between lines placed by stress
constexpr double just_inside = 0.01;            // mm, of seeds from the edge that lines end on
constexpr double shortest_traced = 3;           // mm
constexpr double across = 0.7071;               // cosine of the angle to an edge's normal
constexpr int halvings = 30;
constexpr int rounds = 8;
constexpr double near_enough = 0.002;  // of the area

constexpr std::array families{PrincipalFamily::first, PrincipalFamily::second};
constexpr std::array kinds{LineKind::tensile, LineKind::compressive};

double carried(PlaneTensor t, std::size_t family) {
    const Principal p = principal(t);
    return std::max(0.0, family == 0 ? p.first : -p.second);
}

// The x at which a falling function comes nearest to `wanted`, looked for by halving on a
// logarithmic scale.
double argument_of(const std::function<double(double)>& falling, double wanted, double low,
                   double high) {
    double best = low, least = std::abs(falling(low) - wanted);
    for (int i = 0; i < halvings && least > near_enough * wanted; ++i) {
        const double middle = std::sqrt(low * high), value = falling(middle);
        if (std::abs(value - wanted) < least) {
            least = std::abs(value - wanted);
            best = middle;
        }
        (value > wanted ? low : high) = middle;
    }
    return best;
}

class ThesisLayer {
  public:
    ThesisLayer(const LoadCase& load_case, const ThesisOptions& options)
        : case_(load_case),
          options_(options),
          stress_(solid_stress(load_case, 0, options.cell)),
          inside_(offset(load_case.part, -load_case.print.bead_width / 2)) {
        double sum = 0;
        for (const PlaneTensor& t : stress_.values) {
            const Principal p = principal(t);
            trace_.scale = std::max(trace_.scale, (p.first - p.second) / 2);
            sum += (std::abs(p.first) + std::abs(p.second)) / 2;
        }
        mean_ = sum / static_cast<double>(stress_.values.size());
        trace_.step = options.step;
    }

    [[nodiscard]] std::vector<Polyline> family(std::size_t f, double apart) const {
        return options_.seeds == ThesisSeeds::edges ? from_edges(f, apart) : spaced(f, apart);
    }
    [[nodiscard]] double family_area(std::size_t f, double apart) const {
        double sum = 0;
        for (const Polyline& line : family(f, apart)) sum += length(line);
        return sum * width();
    }

    [[nodiscard]] Layout copies(const Layout& lines, double threshold) const {
        Layout more;
        ThickenOptions how{threshold, options_.copies, width() - bead_overlap, 2, inside_};
        for (const LayoutLine& line : lines) {
            const std::size_t f = line.kind == LineKind::tensile ? 0 : 1;
            const auto load = [&](Vec2 p) { return carried(stress_(p), f); };
            for (Polyline& copy : thickening(line.points, load, how))
                more.push_back({line.kind, std::move(copy)});
        }
        return more;
    }

    [[nodiscard]] double highest() const { return 2 * trace_.scale; }
    [[nodiscard]] double width() const { return case_.print.bead_width; }

  private:
    [[nodiscard]] std::vector<Polyline> from_edges(std::size_t f, double apart) const {
        const PrincipalTracer tracer(stress_, inside_, trace_);
        std::vector<Polyline> lines;
        for (const EdgeSeed& seed : edge_seeds(offset(inside_, -just_inside), apart)) {
            const Vec2 way = direction(stress_(seed.place), families[f]);
            if (std::abs(cross(way, seed.along)) < across) continue;
            const std::optional<TracedLine> line = tracer.line(seed.place, families[f]);
            if (line && length(line->points) >= shortest_traced) lines.push_back(line->points);
        }
        return lines;
    }

    [[nodiscard]] std::vector<Polyline> spaced(std::size_t f, double apart) const {
        SpacedOptions how;
        how.spacing = [this, f, apart](Vec2 p) {
            if (options_.seeds == ThesisSeeds::even) return apart;
            const Principal s = principal(stress_(p));
            const double here = std::abs(f == 0 ? s.first : s.second);
            return std::clamp(apart * mean_ / std::max(here, 1e-9 * mean_), width() - bead_overlap,
                              widest);
        };
        how.largest = std::max(widest, apart);
        how.trace = trace_;
        return spaced_lines(stress_, inside_, families[f], most_stressed(f), how);
    }

    // Nodes 2 mm apart, the highest stress first.
    [[nodiscard]] std::vector<Vec2> most_stressed(std::size_t f) const {
        const int stride = std::max(1, static_cast<int>(std::lround(2 / stress_.step)));
        std::vector<std::pair<double, Vec2>> places;
        for (int j = 0; j < stress_.rows; j += stride)
            for (int i = 0; i < stress_.columns; i += stride) {
                const Principal s = principal(stress_.node(i, j));
                places.emplace_back(std::abs(f == 0 ? s.first : s.second),
                                    stress_.origin + stress_.step * Vec2{double(i), double(j)});
            }
        std::ranges::stable_sort(places, std::greater{}, &std::pair<double, Vec2>::first);
        std::vector<Vec2> seeds;
        seeds.reserve(places.size());
        for (const auto& [value, place] : places) seeds.push_back(place);
        return seeds;
    }

    const LoadCase& case_;
    ThesisOptions options_;
    Sampled<PlaneTensor> stress_;
    Region inside_;
    TraceOptions trace_;
    double mean_ = 0;  // MPa
};

double common_distance(const ThesisLayer& layer, double wanted) {
    return argument_of(
        [&](double apart) { return layer.family_area(0, apart) + layer.family_area(1, apart); },
        wanted, closest, farthest);
}

// Lines come and go in pairs, so one distance for both families rarely meets the volume. Of pairs
// of distances about it those that meet it best, and among these the two most alike.
std::array<double, 2> distances(const ThesisLayer& layer, double wanted, double middle) {
    constexpr int most = 12;
    constexpr double ratio = 1.02;
    std::array<std::vector<std::pair<double, double>>, 2> tried;  // distance, area
    for (int i = -most; i <= most; ++i)
        for (std::size_t f = 0; f < 2; ++f) {
            const double apart = middle * std::pow(ratio, i);
            tried[f].emplace_back(apart, layer.family_area(f, apart));
        }
    std::array<double, 2> best{middle, middle};
    double least = std::numeric_limits<double>::infinity();
    for (const auto& [first, first_area] : tried[0])
        for (const auto& [second, second_area] : tried[1]) {
            const double off = std::abs(first_area + second_area - wanted) / wanted;
            const double cost =
                std::max(off, near_enough) + 1e-3 * std::abs(std::log(first / second));
            if (cost >= least) continue;
            least = cost;
            best = {first, second};
        }
    return best;
}

// Lines and copies that weigh about `wanted` (mm²), crossings counted twice.
void lay(const ThesisLayer& layer, const ThesisOptions& options, double wanted,
         ThesisLines& result) {
    const double width = layer.width();
    const double single = (options.copies > 0 ? single_share : 1) * wanted;
    const double apart = options.apart > 0 ? options.apart : common_distance(layer, single);
    result.apart = {apart, apart};
    if (options.apart <= 0 && options.copies == 0) result.apart = distances(layer, wanted, apart);
    Layout lines;
    for (std::size_t f = 0; f < 2; ++f)
        for (Polyline& line : layer.family(f, result.apart[f]))
            lines.push_back({kinds[f], std::move(line)});
    const double left = wanted - deposited_area(lines, width);
    if (options.copies > 0 && left > 0) {
        const auto copied_area = [&](double threshold) {
            return deposited_area(layer.copies(lines, threshold), width);
        };
        result.threshold = argument_of(copied_area, left, 1e-4 * layer.highest(), layer.highest());
        for (LayoutLine& copy : layer.copies(lines, result.threshold))
            result.layout.push_back(std::move(copy));
    }
    result.layout.insert(result.layout.end(), lines.begin(), lines.end());
}

}  // namespace

std::optional<ThesisLines> thesis_lines(const LoadCase& load_case, const ThesisOptions& options) {
    const double width = load_case.print.bead_width;
    ThesisLines fixed;
    fixed.layout = wall_lines(load_case.part, width, load_case.print.walls);
    for (LayoutLine& pad : pad_lines(load_case, load_case.print.walls))
        fixed.layout.push_back(std::move(pad));
    const double asked = load_case.print.fill * area(load_case.part);
    const double free = asked - deposited_area(fixed.layout, width);
    if (free <= 0) return std::nullopt;
    const ThesisLayer layer(load_case, options);
    std::optional<ThesisLines> best;
    double saved = 0;  // at crossings, which go with the lines: found by going round
    for (int round = 0; round < rounds; ++round) {
        ThesisLines result = fixed;
        lay(layer, options, free + saved, result);
        result.area = deposited_area(result.layout, load_case.print);
        saved = deposited_area(result.layout, width) - result.area;
        if (!best || std::abs(result.area - asked) < std::abs(best->area - asked))
            best = std::move(result);
        if (load_case.print.crossing_flow >= 1 ||
            std::abs(best->area - asked) < near_enough * asked)
            break;
    }
    return best;
}

}  // namespace bead
