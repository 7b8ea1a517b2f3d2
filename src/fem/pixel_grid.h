// A grid of square pixels over the plane, and its nodes, the pixels' corners. Pixel (i, j) is
// number j * columns + i, node (i, j) is number j * (columns + 1) + i, both from the lower left.
#pragma once
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

#include "geom/box.h"

namespace bead {

struct PixelGrid {
    Vec2 origin;      // mm, lower left corner
    double size = 1;  // mm, of a pixel
    int columns = 0, rows = 0;

    [[nodiscard]] std::size_t pixels() const { return std::size_t(columns) * std::size_t(rows); }
    [[nodiscard]] std::size_t nodes() const {
        return std::size_t(columns + 1) * std::size_t(rows + 1);
    }
    [[nodiscard]] std::size_t pixel(int i, int j) const {
        return std::size_t(j) * std::size_t(columns) + std::size_t(i);
    }
    [[nodiscard]] std::size_t node(int i, int j) const {
        return std::size_t(j) * std::size_t(columns + 1) + std::size_t(i);
    }
    // Counter-clockwise from the lower left.
    [[nodiscard]] std::array<std::size_t, 4> corners(std::size_t pixel) const {
        const std::size_t first = pixel + pixel / std::size_t(columns);
        const std::size_t above = first + std::size_t(columns) + 1;
        return {first, first + 1, above + 1, above};
    }
    [[nodiscard]] Vec2 centre(std::size_t pixel) const {
        const std::size_t row = pixel / std::size_t(columns);
        return origin + size * Vec2{double(pixel % std::size_t(columns)) + 0.5, double(row) + 0.5};
    }
    [[nodiscard]] Vec2 place(std::size_t node) const {
        const std::size_t row = node / std::size_t(columns + 1);
        return origin + size * Vec2{double(node % std::size_t(columns + 1)), double(row)};
    }
};

// The pixel that a place lies in; nothing beyond the grid.
inline std::optional<std::size_t> pixel_at(const PixelGrid& grid, Vec2 p) {
    const Vec2 at = (p - grid.origin) / grid.size;
    if (!(at.x >= 0 && at.y >= 0 && at.x < grid.columns && at.y < grid.rows)) return std::nullopt;
    return grid.pixel(int(at.x), int(at.y));
}

// The box covered by pixels of about `size`: exactly, with the size made a little smaller, along
// its wider side if possible along both.
inline PixelGrid grid_over(const Box2& box, double size) {
    const Vec2 extent = box.size();
    const double columns = std::ceil(extent.x / size - 1e-9);
    const double fitted = extent.x / columns;
    const double rows = std::ceil(extent.y / fitted - 1e-9);
    return {box.low, fitted, int(columns), int(rows)};
}

}  // namespace bead
