// A densely sampled line as few chords: each as long as it may be without straying from the line,
// turning too much, or, where the line bends in earnest, shaking the machine. Chords of length l at
// speed v push at f = v / l with all of the bend's acceleration a = v² κ, which a mode at f0
// answers with the gain 1 / (r² - 1), r = f / f0. For a number of points the machine shakes least
// if (r² - 1)³ / r grows as a²: the more it bends, the farther above the modes.
//
// Each chord's ends are shifted by what the curve lies beside its two chords on average, so that
// chords cut off as much as they add and areas stay.
#pragma once
#include <cstdint>
#include <optional>

#include "smooth/ring.h"
#include "smooth/velocity_step.h"

namespace bead {

struct ChordOptions {
    double wall = 0.025, infill = 0.06, travel = 0.1;          // mm, chord from line
    double turn = 20 * pi / 180, travel_turn = 16 * pi / 180;  // rad, over one chord
    // Bends tighter than that are corners to every time law: few chords, so that it sees them.
    double tight_radius = 0.8, tight_turn = 50 * pi / 180;  // mm, rad
    bool fine_links = true;                                 // or one chord over all of a ramp
    double frequency = 22;                                  // Hz, the highest mode
    double loudness = 150;       // mm/s², the a at which (r² - 1)³ / r is 1; less: more points
    double acceleration = 1000;  // mm/s², across a bend
    double velocity_step = 14;   // mm/s, from chord to chord; more makes firmware brake
    double quiet = 30;           // mm/s², below which a bend does not matter
    std::optional<VelocityStep> step;  // what the firmware allows, instead of velocity_step
};

// A ribbon with what is asked of it again for every set of options.
struct MeasuredRibbon {
    Ribbon ribbon;
    std::vector<double> at;                 // mm along, of every point
    std::vector<double> turn;               // rad, of all turns up to every point
    std::vector<Vec2> along;                // direction at every point, half way through its turn
    std::vector<std::uint32_t> same_until;  // of every segment: behind those of its very flow
};
MeasuredRibbon measured(Ribbon ribbon);

Ribbon chorded(const MeasuredRibbon& measured, const ChordOptions& options);
std::size_t chord_count(const MeasuredRibbon& measured, const ChordOptions& options);

}  // namespace bead
