// Between two lines of a G-code file: where the machine is and how the next line will be read.
#pragma once
#include "toolpath/command.h"

namespace bead {

struct FileState {
    Position place{};           // mm, as the file counts
    double feed = 0;            // mm/s, of moves that name none
    double unit = 1;            // mm per unit of the text
    bool absolute_e = true;     // M82
    bool relative_xyz = false;  // G91
    bool renamed_xy = false;    // X and Y of commands count from elsewhere
    bool pulled_back = false;   // by the firmware, G10
    bool operator==(const FileState&) const = default;
};

}  // namespace bead
