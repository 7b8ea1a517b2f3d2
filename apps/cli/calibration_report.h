// What `beadwork calibrate` found, for people and for programs.
#pragma once
#include "console.h"
#include "energy/calibrate.h"
#include "json_result.h"
#include "measured_prints.h"

namespace bead::cli {

// The fit at `chosen` in full, the others in a row each.
void print_calibration(const Console& console, const Calibration& found, std::size_t chosen,
                       const std::vector<Observation>& prints);
Json calibration_json(const Calibration& found, std::size_t chosen, const MeasuredPrints& measured);

// "physical (non-negative) tells best …"; which generalises and by how much, in words.
std::string verdict(const Calibration& found);

}  // namespace bead::cli
