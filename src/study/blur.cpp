#include "study/blur.h"

#include <algorithm>
#include <cmath>

namespace bead {
namespace {

// Combines each pixel's neighbours along one axis: combine(sum so far, value, offset).
template <class Combine>
std::vector<double> along(const std::vector<double>& values, const PixelGrid& grid, bool in_x,
                          int reach, double start, const Combine& combine) {
    std::vector<double> result(values.size());
    for (int j = 0; j < grid.rows; ++j)
        for (int i = 0; i < grid.columns; ++i) {
            const int at = in_x ? i : j, end = in_x ? grid.columns : grid.rows;
            double sum = start;
            for (int k = std::max(-reach, -at); k <= std::min(reach, end - 1 - at); ++k)
                sum = combine(sum, values[in_x ? grid.pixel(i + k, j) : grid.pixel(i, j + k)], k);
            result[grid.pixel(i, j)] = sum;
        }
    return result;
}

std::vector<double> convolved(const std::vector<double>& values, const PixelGrid& grid,
                              double deviation) {
    const double pixels = deviation / grid.size;
    const int reach = static_cast<int>(std::ceil(4 * pixels));
    const auto weigh = [&](double sum, double value, int k) {
        return sum + value * std::exp(-0.5 * k * k / (pixels * pixels));
    };
    return along(along(values, grid, true, reach, 0, weigh), grid, false, reach, 0, weigh);
}

}  // namespace

std::vector<double> blurred(const std::vector<double>& values, std::span<const double> solid,
                            const PixelGrid& grid, double deviation) {
    std::vector<double> weight(values.size()), weighted(values.size());
    for (std::size_t p = 0; p < values.size(); ++p) {
        weight[p] = solid[p] > 0 ? 1 : 0;
        weighted[p] = weight[p] * values[p];
    }
    std::vector<double> sum = convolved(weighted, grid, deviation);
    const std::vector<double> all = convolved(weight, grid, deviation);
    for (std::size_t p = 0; p < sum.size(); ++p) sum[p] = weight[p] > 0 ? sum[p] / all[p] : 0;
    return sum;
}

std::vector<double> widened(const std::vector<double>& values, const PixelGrid& grid, double side) {
    const int reach = static_cast<int>(side / grid.size / 2);
    const auto highest = [](double sum, double value, int) { return std::max(sum, value); };
    return along(along(values, grid, true, reach, -1e300, highest), grid, false, reach, -1e300,
                 highest);
}

}  // namespace bead
