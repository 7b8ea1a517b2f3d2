// Models of a print's energy that are linear in their coefficients and can therefore be fitted to
// measured prints. Energies in J here; each column knows the unit in which people read it.
//
// Of the X and Y motors, with A, B, C, H as in energy/published.h:
//     published   kA A + kB B + kC C + kH H            Eq. 28 of Somade (2023)
//     pooled      kA (A + B) + kC C + kH H             the axes alike
//     physical    k (C + 2 (A + B) / a) + kH H         a stepper is paid by time under way
//     time        P t_move + kH H                      the same where durations are known
// (A + B) / a is the way of the axes in ramps, a the acceleration of the prints. A ramp from near
// rest to v takes 2 / v per mm where coasting takes 1 / v, hence the 2; nothing but k and kH is
// fitted. t_move is the time of X plus that of Y in which the axis moves.
//
// Of the whole machine, at the wall:
//     machine     P duration + Q heat-ups + q grams    what a plug's meter can tell apart
//     running     P duration + q grams                 the same, heating up left aside
//     scaled      f × EnergyMeter's estimate           1 if its parameters are right
#pragma once
#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "energy/observation.h"
#include "numeric/least_squares.h"

namespace bead {

enum class EnergyModel { published, pooled, physical, time, machine, running, scaled };
inline constexpr std::array<std::string_view, 7> energy_model_names{
    "published", "pooled", "physical", "time", "machine", "running", "scaled"};
constexpr std::string_view name_of(EnergyModel model) {
    return energy_model_names[std::size_t(model)];
}

// Whether the model is of the X and Y motors alone.
constexpr bool is_of_motors(EnergyModel model) { return model < EnergyModel::machine; }

struct ModelColumn {
    std::string_view name;       // of the coefficient, for programs: "A", "hold"
    std::string_view about;      // of what it multiplies, for people
    std::string_view unit;       // of the coefficient as people read it
    double per_joule;            // that unit's numbers per one of J
    std::string_view varied_by;  // prints that have much of it, for advice
};
std::span<const ModelColumn> columns_of(EnergyModel model);

struct ModelOptions {
    double acceleration = 1000;  // mm/s², at which the prints were made
};

// What the model needs and the observation lacks, as a column of a table: "duration_s"; "" if it
// has all.
std::string_view lacking(EnergyModel model, const Observation& observation);

// One value per coefficient. Expects that nothing is lacking.
Row row_of(EnergyModel model, const Observation& observation, const ModelOptions& options);

}  // namespace bead
