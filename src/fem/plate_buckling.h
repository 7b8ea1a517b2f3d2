// Buckling of a sheet out of its plane: the load factors at which a plate under the sheet's own
// stresses deflects sideways, (K + lambda Kg) w = 0, on the pixels of fem/pixel_model.h with plate
// elements (fem/plate_element.h). Solved as buckling in the plane is (fem/buckling.h).
#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "fem/pixel_model.h"

namespace bead {

// Per unknown 3 * node (deflection), + 1 and + 2 (slopes by x, by y): held at 0 or free.
using PlateHeld = std::vector<std::uint8_t>;

struct PlateOptions {
    double tolerance = 1e-3;  // relative, of the factor
    int most = 120;           // Lanczos vectors
};

struct PlateBuckling {
    double factor = 0;               // of the loads, positive; 0: nothing is pressed
    std::vector<double> deflection;  // per node, of the first mode
    bool converged = false;
};

// `rigidity`: per pixel, N mm; thickness³ / 12 times its law for one material all through.
// `displacement`: the sheet's, in its plane. Nothing if what is held lets the plate move.
std::optional<PlateBuckling> plate_buckling(const PixelModel& sheet,
                                            std::span<const PlaneLaw> rigidity,
                                            const PlateHeld& held,
                                            std::span<const double> displacement,
                                            const PlateOptions& options = {});

// thickness³ / 12 times the sheet's law, pixel by pixel.
std::vector<PlaneLaw> plate_rigidity(const PixelModel& sheet);

}  // namespace bead
