// What a motion does to the machine and to the print. Vibration counts over the whole motion,
// deviation and contour error only while filament is laid down.
#pragma once
#include <vector>

namespace bead {

struct Deviation {  // mm between where the nozzle should be and where it is, lag included
    double min = 0, mean = 0, max = 0;
};

struct ContourError {  // mm from the nozzle to the nearest point of the path about its command
    double mean = 0, p99 = 0, max = 0;
};

struct DriveEnergy {    // J
    double servo = 0;   // mechanical work of both motors, friction included; none is won back
    double copper = 0;  // heat of their windings
    double melt = 0;    // melting what is laid down
    double base = 0;    // what the machine draws anyway, times the time
};
constexpr double total(const DriveEnergy& e) { return e.servo + e.copper + e.melt + e.base; }

struct Spectrum {                 // one-sided density of acceleration, X and Y added
    double step = 0;              // Hz
    std::vector<double> density;  // (mm/s²)²/Hz, at 0, step, 2 step, …
};

struct Response {
    double time = 0;              // s
    double rms_acceleration = 0;  // mm/s², of the nozzle, both axes
    double rms_5_40hz = 0;        // mm/s², of that the part between 5 and 40 Hz
    double psd_top3 = 0;          // (mm/s²)²/Hz, mean of the three highest values in the band
    double peak_frequency = 0;    // Hz, of the highest
    Deviation deviation;
    ContourError contour;
    DriveEnergy energy;
    double co2 = 0;       // g, of the energy and the material
    double volume = 0;    // mm³ laid down
    double material = 0;  // g
    double printing = 0;  // s of the time
    double off_nominal =
        0;  // part of the printing time with speed more than 5 % off what was asked
    Spectrum spectrum;
};

}  // namespace bead
