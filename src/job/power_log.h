// A log of a power meter: two columns, time and watts, with or without a header. Time is in seconds
// (of any zero) or ISO 8601: 2026-03-01T12:00:00Z, with a space for the T, fractions of a second
// and an offset from UTC if you like. Rows whose power is empty, "unavailable", "unknown" or "nan",
// as home automation writes them, are counted and leave a gap.
#pragma once
#include <cstddef>
#include <string>

#include "energy/power_trace.h"

namespace bead {

struct PowerLog {
    PowerTrace trace;
    std::size_t missing = 0;  // rows without power
};

// Throws Error with file and line: what is no time or no power, power below 0 or above 100 kW, a
// clock that was set back, fewer than ten samples.
PowerLog read_power_log(const std::string& file);
PowerLog parsed_power_log(std::string_view text, const std::string& name);

}  // namespace bead
