// The prints of Somade (2023) as this program makes them: five shapes, five patterns, three infill
// angles, four part angles. The thesis states neither sizes nor settings; these were inferred from
// its tables of times, lengths and energies (docs/replay.md). One set-up serves all patterns.
//
//     const Print print = experiment_print(outline_of(Shape::oval), {patterns[2]});
//     const Assessment cost = judged(print, experiment_machine());
#pragma once
#include <string_view>
#include <vector>

#include "study/judge.h"
#include "study/print.h"

namespace bead {

enum class Shape { square, rectangle, triangle, drop, oval };
inline constexpr std::array<std::string_view, 5> shape_names{"Square", "Rectangle", "Triangle",
                                                             "Drop", "Oval"};
inline constexpr std::size_t experiment_patterns = 5;    // the first of `patterns`
inline constexpr std::array infill_angles{0, 45, 90};    // °
inline constexpr std::array part_angles{0, 30, 60, 90};  // °

// One of the 300. Angles in °, as the thesis has them; `pattern` counts in `patterns`.
struct ExperimentRun {
    Shape shape = Shape::square;
    std::size_t pattern = 0;
    int infill_angle = 0, part_angle = 0;
    bool operator==(const ExperimentRun&) const = default;
};
std::vector<ExperimentRun> experiment_runs();  // all, in the thesis's order

// About the origin, as at part angle 0. Sizes are fitted to the published energies.
Region outline_of(Shape shape);

struct ExperimentSetup {
    NamedPattern pattern = patterns[0];
    double infill_angle = 0, part_angle = 0;  // rad
    double speed = 0;                         // mm/s of everything printed; 0: as usual
};
ExperimentSetup setup_of(const ExperimentRun& run);

// 20 layers of 2.1 mm together, of which 16 are solid; no walls, no skirt.
Print experiment_print(const Region& outline, const ExperimentSetup& setup);
// That machine with the limits of the experiment; what it draws stays.
Machine experiment_machine(Machine machine = {});
Assessment judged(const Print& print, const Machine& machine,
                  Judging judging = Judging::motion_and_energy);

}  // namespace bead
