// Parts of metal filament: designed and tested as they are once sintered, printed larger. A case's
// part and loads are the sintered part's; its beads are what the printer lays, green.
#pragma once
#include "study/layout.h"

namespace bead {

// The beads of the sintered part.
PrintWish as_sintered(const PrintWish& green, const SolidMaterial& material);

// A layer of a green part's print as it is once sintered.
Toolpath as_sintered(Toolpath green, const SolidMaterial& material);

// What is to be printed: the layout and the case's part, places and beads made larger; it is good
// for printing only. Other materials stay as they are.
struct GreenPart {
    Layout layout;
    LoadCase load_case;
};
GreenPart green_part(Layout layout, const LoadCase& load_case);

}  // namespace bead
