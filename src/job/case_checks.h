// What a CASE.toml can say that is well written and still makes no sense. Each throws an Error that
// names the key.
#pragma once
#include <optional>

#include "fem/load_case.h"
#include "fem/solid_case.h"
#include "job/toml_reader.h"

namespace bead {

// All points lie on one line, to a nanometre.
bool is_flat(const Polyline& loop);

// Where two sides of the loop cross or touch that are not neighbours.
std::optional<Vec2> self_crossing(const Polyline& loop);

// Loads and supports lie on the boundary, something pulls, the supports hold the part but not all
// that is pulled at.
void check_boundary(TomlReader& file, const LoadCase& load_case);
void check_boxes(TomlReader& file, const SolidCase& solid);

}  // namespace bead
