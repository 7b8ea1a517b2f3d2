// The tables of docs/smoothing.md in Markdown: changes in % against B1 by K0, mean/worst over
// parts.
#pragma once
#include "study/shaking.h"

namespace bead::shaking {

// What a path is, whatever the law: one row per path.
void print_paths(const ShakingTable& table);

// What the machine does: one row per path and law, volume, coverage and time among them. Coverage
// in mm², mean/most, for a change of next to nothing says nothing.
void print_responses(const std::vector<ShakingCell>& cells, const ShakingTable& table);

// The figures themselves of one part by one law, one column per path.
void print_figures(const std::vector<ShakingCell>& cells, const std::string& part,
                   const std::string& law);

}  // namespace bead::shaking
