// The changes that make a G-code file tell given times: progress and minutes left in its M73 lines,
// the estimates in its comments, a signature in its head. Applied to their own result they change
// nothing.
//
// Where Bambu's header says how long the printer prepares itself (probing, heating: what no planner
// of moves knows), that time is kept: the clock runs by the slicer's until the start code ends, by
// ours from there.
#pragma once
#include <span>

#include "gcode/edits.h"
#include "gcode/time_marks.h"

namespace bead {

struct PrintTimes {
    double total = 0;          // s
    std::vector<double> at{};  // s, from the start, when what stands before each mark is done
};

// The whole time that the file will tell, with the slicer's own for preparation.
double told_total(const TimeMarks& found, const PrintTimes& times);

// Only lines that change. `signature` are lines without their ends, the first one beginning with
// signature_start, any others with remark_start.
std::vector<Edit> time_edits(const TimeMarks& found, const PrintTimes& times,
                             std::span<const std::string> signature);

}  // namespace bead
