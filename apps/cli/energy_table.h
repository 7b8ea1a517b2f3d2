// Energy by consumer as a table for people, alone or beside another.
#pragma once
#include "console.h"
#include "energy/meter.h"

namespace bead::cli {

void print_consumers(const Console& console, const Energy& energy);
// By feature: joules, and of them the consumers.
void print_features(const Console& console, const EnergyReport& report);
void print_comparison(const Console& console, const Energy& before, const Energy& after);

}  // namespace bead::cli
