// What `beadwork optimize` found, for people and for programs: the print as told beside the chosen
// one.
#pragma once
#include "console.h"
#include "json_result.h"
#include "study/optimize.h"

namespace bead::cli {

void print_optimum(const Console& console, const Optimum& best, const Machine& machine,
                   const std::string& model, const std::string& printer);
Json optimum_json(const Optimum& best, const Machine& machine);

}  // namespace bead::cli
