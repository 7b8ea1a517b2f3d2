#include "energy/report.h"

namespace bead {

double total(const MotorTerms& t) { return t.standing + t.resting + t.speed + t.work; }

double total(const HeatTerms& t) { return t.stored + t.lost + t.blown + t.warming + t.melting; }

double total(const EnergyTerms& t) {
    double sum = total(t.hotend) + total(t.bed) + t.part_fan + t.hotend_fan + t.electronics;
    for (const MotorTerms& motor : t.motors) sum += total(motor);
    return sum + t.supply;
}

}  // namespace bead
