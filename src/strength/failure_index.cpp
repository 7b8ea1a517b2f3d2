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

// Sums over the pixels whose middles lie within `radius`, of those at solid ones.
class DiscSums {
  public:
    DiscSums(const PixelModel& model, double radius) : model_(model) {
        const double reach = radius / model.grid.size;
        rows_ = static_cast<int>(std::floor(reach + 1e-9));
        for (int y = -rows_; y <= rows_; ++y)
            half_.push_back(static_cast<int>(
                std::floor(std::sqrt(std::max(0.0, reach * reach + 1e-9 - y * y)))));
    }

    [[nodiscard]] std::vector<double> of(std::vector<double> values) const {
        const PixelGrid& grid = model_.grid;
        for (std::size_t p = 0; p < values.size(); ++p)
            if (model_.factor[p] == 0) values[p] = 0;
        const std::vector<double> sums = running_sums(values, grid);
        std::vector<double> found(values.size(), 0.0);
        for (int j = 0; j < grid.rows; ++j)
            for (int i = 0; i < grid.columns; ++i)
                if (model_.factor[grid.pixel(i, j)] > 0) found[grid.pixel(i, j)] = at(sums, i, j);
        return found;
    }

    [[nodiscard]] std::vector<double> counts() const {
        return of(std::vector<double>(model_.factor.size(), 1.0));
    }

  private:
    [[nodiscard]] double at(const std::vector<double>& sums, int i, int j) const {
        const PixelGrid& grid = model_.grid;
        double sum = 0;
        for (int y = std::max(-rows_, -j); y <= std::min(rows_, grid.rows - 1 - j); ++y) {
            const int row = y + rows_;
            const int h = half_[static_cast<std::size_t>(row)];
            const int from = std::max(i - h, 0), to = std::min(i + h + 1, grid.columns);
            const std::size_t first = grid.node(0, j + y);
            sum += sums[first + static_cast<std::size_t>(to)] -
                   sums[first + static_cast<std::size_t>(from)];
        }
        return sum;
    }

    const PixelModel& model_;
    int rows_ = 0;
    std::vector<int> half_;  // width either way, row by row
};

}  // namespace

std::vector<double> averaged_over_solid(const PixelModel& model, const std::vector<double>& values,
                                        double radius) {
    const DiscSums sums(model, radius);
    std::vector<double> means = sums.of(values);
    const std::vector<double> counts = sums.counts();
    for (std::size_t p = 0; p < means.size(); ++p)
        if (counts[p] > 0) means[p] /= counts[p];
    return means;
}

std::vector<double> averaging_adjoint(const PixelModel& model, const std::vector<double>& weights,
                                      double radius) {
    const DiscSums sums(model, radius);
    std::vector<double> shares = weights;
    const std::vector<double> counts = sums.counts();
    for (std::size_t p = 0; p < shares.size(); ++p)
        if (counts[p] > 0) shares[p] /= counts[p];
    return sums.of(std::move(shares));
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
