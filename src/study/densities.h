// How much bead runs which way where: the best layout before there are any beads. At each place two
// families of lines cross at right angles, with densities between 0 and 1; together with walls and
// pads they are an elastic sheet. The families turn to the principal stresses of that sheet and the
// densities go to where all of it is stressed alike, again and again (fully stressed design; for
// one load the stiffest layout too, Michell 1904). Compression may be somewhat higher than tension,
// for plastics bear more of it.
//
//     const Densities best = densities(load_case, fixed_lines, {.area = 900});
#pragma once
#include "field/sampled.h"
#include "field/tensor.h"
#include "study/layout.h"

namespace bead {

struct DensityOptions {
    double area = 0;  // mm² of bead for both families
    double cell = 1;  // mm
    int iterations = 40;
    double least = 0.02, most = 1;
    double compression = 1.25;  // of what tension may be; see allowed_compression
    double smoothing = 1;       // mm, of the stress
    double excluded = 4;        // mm around loads and supports where no excess is seen
};

// Families: 0 along the first (more tensile) principal stress, 1 across it.
struct Densities {
    Sampled<PlaneTensor> frame;              // its principal directions are those of the families
    std::array<Sampled<double>, 2> density;  // bead area per area
    double work = 0;                         // N mm, of the first variant: what beads can reach
};

// Half of what a material bears more in compression than in tension: all of it gains no more, for
// lines in compression bend.
double allowed_compression(const SolidMaterial& material);

Densities densities(const LoadCase& load_case, const Layout& fixed, const DensityOptions& options);

}  // namespace bead
