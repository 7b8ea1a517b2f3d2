// The ten prints that the published model was fitted to (Somade 2023, Table 3).
#pragma once
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "energy/observation.h"

namespace bead::test {

inline std::vector<Observation> table3() {
    std::ifstream file(BEAD_SOURCE_DIR "/tests/data/somade2023/table3_calibration.csv");
    std::string line, cell;
    std::getline(file, line);
    std::vector<Observation> prints;
    while (std::getline(file, line)) {
        std::stringstream stream(line);
        std::vector<std::string> cells;
        while (std::getline(stream, cell, ',')) cells.push_back(cell);
        Observation seen{.name = cells[0] + ' ' + cells[1] + ' ' + cells[2], .group = cells[0]};
        seen.features = Features{std::stod(cells[3]), std::stod(cells[4]), std::stod(cells[5]),
                                 std::stod(cells[6]), 0};
        seen.energy = std::stod(cells[7]) * 1e-3;
        prints.push_back(seen);
    }
    EXPECT_EQ(prints.size(), 10U);
    return prints;
}

}  // namespace bead::test
