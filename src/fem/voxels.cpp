#include "fem/voxels.h"

#include <algorithm>
#include <cmath>

namespace bead {
namespace {

// Rays pass beside edges of meshes that have round coordinates.
constexpr Vec2 aside{1.3e-6, 2.7e-6};  // of a cube

void add_crossings(const Mesh& mesh, const VoxelGrid& grid, std::vector<std::vector<float>>& at) {
    for (const auto& triangle : mesh.triangles) {
        const Vec3 a = mesh.points[std::size_t(triangle[0])];
        const Vec3 b = mesh.points[std::size_t(triangle[1])];
        const Vec3 c = mesh.points[std::size_t(triangle[2])];
        const double twice = cross(flat(b - a), flat(c - a));
        if (twice == 0) continue;
        const auto first = [&](double low, double origin, double shift) {
            return std::max(0, int(std::ceil((low - origin) / grid.size - 0.5 - shift)));
        };
        const auto last = [&](double high, double origin, double shift, int count) {
            return std::min(count - 1, int(std::floor((high - origin) / grid.size - 0.5 - shift)));
        };
        for (int j = first(std::min({a.y, b.y, c.y}), grid.origin.y, aside.y);
             j <= last(std::max({a.y, b.y, c.y}), grid.origin.y, aside.y, grid.cells[1]); ++j)
            for (int i = first(std::min({a.x, b.x, c.x}), grid.origin.x, aside.x);
                 i <= last(std::max({a.x, b.x, c.x}), grid.origin.x, aside.x, grid.cells[0]); ++i) {
                const Vec2 p = flat(grid.origin) + grid.size * (Vec2{i + 0.5, j + 0.5} + aside);
                const double u = cross(p - flat(a), flat(c - a)) / twice;
                const double v = cross(flat(b - a), p - flat(a)) / twice;
                if (u < 0 || v < 0 || u + v > 1) continue;
                at[std::size_t(j) * std::size_t(grid.cells[0]) + std::size_t(i)].push_back(
                    float(a.z + u * (b.z - a.z) + v * (c.z - a.z) - grid.origin.z));
            }
    }
}

void fill_column(VoxelGrid& grid, std::size_t column, std::vector<float>& at) {
    std::ranges::sort(at);
    const std::size_t layer = std::size_t(grid.cells[0]) * std::size_t(grid.cells[1]);
    for (std::size_t k = 0; k + 1 < at.size(); k += 2) {
        const auto cell = [&](float z) {
            return std::clamp(int(std::ceil(double(z) / grid.size - 0.5 - 1e-6)), 0, grid.cells[2]);
        };
        for (int z = cell(at[k]); z < cell(at[k + 1]); ++z)
            grid.solid[std::size_t(z) * layer + column] = 1;
    }
}

// Numbers the pieces from 1 and tells how large each is.
std::vector<std::size_t> label_pieces(const VoxelGrid& grid, std::vector<int>& piece) {
    const std::size_t nx = std::size_t(grid.cells[0]), ny = std::size_t(grid.cells[1]);
    std::vector<std::size_t> sizes, open;
    const auto visit = [&](std::size_t cell) {
        if (grid.solid[cell] == 0 || piece[cell] != 0) return;
        piece[cell] = int(sizes.size());
        ++sizes.back();
        open.push_back(cell);
    };
    for (std::size_t start = 0; start < piece.size(); ++start) {
        if (grid.solid[start] == 0 || piece[start] != 0) continue;
        sizes.push_back(0);
        visit(start);
        while (!open.empty()) {
            const std::size_t cell = open.back();
            open.pop_back();
            if (cell % nx > 0) visit(cell - 1);
            if (cell % nx + 1 < nx) visit(cell + 1);
            if (cell / nx % ny > 0) visit(cell - nx);
            if (cell / nx % ny + 1 < ny) visit(cell + nx);
            if (cell >= nx * ny) visit(cell - nx * ny);
            if (cell + nx * ny < piece.size()) visit(cell + nx * ny);
        }
    }
    return sizes;
}

void keep_largest(VoxelGrid& grid) {
    std::vector<int> piece(grid.solid.size(), 0);
    const std::vector<std::size_t> sizes = label_pieces(grid, piece);
    if (sizes.size() < 2) return;
    const int largest = int(std::ranges::max_element(sizes) - sizes.begin()) + 1;
    for (std::size_t cell = 0; cell < piece.size(); ++cell)
        if (piece[cell] != largest) grid.solid[cell] = 0;
}

}  // namespace

VoxelGrid voxels(const Mesh& mesh, double size) {
    const Box3 box = bounds(mesh);
    const Vec3 extent = box.size();
    VoxelGrid grid;
    grid.origin = box.low;
    grid.size = extent.x / std::ceil(extent.x / size - 1e-9);
    const auto count = [&](double length) {
        return std::max(1, int(std::ceil(length / grid.size - 1e-6)));
    };
    grid.cells = {count(extent.x), count(extent.y), count(extent.z)};
    const std::size_t columns = std::size_t(grid.cells[0]) * std::size_t(grid.cells[1]);
    grid.solid.assign(columns * std::size_t(grid.cells[2]), 0.0F);
    std::vector<std::vector<float>> at(columns);
    add_crossings(mesh, grid, at);
    for (std::size_t column = 0; column < columns; ++column) fill_column(grid, column, at[column]);
    keep_largest(grid);
    return grid;
}

}  // namespace bead
