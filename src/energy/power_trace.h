// A power meter's log and the print in it: where the print begins and ends, how the log's clock
// goes against the simulation's, what was drawn, and how much of the time nobody recorded. Nothing
// is filled in: energy is that of recorded stretches, and the rest is said to be unknown.
//
//     const FoundPrint print = find_print(trace, simulated_seconds);
//     const Metered whole = metered(trace, print.from, print.to);
#pragma once
#include <cstddef>
#include <vector>

namespace bead {

struct PowerSample {
    double time = 0;  // s, by the log's clock
    double watts = 0;
};

struct PowerTrace {
    std::vector<PowerSample> samples;  // at least two, times do not fall, watts not negative
    double usual_interval = 0;         // s, the median; above 0
};

// Sets the interval. Expects samples as above, not all at one time.
PowerTrace power_trace(std::vector<PowerSample> samples);

// Longer than three usual ones.
bool is_gap(const PowerTrace& trace, double interval);

struct Gap {
    double from = 0, to = 0;  // s
};

struct Metered {
    double energy = 0;      // J, straight lines between samples, of recorded time alone
    double recorded = 0;    // s
    std::vector<Gap> gaps;  // as far as they are within
};

// Between two times; what lies outside of the log counts as a gap.
Metered metered(const PowerTrace& trace, double from, double to);

struct FoundPrint {
    double from = 0, to = 0;                  // s
    double standby = 0, threshold = 0;        // W; the print is above the threshold
    double scale = 1;                         // its length / that of the simulation
    std::size_t others = 0;                   // further stretches above the threshold
    bool cut_begin = false, cut_end = false;  // the log starts or ends above it
};

// A print is a stretch above standby, dips shorter than two minutes included. Standby is what the
// log is at or below for a twentieth of its samples, the threshold a seventh of the way from there
// to the most. Of several stretches it is the one nearest in length to the `expected` seconds.
// Throws Error if power never rises.
FoundPrint find_print(const PowerTrace& trace, double expected);

}  // namespace bead
