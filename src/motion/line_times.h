// How long a print has run when all before a given line of its file is done. Told the commands as
// they are planned and the events as they happen, in any interleaving; memory is bounded by the
// lines asked for.
//
//     LineTimes times({10, 25});
//     Judge judge(machine, [&](const MotionEvent& event) { times.add(event); });
//     read_gcode(file, [&](const Command& command) { times.add(command); judge.add(command); });
//     const std::vector<double> seconds = times.finish();
#pragma once
#include <cstdint>
#include <deque>
#include <vector>

#include "motion/block.h"

namespace bead {

class LineTimes {
  public:
    explicit LineTimes(std::vector<std::int64_t> lines);  // in ascending order

    void add(const Command& command);  // before its event
    void add(const MotionEvent& event);
    // s, one for each line; a line that was not reached has the whole time.
    std::vector<double> finish();

  private:
    void pass(std::int64_t line, double duration);

    std::vector<std::int64_t> lines_;
    std::vector<double> times_;
    std::deque<std::int64_t> dwells_;  // lines of those that have not happened yet
    double elapsed_ = 0;
};

}  // namespace bead
