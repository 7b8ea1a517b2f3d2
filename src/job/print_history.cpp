#include "job/print_history.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>

#include "core/error.h"
#include "job/one_line.h"
#include "job/whole_text.h"

namespace bead {
namespace {

using nlohmann::json;

struct EnergyUnit {
    std::string_view name;
    double joules;  // of one
};
constexpr std::array energy_units{EnergyUnit{"kWh", 3.6e6}, EnergyUnit{"Wh", 3600},
                                  EnergyUnit{"mWh", 3.6}, EnergyUnit{"J", 1},
                                  EnergyUnit{"kJ", 1000}};

std::string text_in(const json& object, const char* key) {
    const auto found = object.find(key);
    return found != object.end() && found->is_string() ? found->get<std::string>() : "";
}

std::optional<double> json_number(const json& object, const char* key) {
    const auto found = object.find(key);
    if (found == object.end() || !found->is_number()) return std::nullopt;
    const double value = found->get<double>();
    if (!(std::abs(value) < 1e15)) return std::nullopt;
    return value;
}

double joules_of(const json& reading) {
    const std::string unit = text_in(reading, "units");
    for (const EnergyUnit& known : energy_units)
        if (known.name == unit) return known.joules;
    return 0;
}

std::string label_of(const json& reading) {
    return fmt::format("{} of {}", text_in(reading, "name"), text_in(reading, "provider"));
}

const json* list_of_jobs(const json& document) {
    const json* inner = &document;
    for (const char* key : {"result", "jobs"})
        if (inner->is_object() && inner->contains(key)) inner = &inner->at(key);
    return inner->is_array() ? inner : nullptr;
}

bool is_asked_for(const json& reading, const std::string& sensor) {
    if (sensor.empty()) return true;
    return text_in(reading, "name") == sensor || text_in(reading, "provider") == sensor ||
           text_in(reading, "provider") == "sensor " + sensor || label_of(reading) == sensor;
}

class HistoryReader {
  public:
    HistoryReader(std::string name, std::string sensor)
        : name_(std::move(name)), sensor_(std::move(sensor)) {}

    void read(const json& job) {
        if (!job.is_object()) return skip("not a job");
        const std::string status = text_in(job, "status");
        if (status != "completed") return skip(status.empty() ? "without a status" : status);
        const auto duration = json_number(job, "print_duration");
        const auto filament = json_number(job, "filament_used");
        if (!duration || *duration <= 0) return skip("without a print_duration above 0");
        if (!filament || *filament < 0) return skip("without filament_used");
        const auto energy = energy_in(job);
        if (!energy) return skip("without a reading in kWh, Wh or J");
        if (*energy <= 0) return skip("whose energy is not above 0");
        history_.jobs.push_back(
            {text_in(job, "job_id"), text_in(job, "filename"), *energy, *duration, *filament});
    }
    PrintHistory finish() {
        if (!history_.jobs.empty()) {
            history_.sensor = *seen_.begin();
            return std::move(history_);
        }
        std::string reasons;
        for (const auto& [reason, count] : history_.skipped)
            reasons += fmt::format("{}{} {}", reasons.empty() ? "" : ", ", count, reason);
        throw Error(fmt::format(
            "{}: no completed job has an energy{}; Moonraker records it if a [sensor] has a "
            "history_field in kWh (docs/calibrate.md)",
            name_, reasons.empty() ? "" : " (" + one_line(reasons) + ")"));
    }

  private:
    void skip(const std::string& reason) { ++history_.skipped[one_line(reason)]; }

    std::optional<double> energy_in(const json& job) {
        const auto readings = job.find("auxiliary_data");
        if (readings == job.end() || !readings->is_array()) return std::nullopt;
        std::optional<double> energy;
        for (const json& reading : *readings) {
            if (!reading.is_object() || joules_of(reading) == 0) continue;
            if (!is_asked_for(reading, sensor_)) continue;
            const auto value = json_number(reading, "value");
            if (!value) continue;
            seen_.insert(one_line(label_of(reading)));
            if (seen_.size() > 1)
                throw Error(
                    fmt::format("{}: several readings are energies: {}; say which with "
                                "--sensor NAME",
                                name_, fmt::join(seen_, ", ")));
            energy = *value * joules_of(reading);
        }
        return energy;
    }

    std::string name_, sensor_;
    std::set<std::string> seen_;
    PrintHistory history_;
};

}  // namespace

PrintHistory parsed_print_history(std::string_view text, const std::string& name,
                                  const std::string& sensor) {
    const json document = json::parse(text, nullptr, false);
    if (document.is_discarded())
        throw Error(name + ": is no valid JSON; save what server/history/list answers");
    const json* const jobs = list_of_jobs(document);
    if (jobs == nullptr)
        throw Error(name + ": has no list of jobs; save what server/history/list answers");
    HistoryReader reader(name, sensor);
    for (const json& job : *jobs) reader.read(job);
    return reader.finish();
}

PrintHistory read_print_history(const std::string& file, const std::string& sensor) {
    return parsed_print_history(whole_text(file), file, sensor);
}

}  // namespace bead
