// The history of print jobs that Moonraker keeps: what `server/history/list` answers, as JSON. Its
// jobs carry a meter's reading if a [sensor] has a `history_field` in Wh or kWh, counted per job
// (strategy delta).
#pragma once
#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace bead {

struct PrintedJob {
    std::string id;
    std::string file;     // as Moonraker calls it, below its folder of G-code
    double energy = 0;    // J, above 0
    double duration = 0;  // s, of printing: from the first extrusion on, pauses not counted
    double filament = 0;  // mm
};

struct PrintHistory {
    std::vector<PrintedJob> jobs;  // completed, in the order of the file
    std::string sensor;            // whose reading was taken, "power_consumption of sensor plug"
    // Those left out, by the reason: "cancelled" -> 3.
    std::map<std::string, std::size_t> skipped;
};

// `sensor` names the reading (or its provider) where jobs have several; "" if they have one. Throws
// Error: no JSON, no list of jobs, no completed job with an energy, several readings and no name.
PrintHistory read_print_history(const std::string& file, const std::string& sensor = "");
PrintHistory parsed_print_history(std::string_view text, const std::string& name,
                                  const std::string& sensor = "");

}  // namespace bead
