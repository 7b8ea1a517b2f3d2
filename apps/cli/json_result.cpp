#include "json_result.h"

#include <iostream>

#include "core/error.h"
#include "core/output_file.h"
#include "energy/interval.h"

namespace bead::cli {
namespace {

constexpr int schema_version = 1;

Json axis_json(const AxisTimes& axis) {
    return {{"accelerate_s", axis.accelerate},
            {"coast_s", axis.coast},
            {"decelerate_s", axis.decelerate},
            {"hold_s", axis.hold},
            {"distance_mm", axis.distance}};
}

Json by_role_json(const PerRole<double>& values) {
    Json json = Json::object();
    for (std::size_t i = 0; i < values.size(); ++i)
        if (values[i] != 0) json[std::string(role_names[i])] = values[i];
    return json;
}

}  // namespace

Json result_head(const std::string& command, const std::vector<std::string>& inputs) {
    return {{"schema_version", schema_version},
            {"program_version", BEAD_VERSION},
            {"command", command},
            {"inputs", inputs}};
}

void write_result(const std::string& place, const Json& result) {
    if (place.empty()) return;
    const std::string text = result.dump(2) + "\n";
    if (place != "-") {
        OutputFile file(place);
        file.stream() << text;
        file.keep();
        return;
    }
    std::cout << text << std::flush;
    if (!std::cout) throw Error("standard output could not be written to", Fault::other);
}

Json motion_json(const Assessment& cost) {
    const MotionTotals& m = cost.motion;
    return {{"time_s", m.duration},
            {"dwell_s", m.dwell},
            {"moves", m.moves},
            {"length_mm", m.length},
            {"extruded_mm", m.extruded},
            {"filament_mm", m.filament},
            {"travel_mm", m.travel},
            {"travel_moves", m.travel_moves},
            {"retractions", m.retractions},
            {"top_speed_mm_s", m.fastest},
            {"moves_short_of_speed", m.short_of_speed},
            {"time_by_role_s", by_role_json(m.by_role)},
            {"axes",
             {{"x", axis_json(m.axes[axis_x])},
              {"y", axis_json(m.axes[axis_y])},
              {"z", axis_json(m.axes[axis_z])},
              {"e", axis_json(m.axes[axis_e])}}},
            {"features",
             {{"A", cost.features.A},
              {"B", cost.features.B},
              {"C", cost.features.C},
              {"H", cost.features.H}}}};
}

Json energy_json(const Assessment& cost, const PowerModel& power) {
    const EnergyReport& report = cost.energy;
    const Interval interval = interval_95(report.energy, power);
    Json layers = Json::array();
    for (const LayerEnergy& layer : report.by_layer)
        layers.push_back(
            {{"z_mm", layer.z}, {"time_s", layer.duration}, {"energy_j", layer.total}});
    return {{"xy_motor_energy_j", published_energy(cost.features)},
            {"xy_motor_energy_standing_j", standing_form(cost.features)},
            {"machine_energy_j", total(report.energy)},
            {"interval_95", {interval.low, interval.high}},
            {"consumers",
             {{"bed_j", report.energy.bed},
              {"hotend_j", report.energy.hotend},
              {"motors_j", report.energy.motors},
              {"fans_j", report.energy.fans},
              {"electronics_j", report.energy.electronics}}},
            {"heat_up_j", report.heat_up},
            {"heat_up_s", report.heat_up_duration},
            {"print_s", report.duration},
            {"peak_power_w", report.peak_power},
            {"co2_g", report.co2},
            {"by_role", by_role_json(report.by_role)},
            {"by_layer", layers}};
}

}  // namespace bead::cli
