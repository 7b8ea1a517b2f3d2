// A calibrated model as a small TOML file: written by `beadwork calibrate -o`, read by whoever
// wants estimates by it.
//
//     model = "physical"
//     acceleration_mm_s2 = 1000
//     error = 0.040                 # of prints it was not shown, mean; left out if not tried
//     [coefficients]                # J per unit of the model's features (mm, s, g …)
//     move = 0.0684
//     hold = 0.8216
//     [standard_errors]
//     …
#pragma once
#include <ostream>
#include <string>

#include "energy/calibrated.h"

namespace bead {

// Reads back to the digit. `note` stands as a comment at the top, one line.
void write_calibrated(std::ostream& out, const CalibratedModel& model, const std::string& note);

// Throws Error with file and line.
CalibratedModel read_calibrated(const std::string& file);

}  // namespace bead
