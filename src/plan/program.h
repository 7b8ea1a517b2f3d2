// Toolpath to the commands that a machine is given: coordinates rounded to what G-code can say (1
// µm, and 10 nm of filament), filament lengths from beads, retractions, heating before and
// switching off after. Rounding happens here so that what is simulated is to the digit what is
// written.
#pragma once
#include <vector>

#include "toolpath/command.h"

namespace bead {

struct ProgramOptions {
    double filament = 1.75;       // mm, diameter
    double retract_length = 0.8;  // mm
    double retract_speed = 35;    // mm/s
    double z_speed = 12;          // mm/s, layer change
    double highest = 0;           // mm, to which the nozzle may go; 0: not known
    double hotend = 215, hotend_first = 215, bed = 60;  // °C
    double fan = 1;                                     // duty from the second layer on
    SetLimits limits;                                   // written at the top, if it names any
};

// Where the nozzle is between calls.
struct Nozzle {
    Position at{};       // mm, as the machine counts
    double exact_e = 0;  // mm, before rounding
    bool retracted = false;
    double acceleration = 0;  // mm/s², last one asked for; 0: the usual
};

// Limits, heat, home: what comes before the first layer. (The first layer's skirt primes the
// nozzle.)
void append_start(std::vector<Command>& out, Nozzle& nozzle, const ProgramOptions& options);
// The paths of one layer, the first of which starts where the nozzle is; E is set to 0 at its
// start. The fan is off on layer 0 and on from layer 1. Accelerations that paths ask for are
// written only if `options.limits` says what to return to.
void append_layer(std::vector<Command>& out, const Toolpath& layer, double z, double height,
                  int index, Nozzle& nozzle, const ProgramOptions& options);
// Retract, rise clear of the part (10 mm, as far as there is room), switch off.
void append_end(std::vector<Command>& out, Nozzle& nozzle, const ProgramOptions& options);

}  // namespace bead
