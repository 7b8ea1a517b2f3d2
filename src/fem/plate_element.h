// A square plate element after Kirchhoff: deflection and both slopes at its corners, a polynomial
// of twelve terms between them (Adini and Clough 1961, Melosh 1963). Slopes do not quite fit from
// element to element, yet on squares it passes the patch test and converges with the square of the
// side. Unknowns of a corner: w, and half a side times its slopes by x and y, all mm.
#pragma once
#include <array>

#include "fem/plane_law.h"

namespace bead {

inline constexpr std::size_t plate_unknowns = 12;  // three at each of four corners
using PlateMatrix = std::array<double, plate_unknowns * plate_unknowns>;

// Row by row; `rigidity` gives moments (N) from curvatures (w_xx, w_yy, 2 w_xy): for a plate of one
// material thickness³ / 12 times its law.
PlateMatrix plate_stiffness(const PlaneLaw& rigidity, double side);

// What forces in the plane (N/mm, the same all over the element) do to the deflection.
PlateMatrix plate_geometric_stiffness(PlaneTensor force);

}  // namespace bead
