// A path, a machine and a time law to how the machine shakes: the whole of docs/vibration.md in one
// call. Path and law are given apart, so that what a better path gains is never confused with what
// a better law gains.
//
//     const Response response = assess(layer, {model, material}, named_laws[1].law);
#pragma once
#include "machine/material.h"
#include "machine/vibration.h"
#include "toolpath/path.h"
#include "vibration/response.h"
#include "vibration/time_law.h"

namespace bead {

struct ShakenMachine {
    VibrationModel model{};
    Material material{};
};

struct AssessOptions {
    double step = 0.0005;       // s, of the simulation; 1/step must be a multiple of 200 Hz
    double travel_speed = 120;  // mm/s, across gaps that the toolpath leaves
};

// From rest to rest. The z of points is not looked at: it may be a layer or several in a row.
// Expects a path with some length.
Response assess(const Toolpath& path, const ShakenMachine& machine, const TimeLaw& law,
                const AssessOptions& options = {});

}  // namespace bead
