// What Klipper's TEST_RESONANCES writes: freq,psd_x,psd_y,psd_z,psd_xyz and more columns that are
// not looked at. The axis' own column counts.
//
//     const DriveMode x = resonance_of("calibration_data_x.csv", 0);
#pragma once
#include <cstddef>
#include <string>

#include "vibration/drive.h"

namespace bead {

// The mode of X (0) or Y (1). Throws Error if the file is no such table, or has no peak that a mode
// could have made, between 5 Hz and the highest mode that can be looked at.
DriveMode resonance_of(const std::string& file, std::size_t axis);

}  // namespace bead
