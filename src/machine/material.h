// What is printed: temperatures to print it at, and what it takes to weigh and to melt it.
#pragma once

namespace bead {

struct Material {
    double density = 1.24;       // g/cm³
    double hotend = 215;         // °C
    double hotend_first = 215;   // °C, first layer
    double bed = 60;             // °C
    double heat_capacity = 1.9;  // J/(g K), mean from ambient to melt
    double latent = 0;           // J/g
};

}  // namespace bead
