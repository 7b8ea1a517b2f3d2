// How a file writes its motion: what whoever writes motion of his own into it keeps to.
#pragma once
#include <map>
#include <string>

#include "toolpath/path.h"

namespace bead {

struct MotionStyle {
    double filament = 1.75;  // mm, diameter
    bool absolute_e = true;
    // Retraction, as the file last did it.
    bool by_firmware = false;                      // G10, G11
    double retract_length = 0;                     // mm; 0: it never does
    double retract_speed = 35, return_speed = 35;  // mm/s
    double lift = 0, z_speed = 12;                 // mm, mm/s
    // Comments, each a line with its end; empty where the file has none.
    PerRole<std::string> role_lines{};
    std::string width_tag, height_tag;       // ";WIDTH:"
    std::map<double, std::string> limits{};  // lines that ask for an acceleration (mm/s²)
};

}  // namespace bead
