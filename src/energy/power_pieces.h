// Energy over time, told by a meter piece by piece: pieces follow each other without a gap, waits
// for heaters included, and none goes beyond a place in time that whoever listens asks to be told
// apart (the end of a step of a power curve, a change of tariff).
#pragma once
#include <functional>

#include "energy/energy.h"

namespace bead {

struct PowerPiece {
    double time = 0;       // s, its beginning; 0 is the print's
    double duration = 0;   // s
    bool heating = false;  // while a heater is waited for
    Energy energy;         // J
};

struct PowerListener {
    std::function<double(double time)> next_cut;  // s, after `time`
    std::function<void(const PowerPiece&)> hear;
};

}  // namespace bead
