// One measured print: what moved in it and what it drew. What was not recorded stays empty; which
// models can be fitted follows from what all prints have (energy/energy_models.h).
#pragma once
#include <optional>
#include <string>

#include "energy/published.h"

namespace bead {

struct Observation {
    std::string name{};                  // for people: "prints.csv:7", "job 00001A"
    std::string group{};                 // prints that are alike in shape or file; "" if unknown
    double energy = 0;                   // J, measured, above 0
    std::optional<Features> features{};  // axis_time counts only where duration is there
    std::optional<double> duration{};    // s, of printing: no heating up, no dwells
    std::optional<double> heat_ups{};    // from cold; a part of one for a part of a print
    std::optional<double> filament{};    // g
    std::optional<double> modelled{};    // J at the wall, by EnergyMeter
};

}  // namespace bead
