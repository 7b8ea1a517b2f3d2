// The ways of printing one section that a table of shaking compares (study/shaking.h), each with
// the figures that need no time law:
//
//     B1   as a plain slicer lays it       B1r  the same with its chords made anew, and nothing
//     else T1   B1 smoothed                     B1w  B1 with fewer, wider wall beads, and nothing
//     else T2   B1 with those beads, smoothed   T2t  T2 with infill loops left out at unchanged
//     void B0   loops as they come, each from its first corner: never what gains are counted from
#pragma once
#include <string>
#include <vector>

#include "smooth/sliced_section.h"
#include "smooth/smooth.h"
#include "study/shaking.h"

namespace bead {

struct WaysOptions {
    SectionOptions section;
    SmoothOptions smooth;
};

// Loops in the order in which they are made, always from the same corner.
Toolpath naive_section(const Region& section, const SectionOptions& options = {});

// The section with the curves that its polygons stand for, in chords finer than 1 µm: what a part
// that was drawn with curves should be.
Region with_curves(const Region& section);

// In the order B1, B1r, B1w, T1, T2, T2t.
std::vector<ShakenPath> printing_ways(const std::string& part, const Region& section,
                                      const WaysOptions& options = {});

// Lengths, points, turns, chords, how far the outer walls are from those of `plain`; coverage of
// the wall band, against the section with its curves.
std::vector<Figure> path_figures(const Toolpath& layer, const Toolpath& plain,
                                 const Region& section, double band);

}  // namespace bead
