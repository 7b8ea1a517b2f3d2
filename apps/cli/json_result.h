// The machine-readable result of a command: its common head, and getting it out whole or not at
// all.
#pragma once
#include <nlohmann/json.hpp>

#include <string>
#include <vector>

#include "energy/meter.h"
#include "study/judge.h"

namespace bead::cli {

using Json = nlohmann::ordered_json;

// schema_version, program_version, command, inputs.
Json result_head(const std::string& command, const std::vector<std::string>& inputs);

// Does nothing when `place` is empty; "-" is standard output.
void write_result(const std::string& place, const Json& result);

Json motion_json(const Assessment& cost);  // time, lengths, axes, features
Json energy_json(const Assessment& cost, const PowerModel& power);

}  // namespace bead::cli
