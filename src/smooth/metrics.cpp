#include "smooth/metrics.h"

#include <algorithm>

#include "smooth/layer_line.h"
#include "smooth/turning.h"

namespace bead {
namespace {

constexpr double degree = pi / 180;
constexpr double least_segment = 0.02;  // mm

void add_lengths(PathMetrics& metrics, const LayerLine& line) {
    for (std::size_t i = 0; i < line.roles.size(); ++i) {
        const double piece = distance(line.points[i], line.points[i + 1]);
        metrics.length += piece;
        metrics.lengths[static_cast<std::size_t>(line.roles[i])] += piece;
        (line.roles[i] == Role::travel ? metrics.travel : metrics.extruded) += piece;
        if (i == 0 || piece < metrics.shortest_segment) metrics.shortest_segment = piece;
        if (line.phases[i] != Role::infill) continue;
        metrics.infill_length += piece;
        ++metrics.infill_points;
    }
}

void add_turns(PathMetrics& metrics, const Polyline& points) {
    const Polyline line = without_short_segments(points, least_segment);
    const std::vector<double> all = turns(line);
    metrics.turning_points_30 = sharper_than(all, 30 * degree);
    metrics.turning_points = sharper_than(all, 45 * degree);
    metrics.turning_points_60 = sharper_than(all, 60 * degree);
    metrics.windowed_turning_points = windowed_turning_points(line, all, 45 * degree);
    for (const double turn : all)
        metrics.mean_turn += std::abs(turn) / static_cast<double>(all.size());
}

// Pieces of the line of one phase, each with the point before it.
int windowed_of_phase(const LayerLine& line, Role phase) {
    int count = 0;
    Polyline piece;
    const auto finish = [&] {
        count += windowed_turning_points(without_short_segments(piece, least_segment), 45 * degree);
        piece.clear();
    };
    for (std::size_t i = 0; i < line.phases.size(); ++i) {
        if (line.phases[i] != phase) {
            finish();
            continue;
        }
        if (piece.empty()) piece.push_back(line.points[i]);
        piece.push_back(line.points[i + 1]);
    }
    finish();
    return count;
}

}  // namespace

PathMetrics path_metrics(const Toolpath& layer) {
    const LayerLine line = line_of(layer);
    PathMetrics metrics;
    metrics.points = static_cast<int>(line.points.size());
    add_lengths(metrics, line);
    add_turns(metrics, line.points);
    metrics.windowed_infill_turning_points = windowed_of_phase(line, Role::infill);
    metrics.chord_error_mean = mean_sagitta(line.points);
    metrics.travels_crossing_walls = travels_crossing_walls(layer);
    for (const Path& path : layer) metrics.volume += volume(path);
    return metrics;
}

double sagitta(Vec2 first, Vec2 second, Vec2 third) {
    const double a = distance(first, second), b = distance(second, third),
                 c = distance(third, first);
    const double doubled_area = std::abs(cross(second - first, third - first));
    if (doubled_area <= 1e-12 * a * b) return 0;
    const double radius = a * b * c / (2 * doubled_area);
    return a * a / 4 / (radius + std::sqrt(std::max(0.0, radius * radius - a * a / 4)));
}

double mean_sagitta(const Polyline& line) {
    if (line.size() < 3) return 0;
    double sum = 0;
    for (std::size_t i = 2; i < line.size(); ++i) sum += sagitta(line[i - 2], line[i - 1], line[i]);
    return sum / static_cast<double>(line.size() - 2);
}

}  // namespace bead
