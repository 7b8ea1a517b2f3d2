// A load case in space: a mesh, boxes that hold it, boxes that pull at it.
#pragma once
#include <string>
#include <vector>

#include "fem/load_case.h"
#include "mesh/mesh.h"

namespace bead {

struct BoxSupport {
    Box3 box;
    bool x = true, y = true, z = true;
};

struct BoxLoad {
    Box3 box;
    Vec3 force;  // N, the resultant, spread evenly over what of the part lies in the box
};

struct SolidCase {
    std::string title;
    Mesh mesh;
    SolidMaterial material;
    std::vector<BoxSupport> supports;
    std::vector<BoxLoad> loads;
    std::vector<Vec3> probes;
};

}  // namespace bead
