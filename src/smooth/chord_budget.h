// Strokes and the travel between them in chords: as fine and as quiet as a number of points allows.
#pragma once
#include "smooth/chords.h"
#include "smooth/smooth.h"

namespace bead {

// A stroke with the travel that leads to it, dense.
struct LaidStroke {
    std::size_t chain = 0;
    MeasuredRibbon travel;  // may be empty
    MeasuredRibbon smooth;  // corners rounded
    MeasuredRibbon plain;   // as wound; empty if nothing was rounded
    bool infill = false;

    [[nodiscard]] const MeasuredRibbon& stroke(bool rounds_walls, bool rounds_infill) const {
        const bool rounds = infill ? rounds_infill : rounds_walls;
        return rounds || plain.at.empty() ? smooth : plain;
    }
};

struct ChordedStroke {
    Ribbon travel, stroke;
};

// `most`: points of all of them. Where even the coarsest chords have more, the coarsest.
std::vector<ChordedStroke> within_budget(const std::vector<LaidStroke>& strokes,
                                         const SmoothOptions& options, double most);

}  // namespace bead
