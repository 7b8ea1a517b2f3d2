// A densely sampled line as few chords: each as long as it may be without straying from the line,
// turning too much, or, where the line bends in earnest, forcing the machine at its own frequency:
// chords of length l at speed v push at v / l, which is kept above the modes.
//
// Each chord's ends are shifted by what the curve lies beside its two chords on average, so that
// chords cut off as much as they add and areas stay.
#pragma once
#include "smooth/ring.h"

namespace bead {

struct ChordOptions {
    double wall = 0.025, infill = 0.06, travel = 0.1;          // mm, chord from line
    double turn = 20 * pi / 180, travel_turn = 16 * pi / 180;  // rad, over one chord
    double step = 16;            // mm/s, by which the velocity changes from chord to chord
    double frequency = 22;       // Hz, the highest mode
    double above = 1.3;          // times that, a chord pushes at least
    double acceleration = 1000;  // mm/s², across a bend
    double quiet = 30;           // mm/s², below which a bend does not matter
};

Ribbon chorded(const Ribbon& ribbon, const ChordOptions& options);

}  // namespace bead
