// A load case of the plane on square pixels, solved by multigrid; for meshes that are too large to
// factor. What it answers has the form of fem/sheet.h, every pixel an element.
#pragma once
#include "fem/sheet.h"

namespace bead {

Sheet pixel_sheet(const LoadCase& load_case, double size, const SheetOptions& options);

}  // namespace bead
