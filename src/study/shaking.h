// Paths times time laws: every path is driven by every law on one machine, so that what a path
// gains and what a law gains are told apart. Changes are against one path under one law, mean and
// worst over several parts.
//
//     const auto cells = shaken(paths, laws, example_machine(14, 22));
//     out << text_of(changes(cells, {"B1", "K0"}));
#pragma once
#include <span>
#include <string>
#include <vector>

#include "vibration/assess.h"

namespace bead {

struct Figure {
    std::string name;  // with its unit
    double value = 0;
};

// One part's layer by one way of planning it, and what is known of it without a law. The coverage
// (figures `underfill_name` and `overfill_name`) must be among that.
struct ShakenPath {
    std::string name, part;
    Toolpath toolpath;
    std::vector<Figure> figures;
};
inline constexpr const char* underfill_name = "under-fill, mm²";
inline constexpr const char* overfill_name = "over-fill, mm²";
inline constexpr const char* time_name = "time, s";
inline constexpr const char* volume_name = "volume, mm³";

struct ShakingCell {
    std::string path, law, part;
    std::vector<Figure> figures;  // the path's, then the response's
};

// The example machine with its flexures tuned to these frequencies (Hz).
ShakenMachine example_machine(double x, double y);

std::vector<Figure> figures_of(const Response& response);

// In the order of paths, then laws; on as many threads as there are.
std::vector<ShakingCell> shaken(std::span<const ShakenPath> paths, std::span<const NamedLaw> laws,
                                const ShakenMachine& machine, const AssessOptions& options = {});

struct Change {
    double mean = 0, worst = 0;  // %, of coverage mm²; worst is the largest, for less is better
};
struct ShakingLine {
    std::string path, law;
    std::vector<Change> changes;  // one per column
};
struct ShakingTable {
    std::vector<std::string> columns;
    std::vector<std::string> parts;
    std::vector<ShakingLine> lines;
};

struct ShakingBase {
    std::string path, law;
};

// Throws Error if a cell does not say its law, time, volume or coverage: without them a smaller
// figure may only mean less print. Every part needs a cell of the base.
ShakingTable changes(std::span<const ShakingCell> cells, const ShakingBase& base);

// "-57/-55": mean and worst.
std::string text_of(const ShakingTable& table);

}  // namespace bead
