#include "vibration/contour.h"

#include <algorithm>
#include <limits>

namespace bead {
namespace {

constexpr double finest = 1e-7;    // mm, what is below counts as this
constexpr double fineness = 1e-3;  // relative width of a bin

double distance_to(Vec2 point, Vec2 a, Vec2 b) {
    const Vec2 along = b - a;
    const double size = dot(along, along);
    if (size == 0) return distance(point, a);
    return distance(point, a + std::clamp(dot(point - a, along) / size, 0.0, 1.0) * along);
}

std::size_t bin_of(double value) {
    return std::size_t(std::log(std::max(value, finest) / finest) / std::log1p(fineness));
}

}  // namespace

void Contour::add(Vec2 point) {
    ways_.push_back(points_.empty() ? 0 : ways_.back() + distance(points_.back(), point));
    points_.push_back(point);
}

// A point that is d away from a vertex is at least d - s away from what follows within s: most of a
// fine path need not be looked at.
double Contour::error(Vec2 point, double way) {
    while (first_ + 2 < points_.size() && ways_[first_ + 1] < way - window_) ++first_;
    if (first_ > 4096) forget();
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = first_; i + 1 < points_.size() && ways_[i] <= way + window_;) {
        nearest = std::min(nearest, distance_to(point, points_[i], points_[i + 1]));
        const double free = distance(point, points_[i + 1]) - nearest;
        const double until = ways_[i + 1] + free;
        for (++i; i + 1 < points_.size() && ways_[i + 1] < until;) ++i;
    }
    return points_.size() == 1 ? distance(point, points_[0]) : nearest;
}

void Contour::forget() {
    points_.erase(points_.begin(), points_.begin() + std::ptrdiff_t(first_));
    ways_.erase(ways_.begin(), ways_.begin() + std::ptrdiff_t(first_));
    first_ = 0;
}

void Percentiles::add(double value) {
    const std::size_t bin = bin_of(value);
    if (bin >= bins_.size()) bins_.resize(bin + 1);
    ++bins_[bin];
    ++count_;
}

double Percentiles::at(double part) const {
    const double wanted = part * double(count_);
    double seen = 0;
    for (std::size_t i = 0; i < bins_.size(); ++i) {
        seen += double(bins_[i]);
        if (seen >= wanted && seen > 0)
            return finest * std::exp((double(i) + 0.5) * std::log1p(fineness));
    }
    return 0;
}

}  // namespace bead
