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
    result.reserve(line.size());
    for (std::size_t i = 2; i < line.size(); ++i) {
        const Vec2 before = line[i - 1] - line[i - 2], after = line[i] - line[i - 1];
        result.push_back(std::atan2(cross(before, after), dot(before, after)));
    }
    return result;
}

int sharper_than(const std::vector<double>& turns, double limit) {
    return static_cast<int>(
        std::ranges::count_if(turns, [&](double turn) { return std::abs(turn) > limit; }));
}

int turning_points(const Polyline& line, double limit) { return sharper_than(turns(line), limit); }

int windowed_turning_points(const Polyline& line, const std::vector<double>& turns, double limit,
                            double window) {
    std::vector<double> places;
    places.reserve(turns.size());
    double place = 0;
    for (std::size_t i = 0; i < turns.size(); ++i)
        places.push_back(place += distance(line[i], line[i + 1]));
    int count = 0;
    double last = -2 * window;
    for (std::size_t i = 0; i < turns.size(); ++i) {
        if (largest_change(turns, places, i, window) <= limit) continue;
        if (places[i] - last >= window) ++count;
        last = places[i];
    }
    return count;
}

int windowed_turning_points(const Polyline& line, double limit, double window) {
    return windowed_turning_points(line, turns(line), limit, window);
}

}  // namespace bead
