// A load case in space from beginning to end: cubes (hex8), boxes that hold and pull, multigrid,
// stress at nodes and probes.
#pragma once
#include <optional>
#include <string>

#include "fem/solid_case.h"
#include "fem/voxels.h"
#include "field/tensor3.h"

namespace bead {

struct SolidOptions {
    double size = 0;  // mm, of cubes; 0: the cube root of the part's volume over 40
    double tolerance = 1e-8;
    int most = 500;
};

struct SolidProbe {
    Vec3 at, displacement;
    Tensor3 stress;
};

struct SolidAnswer {
    VoxelGrid grid;
    std::vector<std::size_t> nodes;  // of the grid, that touch a solid cube; as what follows:
    std::vector<Vec3> displacement;
    std::vector<Tensor3> stress;  // MPa, mean over the cubes around
    double work = 0;              // N mm
    double largest = 0;           // mm
    std::vector<Vec3> reactions;  // N, per support; a node that two supports hold is the first's
    std::vector<SolidProbe> probes;
    bool converged = false;
    double residual = 0;
    int iterations = 0;
    std::optional<std::string> failure;  // what went wrong instead, for people
};

SolidAnswer solved_solid(const SolidCase& solid, const SolidOptions& options);

}  // namespace bead
