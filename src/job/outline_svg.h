// The outline of a part from an SVG drawing: all closed shapes (path, polygon, rect, circle,
// ellipse) together by the even-odd rule, so that a shape inside another is a hole. In mm: by the
// drawing's width and viewBox where it has both with a unit, else one user unit is one mm. y is
// turned over about the drawing's height, because SVG counts down.
//
// Throws Error for what is no SVG, has no closed shape, or uses what is not read (arcs of paths
// are, text and images are not).
#pragma once
#include <string>
#include <string_view>

#include "geom/polygon.h"

namespace bead {

Region outline_of_svg(std::string_view text, const std::string& name);

}  // namespace bead
