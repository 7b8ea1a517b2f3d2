// The layers that a G-code file lays for a case's part, moved to where the case draws it.
#pragma once
#include <CLI/CLI.hpp>

#include <string>

#include "console.h"
#include "fem/load_case.h"
#include "study/bed_place.h"

namespace bead::cli {

// What is said of files that are to be tested.
struct PrintedFileOptions {
    double filament = 0;         // mm, diameter; 0: as the file says, else 1.75
    std::optional<double> turn;  // degrees
    std::vector<double> origin;  // x and y
};
void declare(CLI::App& command, PrintedFileOptions& options);

struct PrintedFile {
    std::vector<Toolpath> layers;  // of the part alone, in the case's frame, once sintered
    BedPlace place;
    std::vector<std::string> warnings;
};

// Throws Error if nothing is laid, or it is not the case's part: its outline, its height.
PrintedFile printed_file(const std::string& file, const LoadCase& load_case,
                         const PrintedFileOptions& options);

}  // namespace bead::cli
