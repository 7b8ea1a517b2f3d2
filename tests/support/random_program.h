// Random but sensible command streams for laws about motion: short and long moves, corners of every
// angle, extrusion, travel, retractions, layer changes; the same for the same seed.
#pragma once
#include <cmath>
#include <random>
#include <vector>

#include "toolpath/command.h"

namespace bead::test {

struct ProgramShape {
    int moves = 400;
    double shortest = 0.05, longest = 40;  // mm
    double odd_share = 0.1;                // of moves that are retractions or layer changes
    bool drains = true;
};

inline std::vector<Command> random_program(unsigned seed, const ProgramShape& shape = {}) {
    std::mt19937_64 random(seed);
    const auto uniform = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    const auto rounded = [](double mm) { return std::round(mm * 1e3) / 1e3; };
    std::vector<Command> program;
    Position at{100, 100, 0.2, 0};
    double feed = 60;
    for (int i = 0; i < shape.moves; ++i) {
        const double kind = uniform(0, 1);
        if (uniform(0, 1) < 0.2) feed = uniform(2, 250);
        if (kind < shape.odd_share / 2) {
            at[axis_e] += uniform(0, 1) < 0.5 ? -0.8 : 0.8;
        } else if (kind < shape.odd_share) {
            at[axis_z] = rounded(at[axis_z] + 0.2);
        } else {
            const double span =
                shape.shortest * std::pow(shape.longest / shape.shortest, uniform(0, 1));
            const double angle = uniform(0, 2 * pi);
            at[axis_x] = rounded(at[axis_x] + span * std::cos(angle));
            at[axis_y] = rounded(at[axis_y] + span * std::sin(angle));
            if (uniform(0, 1) < 0.7) at[axis_e] += 0.033 * span;
        }
        program.push_back({Move{at, feed, Role::infill, {}}, i + 1});
        if (shape.drains && uniform(0, 1) < 0.01) program.push_back({Drain{}, i + 1});
    }
    return program;
}

}  // namespace bead::test
