#include "strength/failure_index.h"

#include <algorithm>
#include <cmath>

#include "geom/line_index.h"

namespace bead {
namespace {

// Sums of a row up to each pixel.
std::vector<double> running_sums(const std::vector<double>& values, const PixelGrid& grid) {
    std::vector<double> sums;
    sums.reserve(values.size() + static_cast<std::size_t>(grid.rows));
    for (int j = 0; j < grid.rows; ++j) {
        sums.push_back(0);
        for (int i = 0; i < grid.columns; ++i)
            sums.push_back(sums.back() + values[grid.pixel(i, j)]);
    }
    return sums;
}

}  // namespace

std::vector<double> averaged_over_solid(const PixelModel& model, const std::vector<double>& values,
                                        double radius) {
    const PixelGrid& grid = model.grid;
    std::vector<double> inside(values.size()), solid(values.size());
    for (std::size_t p = 0; p < values.size(); ++p) {
        solid[p] = model.factor[p] > 0 ? 1 : 0;
        inside[p] = solid[p] * values[p];
    }
    const std::vector<double> sums = running_sums(inside, grid), counts = running_sums(solid, grid);
    const double reach = radius / grid.size;
    const int rows = static_cast<int>(std::floor(reach + 1e-9));
    std::vector<int> half;
    for (int y = -rows; y <= rows; ++y)
        half.push_back(
            static_cast<int>(std::floor(std::sqrt(std::max(0.0, reach * reach + 1e-9 - y * y)))));
    std::vector<double> means(values.size(), 0.0);
    for (int j = 0; j < grid.rows; ++j)
        for (int i = 0; i < grid.columns; ++i) {
            if (solid[grid.pixel(i, j)] == 0) continue;
            double sum = 0, count = 0;
            for (int y = std::max(-rows, -j); y <= std::min(rows, grid.rows - 1 - j); ++y) {
                const int at = y + rows;
                const int h = half[static_cast<std::size_t>(at)];
                const int from = std::max(i - h, 0), to = std::min(i + h + 1, grid.columns);
                const std::size_t row = grid.node(0, j + y);
                sum += sums[row + static_cast<std::size_t>(to)] -
                       sums[row + static_cast<std::size_t>(from)];
                count += counts[row + static_cast<std::size_t>(to)] -
                         counts[row + static_cast<std::size_t>(from)];
            }
            means[grid.pixel(i, j)] = sum / count;
        }
    return means;
}

std::vector<std::uint8_t> far_from(const PixelGrid& grid, const std::vector<Polyline>& lines,
                                   double distance) {
    const LineIndex index(lines, std::max(distance, grid.size));
    std::vector<std::uint8_t> far(grid.pixels());
    for (std::size_t p = 0; p < far.size(); ++p)
        far[p] = index.nearest(grid.centre(p), distance) ? 0 : 1;
    return far;
}

}  // namespace bead
