// Infill along the principal stresses of the solid part as Uncu (2023) lays it, to be compared
// with: single lines traced from seeds, on the edges or the denser the higher the stress, then made
// thicker by copies where they carry much. Nothing is trimmed, braced or tested on the way.
// docs/stress-lines.md says what of it holds.
//
//     const std::optional<ThesisLines> lines = thesis_lines(load_case, {});
#pragma once
#include <array>
#include <optional>

#include "study/layout.h"

namespace bead {

// Where lines begin: on edges that they meet more across than along; or all over the part, at one
// distance or at distances in inverse proportion to the stress along them.
enum class ThesisSeeds : std::uint8_t { edges, even, stress };

struct ThesisOptions {
    ThesisSeeds seeds = ThesisSeeds::edges;
    double apart = 0;    // mm between seeds, by stress: at the mean stress; 0: by the volume
    int copies = 4;      // on either side of a line, at most; 0: single lines
    double cell = 0.5;   // mm, of the stress
    double step = 0.25;  // mm, of the tracing
};

struct ThesisLines {
    Layout layout;                  // walls and pads too
    std::array<double, 2> apart{};  // mm, of either family
    double threshold = 0;           // MPa that the first pair of copies stands for; 0: no copies
    double area = 0;  // mm², deposited: the nearest to the case's that seeds and copies reach
};

// Of the first situation's loads. Nothing if walls and pads alone weigh more than the case says.
std::optional<ThesisLines> thesis_lines(const LoadCase& load_case, const ThesisOptions& options);

}  // namespace bead
