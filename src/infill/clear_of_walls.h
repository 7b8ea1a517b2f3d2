// Lines cut where they run beside a wall, nearer than a bead: there they lie on plastic that is
// laid already and only press it out. A line that meets a wall keeps its joint; what goes on along
// the wall is left out, and the rest of the line begins anew where it leaves the wall.
#pragma once
#include <span>

#include "infill/trimmed_ends.h"

namespace bead {

struct ClearOptions {
    double near = 0.5;     // mm between centre lines: nearer is on the wall
    double contact = 0.3;  // mm, at which a line has met the wall
    double longest = 2.4;  // mm that a line may run near a wall, meeting or crossing it
};

std::vector<FamilyLine> clear_of_walls(const std::vector<FamilyLine>& lines,
                                       std::span<const Polyline> walls,
                                       const ClearOptions& options);

// mm of the lines that lie nearer to a wall than `near`, without ends and crossings that are no
// longer than `longest`.
double length_along_walls(const std::vector<FamilyLine>& lines, std::span<const Polyline> walls,
                          const ClearOptions& options);

}  // namespace bead
