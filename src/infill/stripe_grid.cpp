#include "infill/stripe_grid.h"

#include <cmath>

#include "core/expects.h"
#include "geom/box.h"

namespace bead {
namespace {

class Cells {
  public:
    Cells(const Region& region, double cell) : cell_(cell), box_(bounds(region)) {
        // A little off, so that the region's straight sides do not run along the grid's lines.
        low_ = box_.low - 0.53 * Vec2{cell, cell};
        columns_ = static_cast<int>(std::ceil((box_.high.x - low_.x) / cell)) + 1;
        rows_ = static_cast<int>(std::ceil((box_.high.y - low_.y) / cell)) + 1;
        mark(region);
    }

    void build(StripeGrid& grid) {
        vertices_.assign(index(0, rows_ + 1), -1);
        for (int row = 0; row < rows_; ++row)
            for (int column = 0; column < columns_; ++column)
                if (touched_[index(column, row)]) add_cell(grid, column, row);
    }

  private:
    std::size_t index(int column, int row) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_ + 1) +
               static_cast<std::size_t>(column);
    }
    Vec2 place(int column, int row) const {
        return low_ + cell_ * Vec2{static_cast<double>(column), static_cast<double>(row)};
    }

    // A cell is touched if a corner of it lies in the region or within a cell of its edge.
    void mark(const Region& region) {
        std::vector<char> near(index(0, rows_ + 1), 0);
        for (int row = 0; row <= rows_; ++row)
            for (int column = 0; column <= columns_; ++column) {
                const Vec2 p = place(column, row);
                near[index(column, row)] =
                    contains(region, p) || boundary_distance(region, p) < cell_;
            }
        touched_.assign(near.size(), 0);
        for (int row = 0; row < rows_; ++row)
            for (int column = 0; column < columns_; ++column)
                touched_[index(column, row)] =
                    near[index(column, row)] || near[index(column + 1, row)] ||
                    near[index(column, row + 1)] || near[index(column + 1, row + 1)];
    }

    int vertex(StripeGrid& grid, int column, int row) {
        int& number = vertices_[index(column, row)];
        if (number < 0) {
            number = static_cast<int>(grid.places.size());
            grid.places.push_back(place(column, row));
        }
        return number;
    }

    void add_cell(StripeGrid& grid, int column, int row) {
        const int a = vertex(grid, column, row), b = vertex(grid, column + 1, row);
        const int c = vertex(grid, column + 1, row + 1), d = vertex(grid, column, row + 1);
        grid.triangles.push_back({a, b, c});
        grid.triangles.push_back({a, c, d});
        const auto is_touched = [&](int x, int y) {
            return x >= 0 && y >= 0 && x < columns_ && y < rows_ && touched_[index(x, y)];
        };
        grid.edges.push_back({d, c});
        grid.edges.push_back({b, c});
        if (!is_touched(column, row - 1)) grid.edges.push_back({a, b});
        if (!is_touched(column - 1, row)) grid.edges.push_back({a, d});
    }

    double cell_;
    Box2 box_;
    Vec2 low_;
    int columns_ = 0, rows_ = 0;
    std::vector<char> touched_;
    std::vector<int> vertices_;
};

}  // namespace

StripeGrid stripe_grid(const Region& region, const LineField& field, double cell) {
    BEAD_EXPECTS(cell > 0 && !region.empty());
    StripeGrid grid;
    Cells(region, cell).build(grid);
    for (const Vec2 p : grid.places) {
        grid.normals.push_back(left_of(field.direction(p)));
        grid.waves.push_back(2 * pi / field.spacing(p));
    }
    return grid;
}

PhaseStep phase_step(const StripeGrid& grid, int from, int to) {
    const auto i = static_cast<std::size_t>(from), j = static_cast<std::size_t>(to);
    const bool flips = dot(grid.normals[i], grid.normals[j]) < 0;
    const Vec2 there = grid.waves[j] * (flips ? -grid.normals[j] : grid.normals[j]);
    const Vec2 mean = 0.5 * (grid.waves[i] * grid.normals[i] + there);
    return {flips, dot(mean, grid.places[j] - grid.places[i])};
}

}  // namespace bead
