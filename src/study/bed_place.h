// Where a print stands on its bed: the turn and the shift that put what a file lays back on the
// part as its case draws it. Slicers centre parts, users turn them, or print them upside down.
//
// Idea: for a turn the shift follows from the boxes of part and print. Quarter turns are tried
// first, then all turns (the boxes agree at few of them, those are refined), then the same of the
// mirrored part; the fit is how far beads lie outside the part and how far its boundary is from
// the nearest bead. Where several turns fit alike (a rectangle and its half turn) the first counts:
// only who sliced it can know better.
#pragma once
#include <optional>

#include "geom/polygon.h"
#include "toolpath/path.h"

namespace bead {

struct BedPlace {
    double turn = 0;        // rad, by which the print stands turned, counter-clockwise
    bool mirrored = false;  // x reversed before that, as of a part turned over
    Vec2 origin;            // where the case's (0, 0) lies on the bed, mm
};

// What the user knows of it.
struct BedPlaceWish {
    std::optional<double> turn;
    std::optional<Vec2> origin;
};

// From the bed to the case.
Vec2 in_case(const BedPlace& place, Vec2 on_bed);
std::vector<Toolpath> in_case(const BedPlace& place, std::vector<Toolpath> layers);

// Nothing if no place within the wish lays the beads on the part: their boxes differ by more than a
// bead's width, beads lie outside it, or its boundary has no wall though the print has walls.
std::optional<BedPlace> bed_place(const std::vector<Toolpath>& layers, const Region& part,
                                  const BedPlaceWish& wish = {});

}  // namespace bead
