// The plots of `replay`.
#pragma once
#include <string>

#include "replay_report.h"

namespace bead::cli {

// Ours over published, coloured by shape; suspect rows hollow.
std::string scatter_picture(const Replay& replay);

// Energy by the angle of the infill, in per cent of that at 0°, by each model.
std::string angle_picture(const std::vector<ModelEnergies>& points);
void write_angles(std::ostream& out, const std::vector<ModelEnergies>& points);  // .csv

}  // namespace bead::cli
