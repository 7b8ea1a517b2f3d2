// What `beadwork energy` found, for people and for programs, in one mode.
#pragma once
#include <optional>

#include "energy/feature_sums.h"
#include "energy/tariff.h"
#include "energy_mode.h"
#include "job/explained_energy.h"
#include "limits_report.h"

namespace bead::cli {

struct EnergyResult {
    EnergyMode mode = EnergyMode::physics;
    JudgedFile judged;
    FeatureSums features;
    double grid_co2 = 0;  // g per kWh
    std::optional<Tariff> tariff;
    std::optional<Bill> bill;
    double start = 0;  // time of day, s
    std::vector<ExplainedTerm> terms{};
};

// J, of the mode.
double energy_of(const EnergyResult& result);

void print_energy(const Console& console, const EnergyResult& result,
                  const MachineOptions& options);
void print_terms(const Console& console, const EnergyResult& result, const MachineOptions& options);
Json energy_result_json(const EnergyResult& result);
Json terms_json(const EnergyResult& result, const MachineOptions& options);

}  // namespace bead::cli
