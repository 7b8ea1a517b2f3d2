// The few pieces of SVG that pictures are made of.
#pragma once
#include <span>
#include <string>
#include <string_view>

#include "geom/vec.h"

namespace bead {

// At most three decimals, none that are 0: "1.5", "-0.25", "3".
std::string decimal(double value);

// As it may stand in an element or an attribute; control characters become spaces.
std::string escaped(std::string_view text);

// One stroke for a path's `d`, to 1 µm, y turned over because SVG counts down. Steps are relative
// to the rounded point before, so that rounding does not add up. "" if there is no length to draw.
std::string stroke_data(std::span<const Vec3> points);

// A name made from the content, the same wherever the program runs: pictures put side by side on
// one page do not confuse their parts.
std::string content_name(std::string_view content);

}  // namespace bead
