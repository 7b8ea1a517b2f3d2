// Meshes with their fields as a .vtu file (VTK's XML for unstructured grids), which ParaView reads.
#pragma once
#include <iosfwd>
#include <span>
#include <string>
#include <vector>

#include "fem/plane_mesh.h"

namespace bead {

struct VtuField {
    std::string name;
    int components = 1;  // per point; 6: a symmetric tensor, xx yy zz xy yz zx
    std::vector<float> values;
};

struct VtuMesh {
    std::vector<float> points;  // x y z x y z …
    std::vector<int> cells;     // their points, one cell after another
    int points_per_cell = 3;
    int type = 5;  // VTK's number of the cell's kind
};

VtuMesh vtu_mesh(const PlaneMesh& mesh);
void write_vtu(std::ostream& out, const VtuMesh& mesh, const std::vector<VtuField>& fields);

}  // namespace bead
