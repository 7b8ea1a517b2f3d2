// The small languages inside SVG's attributes: lists of numbers, paths, transforms. Curves become
// lines within a few µm of a drawing in mm.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "geom/polygon.h"

namespace bead {

struct SvgTransform {
    double a = 1, b = 0, c = 0, d = 1, e = 0, f = 0;  // x' = a x + c y + e, y' = b x + d y + f
    Vec2 operator()(Vec2 p) const { return {a * p.x + c * p.y + e, b * p.x + d * p.y + f}; }
};
SvgTransform operator*(const SvgTransform& outer, const SvgTransform& inner);

// `name` names the drawing in messages. Each throws Error for what it cannot read.
std::vector<double> svg_numbers(std::string_view text, const std::string& name);
Polyline svg_points(std::string_view text, const std::string& name);
SvgTransform svg_transform(std::string_view text, const std::string& name);
// Each piece of the path, closed.
std::vector<Polyline> svg_path(std::string_view d, const std::string& name);

}  // namespace bead
