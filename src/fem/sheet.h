// A load case of the plane from beginning to end: meshed, loaded, solved, its stress at nodes and
// probes. Triangles of six nodes that follow the boundary; for meshes too large to factor, square
// pixels and multigrid.
#pragma once
#include <optional>
#include <string>

#include "fem/load_case.h"
#include "fem/plane_mesh.h"

namespace bead {

enum class Elements { automatic, triangles, pixels };

struct SheetOptions {
    double size = 0;  // mm, of elements; 0: the root of the part's area over 60
    Elements elements = Elements::automatic;
    double tolerance = 1e-8;  // of the residual, where the solver iterates
    int most = 500;           // iterations
};

struct SheetProbe {
    Vec2 at, displacement;
    PlaneTensor stress;
};

struct SheetAnswer {
    std::vector<double> displacement;  // mm, 2 per node
    std::vector<PlaneTensor> stress;   // MPa, per node
    double work = 0;                   // N mm, force times displacement, all loads
    double largest = 0;                // mm, displacement of any node
    std::vector<Vec2> reactions;  // N, per support; a node that two supports hold is the first's
    std::vector<SheetProbe> probes;
    bool converged = true;
    double residual = 0;
    int iterations = 0;  // 0: solved directly
};

struct Sheet {
    PlaneMesh mesh;
    double size = 0;
    std::vector<SheetAnswer> answers;  // per situation
    // What went wrong instead, for people: supports that hold nothing, a boundary that cannot be
    // meshed.
    std::optional<std::string> failure;
};

double usual_size(const LoadCase& load_case);
Sheet solved_sheet(const LoadCase& load_case, const SheetOptions& options);

}  // namespace bead
