// What a meter found: joules by consumer, by role, by layer, and by term of the physics model.
#pragma once
#include <vector>

#include "energy/energy.h"
#include "toolpath/command.h"

namespace bead {

// All that is done from one LayerStart to the next, waits for a heater not included.
struct LayerEnergy {
    double z = 0;         // mm, top of the layer
    double duration = 0;  // s
    double total = 0;     // J
    PerRole<Energy> by_role{};
};

// Of one motor, in J before the supply.
struct MotorTerms {
    double standing = 0;  // with the run current, all the time
    double resting = 0;   // of it what the hold current saves at rest; not above 0
    double speed = 0;     // in proportion to the speed
    double work = 0;      // against friction and inertia
};

// Of one heater, in J before the supply; what the fan and the plastic take is the hot end's only.
struct HeatTerms {
    double stored = 0;   // in the body at the end
    double lost = 0;     // to still air
    double blown = 0;    // more than that, by the part fan
    double warming = 0;  // of the plastic
    double melting = 0;  // its latent heat
};

// What the energy is made of: low-voltage J of each term of the model, and what the supply loses.
// All together they are the total.
struct EnergyTerms {
    PerAxis<MotorTerms> motors{};
    HeatTerms hotend, bed;
    double part_fan = 0, hotend_fan = 0, electronics = 0, supply = 0;
};
double total(const MotorTerms& terms);
double total(const HeatTerms& terms);
double total(const EnergyTerms& terms);

// Nothing is lost and nothing counted twice:
//     total(energy) = sum of by_role = heat_up + before_layers + sum of by_layer = total(terms)
struct EnergyReport {
    Energy energy;                // heat-up included
    double heat_up = 0;           // J, of it while waiting for a heater
    double heat_up_duration = 0;  // s
    double before_layers = 0;     // J, of it before the first layer, waits apart
    double duration = 0;          // s, of all but the waits
    double xy_motors = 0;         // J, of it the motors that move X and Y, standing included
    double peak_power = 0;        // W, at the wall, pulses of heaters averaged out
    double peak_time = 0;         // s, when the command begins at which it is drawn; waits count
    double co2 = 0;               // g
    std::vector<LayerEnergy> by_layer;
    PerRole<double> by_role{};  // J; waits and dwells are Role::other
    PerRole<Energy> consumers_by_role{};
    Energy heat_up_consumers;
    EnergyTerms terms;
};

}  // namespace bead
