// What a print on a machine of two drives takes: work and heat of the motors, sample by sample;
// heat of the melt, and what the machine draws anyway; carbon dioxide of all that and of the
// material.
#pragma once
#include "vibration/assess.h"
#include "vibration/drive_motion.h"

namespace bead {

// One axis for `step` s. Nothing flows back: a motor that brakes costs nothing.
void add_work(DriveEnergy& energy, const DriveAxis& axis, const DriveSample& sample, double step);

// Melt, base, CO2 and mass of a response whose time, volume and motors' energy are known:
//     m_CO2 = f_e·E/3.6e6 + f_m·m
void add_other_energy(Response& response, const ShakenMachine& machine);

}  // namespace bead
