// Values on the nodes of a square grid, bilinear between them, and as at the border beyond it.
#pragma once
#include <algorithm>
#include <cmath>
#include <vector>

#include "geom/vec.h"

namespace bead {

// T is added and multiplied by numbers: double, PlaneTensor.
template <class T>
struct Sampled {
    Vec2 origin;                // mm, of node (0, 0)
    double step = 1;            // mm
    int columns = 2, rows = 2;  // of nodes
    std::vector<T> values;      // row by row

    [[nodiscard]] const T& node(int i, int j) const {
        return values[static_cast<std::size_t>(j) * static_cast<std::size_t>(columns) +
                      static_cast<std::size_t>(i)];
    }
    [[nodiscard]] T operator()(Vec2 p) const {
        const Vec2 grid = (p - origin) / step;
        const double x = std::clamp(grid.x, 0.0, static_cast<double>(columns - 1));
        const double y = std::clamp(grid.y, 0.0, static_cast<double>(rows - 1));
        const int i = std::min(static_cast<int>(x), columns - 2);
        const int j = std::min(static_cast<int>(y), rows - 2);
        const double a = x - i, b = y - j;
        return (1 - b) * ((1 - a) * node(i, j) + a * node(i + 1, j)) +
               b * ((1 - a) * node(i, j + 1) + a * node(i + 1, j + 1));
    }
};

}  // namespace bead
