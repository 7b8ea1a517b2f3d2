// Arcs as firmware prints them: cut into straight chords before anything is planned, by a rule of
// its own for their number and with its own way round the circle.
//
//   prusa       ceil(way / s), s = 1/20 of the circle within 0.5 … 1 mm; turned by the small-angle
//               matrix, every 26th point exact (Prusa-Firmware 6dbf35f6, mc_arc)
//   prusa_2017  floor(way / 1 mm), a matrix of lower order, likewise
//   marlin      floor(flat way / 1 mm), at least 72 to the circle, none below 0.1 mm; every 25th
//               point exact (Marlin 2.1, plan_arc)
//   klipper     floor(way / resolution), every point exact (gcode_arcs.py)
#pragma once
#include <cstdint>
#include <functional>

#include "toolpath/command.h"

namespace bead {

enum class ArcStyle : std::uint8_t { prusa, prusa_2017, marlin, klipper };

struct ArcRule {
    ArcStyle style = ArcStyle::prusa;
    double resolution = 1;  // mm, longest chord
};

// Tells the chords in order; the last one ends where the arc does. Nothing for an arc shorter than
// a micrometre.
void each_chord(const Arc& arc, const Position& from, const ArcRule& rule,
                const std::function<void(const Move&)>& tell);

}  // namespace bead
