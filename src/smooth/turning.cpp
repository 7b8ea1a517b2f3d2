#include "smooth/turning.h"

#include <algorithm>

namespace bead {
namespace {

// The largest change of heading, either way, over the points from `first` within `reach` of it.
double largest_change(const std::vector<double>& turns, const std::vector<double>& places,
                      std::size_t first, double reach) {
    double heading = 0, largest = 0;
    for (std::size_t i = first; i < turns.size() && places[i] <= places[first] + reach; ++i) {
        heading += turns[i];
        largest = std::max(largest, std::abs(heading));
    }
    return largest;
}

}  // namespace

std::vector<double> turns(const Polyline& line) {
    std::vector<double> result;
    for (std::size_t i = 2; i < line.size(); ++i) {
        const Vec2 before = line[i - 1] - line[i - 2], after = line[i] - line[i - 1];
        result.push_back(std::atan2(cross(before, after), dot(before, after)));
    }
    return result;
}

int turning_points(const Polyline& line, double limit) {
    const std::vector<double> all = turns(line);
    return static_cast<int>(
        std::ranges::count_if(all, [&](double turn) { return std::abs(turn) > limit; }));
}

int windowed_turning_points(const Polyline& line, double limit, double window) {
    const std::vector<double> all = turns(line);
    std::vector<double> places;
    double place = 0;
    for (std::size_t i = 0; i < all.size(); ++i)
        places.push_back(place += distance(line[i], line[i + 1]));
    int count = 0;
    double last = -2 * window;
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (largest_change(all, places, i, window) <= limit) continue;
        if (places[i] - last >= window) ++count;
        last = places[i];
    }
    return count;
}

}  // namespace bead
