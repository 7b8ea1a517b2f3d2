#include "slice/slice.h"

#include <algorithm>
#include <iterator>
#include <optional>

#include "core/expects.h"
#include "core/parallel.h"
#include "geom/clip.h"
#include "geom/simplify.h"
#include "mesh/orient.h"
#include "slice/crossing.h"
#include "slice/gaps.h"
#include "slice/section.h"

namespace bead {
namespace {

// Layers are made in batches, which bounds the memory and paces the progress; within a batch,
// threads take blocks, each with one Cutter.
constexpr int batch_size = 128;
constexpr int block_size = 8;

// Where a layer is cut: half-way up, and a hair more. Designed parts have flat faces at round
// heights, many of them exactly half-way up a layer; without the hair, rounding would decide for
// each.
double cut_height(const Layer& layer) {
    constexpr double hair = 1e-5;  // mm; more than rounding to float moves a point
    return layer.z - layer.height / 2 + hair;
}

std::vector<Layer> empty_layers(double height, const SliceOptions& options) {
    std::vector<Layer> layers;
    Layer next{options.first_layer_height, options.first_layer_height, {}};
    while (cut_height(next) < height) {
        layers.push_back(next);
        const auto above_first = static_cast<double>(layers.size());
        next.z = options.first_layer_height + above_first * options.layer_height;
        next.height = options.layer_height;
    }
    return layers;
}

double turned_area(const std::vector<Polyline>& loops) {
    double sum = 0;
    for (const Polyline& loop : loops) sum += signed_area(loop);
    return sum;
}

std::vector<Polyline> reversed(std::vector<Polyline> loops) {
    for (Polyline& loop : loops) std::ranges::reverse(loop);
    return loops;
}

// What is wound round at all, in either direction: shells that overlap become one, cavities stay
// empty, and a shell that is inside out is solid nonetheless. The sum of the loops' areas tells
// when nothing overlaps and nothing is inside out, which is usual.
Region enclosed(const std::vector<Polyline>& loops) {
    Region solid = region_of(loops, FillRule::positive);
    constexpr double rounding = 1e-3;  // mm²; far below what a bead covers
    if (std::abs(area(solid) - turned_area(loops)) < rounding) return solid;
    const Region inside_out = region_of(reversed(loops), FillRule::positive);
    return inside_out.empty() ? solid : united(solid, inside_out);
}

// Without specks and pinholes below the resolution.
Region without_specks(Region region, double resolution) {
    const double least = resolution * resolution;
    std::erase_if(region,
                  [&](const Polygon& polygon) { return signed_area(polygon.outer) < least; });
    for (Polygon& polygon : region)
        std::erase_if(polygon.holes,
                      [&](const Polyline& hole) { return -signed_area(hole) < least; });
    return region;
}

// One layer's region, and what had to be done for it.
struct Outcome {
    Region region;
    long closed = 0, dropped = 0;
    double dropped_length = 0;
};

Outcome outcome_of(Section section, const SliceOptions& options) {
    Outcome outcome;
    Joined closed = joined(section.open, options.closing_gap);
    outcome.closed = static_cast<long>(closed.loops.size());
    outcome.dropped = static_cast<long>(closed.open.size());
    for (const Polyline& line : closed.open) outcome.dropped_length += length(line);
    std::ranges::move(closed.loops, std::back_inserter(section.loops));

    std::vector<Polyline> loops;
    for (const Polyline& loop : section.loops) {
        Polyline simple = simplified_loop(loop, options.resolution);
        if (simple.size() >= 3) loops.push_back(std::move(simple));
    }
    outcome.region = without_specks(enclosed(loops), options.resolution);
    return outcome;
}

std::vector<Outcome> outcomes(const Mesh& mesh, std::span<const Side> sides,
                              std::span<const double> planes, const SliceOptions& options) {
    const std::vector<int> opposite = opposite_sides(mesh, sides);
    const std::vector<PlaneRange> ranges = crossed_planes(mesh, planes);
    const int count = static_cast<int>(planes.size());
    std::vector<Outcome> result(planes.size());
    for (int first = 0; first < count; first += batch_size) {
        tell(options.progress, static_cast<double>(first) / count, "slicing");
        const int end = std::min(first + batch_size, count);
        const CrossedTriangles crossed(ranges, first, end);
        const int blocks = (end - first + block_size - 1) / block_size;
        parallel_for(static_cast<std::size_t>(blocks), options.threads, [&](std::size_t block) {
            Cutter cutter(mesh, opposite);
            const int from = first + static_cast<int>(block) * block_size;
            for (int i = from; i < std::min(from + block_size, end); ++i) {
                const auto layer = static_cast<std::size_t>(i);
                result[layer] = outcome_of(cutter.at(planes[layer], crossed.of(i)), options);
            }
        });
    }
    return result;
}

std::vector<Outcome> outcomes(const Mesh& mesh, std::span<const double> planes,
                              const SliceOptions& options) {
    const std::vector<Side> sides = sorted_sides(mesh);
    if (const std::optional<Mesh> agreed = reoriented(mesh, sides))
        return outcomes(*agreed, sorted_sides(*agreed), planes, options);
    return outcomes(mesh, sides, planes, options);
}

}  // namespace

Slices slice(const Mesh& mesh, const SliceOptions& options) {
    BEAD_EXPECTS(options.layer_height > 0 && options.first_layer_height > 0);
    BEAD_EXPECTS(options.closing_gap >= 0 && options.resolution >= 0);
    const Box3 box = bounds(mesh);
    Slices slices;
    if (box.is_empty()) return slices;
    slices.layers = empty_layers(box.size().z, options);

    std::vector<double> planes;
    for (const Layer& layer : slices.layers) planes.push_back(box.low.z + cut_height(layer));
    std::vector<Outcome> made = outcomes(mesh, planes, options);
    for (std::size_t i = 0; i < made.size(); ++i) {
        slices.layers[i].region = std::move(made[i].region);
        slices.closed_outlines += made[i].closed;
        slices.dropped_outlines += made[i].dropped;
        slices.dropped_length += made[i].dropped_length;
    }
    tell(options.progress, 1, "slicing");
    return slices;
}

}  // namespace bead
