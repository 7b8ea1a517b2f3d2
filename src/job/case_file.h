// CASE.toml: a part, what holds it, what pulls at it (fem/load_case.h). The outline is in the file,
// in an SVG, or the section of a mesh half-way up; with boxes in place of stretches the case is one
// in space. docs/fem.md shows it whole.
//
// Throws Error with file and line for keys that are not known, values out of range, outlines that
// cross themselves, holes outside the outline, stretches that are not on the boundary, cases
// without load, supports that let the part move.
#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "fem/load_case.h"
#include "fem/solid_case.h"

namespace bead {

using AnyCase = std::variant<LoadCase, SolidCase>;

AnyCase read_case(const std::string& file);
// One of the plane; a case in space is refused.
LoadCase read_plane_case(const std::string& file);
// `name` is what messages call the text; files it names are relative to its folder.
AnyCase parsed_case(std::string_view text, const std::string& name);

// Throws if the part, or a neck of it, is thinner than a bead, or a layer higher than the part.
void check_printable(const LoadCase& load_case, const std::string& name);

// What of the part no bead gets into, in words, if it is more than corners.
std::optional<std::string> unprinted_words(const LoadCase& load_case);

}  // namespace bead
