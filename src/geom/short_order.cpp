#include "geom/short_order.h"

#include <algorithm>

#include "geom/near_order.h"

namespace bead {
namespace {

constexpr int passes = 30;
constexpr double worthwhile = 1e-6;       // mm
constexpr std::size_t most_lines = 3000;  // beyond them pairs are too many

// What taking lines first … last backwards saves, mm.
double saved(const std::vector<Polyline>& lines, Vec2 start, std::size_t first, std::size_t last) {
    const Vec2 before = first > 0 ? lines[first - 1].back() : start;
    const Vec2 begin = lines[first].front(), end = lines[last].back();
    double gain = distance(before, begin) - distance(before, end);
    if (last + 1 < lines.size()) {
        const Vec2 after = lines[last + 1].front();
        gain += distance(end, after) - distance(begin, after);
    }
    return gain;
}

void turn(std::vector<Polyline>& lines, std::size_t first, std::size_t last) {
    const auto begin = lines.begin() + static_cast<long>(first),
               end = lines.begin() + static_cast<long>(last) + 1;
    std::reverse(begin, end);
    for (auto line = begin; line != end; ++line) std::reverse(line->begin(), line->end());
}

bool improve(std::vector<Polyline>& lines, Vec2 start) {
    bool has_improved = false;
    for (std::size_t i = 0; i < lines.size(); ++i)
        for (std::size_t j = i; j < lines.size(); ++j)
            if (saved(lines, start, i, j) > worthwhile) {
                turn(lines, i, j);
                has_improved = true;
            }
    return has_improved;
}

}  // namespace

std::vector<Polyline> short_order(std::vector<Polyline> lines, Vec2 start) {
    lines = near_order(std::move(lines), start);
    if (lines.size() > most_lines) return lines;
    for (int pass = 0; pass < passes && improve(lines, start); ++pass) {
    }
    return lines;
}

double travel_between(const std::vector<Polyline>& lines, Vec2 start) {
    double sum = 0;
    for (const Polyline& line : lines) {
        sum += distance(start, line.front());
        start = line.back();
    }
    return sum;
}

}  // namespace bead
