#include "study/angle_scan.h"

#include <cmath>

#include "core/parallel.h"

namespace bead {

ModelEnergies model_energies(const ExperimentSetup& setup, const Machine& machine) {
    const Print print = experiment_print(outline_of(Shape::square), setup);
    const Assessment cost = judged(print, experiment_machine(machine));
    return {published_energy(cost.features), standing_form(cost.features), cost.energy.xy_motors,
            total(cost.energy.energy) - cost.energy.heat_up, cost.motion.duration};
}

std::vector<ModelEnergies> angle_scan(const Machine& machine, int threads) {
    std::vector<ModelEnergies> points(91);
    parallel_for(points.size(), threads, [&](std::size_t degrees) {
        const double angle = static_cast<double>(degrees) * pi / 180;
        points[degrees] = model_energies({patterns[0], angle}, machine);
    });
    return points;
}

std::vector<SpeedPoint> speed_scan(std::span<const double> speeds, const Machine& machine,
                                   int threads) {
    std::vector<SpeedPoint> points(speeds.size());
    parallel_for(points.size(), threads, [&](std::size_t i) {
        const double speed = speeds[i];
        points[i] = {speed, model_energies({patterns[0], 0, 0, speed}, machine),
                     model_energies({patterns[0], pi / 4, 0, speed}, machine)};
    });
    return points;
}

double break_even_speed(const MotorCoefficients& k) { return k.h / (k.c * (std::sqrt(2.0) - 1)); }

}  // namespace bead
