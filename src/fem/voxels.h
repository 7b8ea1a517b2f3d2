// A mesh as a grid of cubes: a cube is solid if its middle lies inside. Rays up through the
// columns' middles cross the surface; between the first and the second crossing, the third and the
// fourth … is inside.
#pragma once
#include <array>
#include <vector>

#include "mesh/mesh.h"

namespace bead {

struct VoxelGrid {
    Vec3 origin;
    double size = 1;             // mm, side of a cube
    std::array<int, 3> cells{};  // x runs fastest
    std::vector<float> solid;    // per cube, 0 or 1

    [[nodiscard]] std::array<std::size_t, 3> counts() const {  // of nodes
        return {std::size_t(cells[0]) + 1, std::size_t(cells[1]) + 1, std::size_t(cells[2]) + 1};
    }
    [[nodiscard]] Vec3 place(std::size_t node) const {
        const auto n = counts();
        const std::size_t row = node / n[0] % n[1], layer = node / (n[0] * n[1]);
        return origin + size * Vec3{double(node % n[0]), double(row), double(layer)};
    }
};

// Only the largest piece that hangs together through faces is kept.
VoxelGrid voxels(const Mesh& mesh, double size);

}  // namespace bead
