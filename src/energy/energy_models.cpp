#include "energy/energy_models.h"

#include "core/expects.h"

namespace bead {
namespace {

constexpr ModelColumn along_x{
    "A", "speed changes along X", "mJ/(mm/s)²", 1e3,
    "short lines along X: a narrow part, or infill at 0 degrees in a part narrow in X"};
constexpr ModelColumn along_y{"B", "speed changes along Y", "mJ/(mm/s)²", 1e3,
                              "short lines along Y: a part narrow in Y with infill at 90 degrees"};
constexpr ModelColumn along_both{"AB", "speed changes along X and Y", "mJ/(mm/s)²", 1e3,
                                 "many short lines: a small part or a dense curved pattern"};
constexpr ModelColumn coasting{"C", "way at constant speed", "mJ/mm", 1e3,
                               "long straight lines: a large part with rectilinear infill"};
constexpr ModelColumn holding{"H", "time in which an axis stands", "mW", 1e3,
                              "lines along one axis only: infill at 0 or 90 degrees"};
constexpr ModelColumn standing{"hold", holding.about, holding.unit, holding.per_joule,
                               holding.varied_by};
constexpr ModelColumn moving_way{"move", "way, ramps counted twice", "mJ/mm", 1e3,
                                 "lines in which both axes move: infill at 45 degrees"};
constexpr ModelColumn moving_time{"move", "time in which an axis moves", "mW", 1e3,
                                  "lines in which both axes move: infill at 45 degrees"};
constexpr ModelColumn base{"base", "printing time", "W", 1,
                           "a long print with little filament: slow, or mostly travel"};
constexpr ModelColumn heat_up{"heat_up", "heating up from cold", "J", 1,
                              "short prints, for which heating up is most of the energy"};
constexpr ModelColumn melting{"filament", "filament", "J/g", 1,
                              "a fast print of much filament: thick layers, full density"};
constexpr ModelColumn factor{"factor", "the physics model's estimate", "1", 1,
                             "any print whose file sets temperatures"};

constexpr std::array published_columns{along_x, along_y, coasting, holding};
constexpr std::array pooled_columns{along_both, coasting, holding};
constexpr std::array physical_columns{moving_way, standing};
constexpr std::array time_columns{moving_time, standing};
constexpr std::array machine_columns{base, heat_up, melting};
constexpr std::array running_columns{base, melting};
constexpr std::array scaled_columns{factor};

}  // namespace

std::span<const ModelColumn> columns_of(EnergyModel model) {
    switch (model) {
        case EnergyModel::published:
            return published_columns;
        case EnergyModel::pooled:
            return pooled_columns;
        case EnergyModel::physical:
            return physical_columns;
        case EnergyModel::time:
            return time_columns;
        case EnergyModel::machine:
            return machine_columns;
        case EnergyModel::running:
            return running_columns;
        case EnergyModel::scaled:
            return scaled_columns;
    }
    return {};
}

std::string_view lacking(EnergyModel model, const Observation& seen) {
    if (model == EnergyModel::scaled) return seen.modelled ? "" : "gcode";
    if (!is_of_motors(model)) {
        if (!seen.duration) return "duration_s";
        return seen.filament ? "" : "filament_g";
    }
    if (!seen.features) return "a_mm2_per_s2";
    return model != EnergyModel::time || seen.duration ? "" : "duration_s";
}

Row row_of(EnergyModel model, const Observation& seen, const ModelOptions& options) {
    BEAD_EXPECTS(lacking(model, seen).empty() && options.acceleration > 0);
    const Features f = seen.features.value_or(Features{});
    switch (model) {
        case EnergyModel::published:
            return {f.A, f.B, f.C, f.H};
        case EnergyModel::pooled:
            return {f.A + f.B, f.C, f.H};
        case EnergyModel::physical:
            return {f.C + 2 * (f.A + f.B) / options.acceleration, f.H};
        case EnergyModel::time:
            return {f.axis_time - f.H, f.H};
        case EnergyModel::machine:
            return {*seen.duration, seen.heat_ups.value_or(1), *seen.filament};
        case EnergyModel::running:
            return {*seen.duration, *seen.filament};
        case EnergyModel::scaled:
            return {*seen.modelled};
    }
    return {};
}

}  // namespace bead
