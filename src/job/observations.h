// Tables of measured prints, one a row, told apart by their header (order of columns free, case of
// letters and columns not named here ignored):
//
//     a_mm2_per_s2,b_mm2_per_s2,c_mm,h_s,energy_mj[,group]    features as simulated or published
//     gcode,energy_mj[,group]                                 files, beside the table or by path
//
//     duration_s,filament_g,energy_wh[,heat_ups][,group]      of whole machines
//
// The energy's column may be energy_mj, energy_mws (the same), energy_j, energy_wh or energy_kwh;
// the group's group, geometry or shape. duration_s, of printing, filament_g and heat_ups may also
// stand beside features.
#pragma once
#include <string>
#include <vector>

#include "energy/observation.h"

namespace bead {

struct ObservedPrint {
    Observation seen;   // of a file: energy and group, until it is simulated
    std::string gcode;  // path; "" where the table has features
};

struct ObservationTable {
    bool of_files = false;
    std::string kind;  // for people: which table it was taken for, by which columns
    std::vector<ObservedPrint> prints;
};

// Throws Error with file and line: a column that is missing, a cell that is empty or no number, an
// energy that is not above 0, a feature below 0, times that contradict each other, no rows.
ObservationTable read_observations(const std::string& file);
// `name` is what messages call the text; paths are relative to its folder.
ObservationTable parsed_observations(std::string_view text, const std::string& name);

}  // namespace bead
