// What one source (a printer file, a slicer's notes, the environment) says of a machine. What it
// leaves open is left to other sources; sourced_printer.h puts several together.
#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "machine/firmware.h"

namespace bead {

struct StatedLimit {
    std::string_view name;  // of named_limits(), limit_table.h
    std::size_t axis = 0;   // of a limit per axis; else 0
    double value = 0;       // one that the limit allows
    std::string source;     // for people, "printer.cfg:12 (max_accel)"
};

struct FirmwareChoice {
    Firmware firmware = Firmware::prusa;
    std::string source;  // for people
};

struct Statement {
    std::vector<StatedLimit> limits;
    std::optional<FirmwareChoice> firmware;
    std::vector<std::string> warnings;  // lines for people: what was passed over, and why
    std::vector<std::string> notes;     // lines for people: what it leaves open
};

}  // namespace bead
