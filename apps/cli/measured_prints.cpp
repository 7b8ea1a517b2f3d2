#include "measured_prints.h"

#include <filesystem>
#include <fstream>

#include "core/error.h"
#include "gcode_file.h"
#include "job/observations.h"
#include "job/print_history.h"
#include "part.h"

namespace bead::cli {
namespace {

// What a simulation tells of a print; what was measured stays as it is.
void simulate_into(Observation& seen, const std::string& gcode, const MachineOptions& options,
                   const Machine& machine, const Console& console) {
    const Assessment cost = [&] {
        try {
            return judge_file(gcode, options, console, Judging::motion_and_energy).cost;
        } catch (const Error& error) {
            throw Error(seen.name + ": " + error.what(), error.fault());
        }
    }();
    seen.features = cost.features;
    seen.modelled = total(cost.energy.energy);
    if (!seen.duration) seen.duration = cost.motion.duration;
    if (!seen.filament) seen.filament = grams(cost.motion.filament, machine);
}

MeasuredPrints from_table(const MeasuredOptions& options, const Console& console) {
    ObservationTable table = read_observations(options.file);
    MeasuredPrints result;
    result.kind = table.kind;
    result.inputs = {options.file};
    const Machine machine = machine_of(options.machine);
    for (ObservedPrint& print : table.prints) {
        if (table.of_files)
            simulate_into(print.seen, print.gcode, options.machine, machine, console);
        result.prints.push_back(std::move(print.seen));
    }
    result.of_machine =
        options.scope.empty() ? !result.prints.front().features : options.scope == "machine";
    return result;
}

std::string label_of(const PrintedJob& job) {
    return job.id.empty() ? job.file : fmt::format("job {} ({})", job.id, job.file);
}

MeasuredPrints from_history(const MeasuredOptions& options, const Console& console) {
    const PrintHistory history = read_print_history(options.file, options.sensor);
    MeasuredPrints result;
    result.of_machine = true;
    result.kind = "Moonraker's job history, energy by " + history.sensor;
    result.inputs = {options.file};
    const Machine machine = machine_of(options.machine);
    std::size_t found = 0;
    for (const PrintedJob& job : history.jobs) {
        Observation seen{.name = label_of(job), .group = job.file, .energy = job.energy};
        seen.duration = job.duration;
        seen.filament = grams(job.filament, machine);
        seen.heat_ups = 1;
        const auto gcode = std::filesystem::path(options.gcode_folder) / job.file;
        if (!options.gcode_folder.empty() && std::filesystem::is_regular_file(gcode)) {
            simulate_into(seen, gcode.string(), options.machine, machine, console);
            ++found;
        }
        result.prints.push_back(std::move(seen));
    }
    Json skipped = Json::object();
    for (const auto& [reason, count] : history.skipped) {
        skipped[reason] = count;
        result.notes.push_back(
            fmt::format("left out: {} job{} {}", count, count == 1 ? "" : "s", reason));
    }
    if (!options.gcode_folder.empty())
        result.notes.push_back(fmt::format("G-code found for {} of {} jobs in {}", found,
                                           history.jobs.size(), options.gcode_folder));
    result.details = {{"sensor", history.sensor}, {"skipped", skipped}, {"gcode_found", found}};
    return result;
}

bool starts_as_json(const std::string& file) {
    std::ifstream stream(file, std::ios::binary);
    char first = 0;
    stream >> first;
    return first == '{' || first == '[';
}

}  // namespace

MeasuredPrints measured_prints(const MeasuredOptions& options, const Console& console) {
    if (!options.power_log.empty()) return logged_print(options, console);
    if (!starts_as_json(options.file)) return from_table(options, console);
    if (options.scope == "motors")
        throw Error(options.file +
                        ": a history has the energy of whole machines; leave --scope "
                        "motors away",
                    Fault::usage);
    return from_history(options, console);
}

}  // namespace bead::cli
