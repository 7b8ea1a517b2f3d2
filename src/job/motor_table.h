// [power.motors] of a PRINTER.toml. What a winding loses is told by currents and resistance or by
// watts, not both; docs/energy.md lists the keys.
#pragma once
#include <array>
#include <cstddef>
#include <optional>

#include "job/toml_reader.h"
#include "machine/printer.h"

namespace bead {

// What the file leaves open stays as it is. Throws Error for losses that are told twice, that
// cannot be known, or that are larger at rest.
std::array<Motor, 4> read_motors(TomlReader& file, std::array<Motor, 4> motors);

// Which axis moves the bed. Left out, on machines whose motors share axes it is none.
std::optional<std::size_t> read_bed_axis(TomlReader& file, const Printer& printer);

}  // namespace bead
