// What a file format's reader hands over: the mesh in the file's own unit.
#pragma once
#include "mesh/mesh.h"

namespace bead {

struct ParsedMesh {
    Mesh mesh;
    double unit_mm = 1;  // size of the file's unit, when the format says one
};

}  // namespace bead
