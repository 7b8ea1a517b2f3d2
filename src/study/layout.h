// The lines that one layer of a reinforced part is made of, each with what it is for. All beads
// have one width; a bead counts as a rectangle, so the deposited area is length times width.
#pragma once
#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "fem/load_case.h"
#include "geom/polygon.h"
#include "toolpath/path.h"

namespace bead {

enum class LineKind : std::uint8_t {
    wall,
    pad,          // solid, under loads and supports
    tensile,      // along the first principal stress
    compressive,  // along the second
    brace,        // against buckling
    patch,        // so that it breaks later
};
inline constexpr std::array<std::string_view, 6> line_kind_names{"wall",        "pad",   "tensile",
                                                                 "compressive", "brace", "patch"};

struct LayoutLine {
    LineKind kind = LineKind::wall;
    std::vector<Vec2> points;  // closed lines repeat their first point
};

inline constexpr double solid_pitch = 0.95;  // bead widths between beads that shall close up
inline constexpr double line_step = 0.25;    // mm between places where a line is looked at

using Layout = std::vector<LayoutLine>;

double deposited_area(const Layout& layout, double bead_width);  // mm², overlaps counted twice
double deposited_area(const Layout& layout, double bead_width, LineKind kind);
// The same, less what is saved at crossings (crossing_flow.h).
double deposited_area(const Layout& layout, const PrintWish& print);
double deposited_area(const Layout& layout, const PrintWish& print, LineKind kind);

std::vector<Polyline> lines_of(const Layout& layout, LineKind kind);

// A bead of the case's height whose cross-section is that of the rectangle width × height, or a
// share of it.
Bead printed_bead(const PrintWish& print, double flow = 1);

// As a layer at z = 0, in the layout's order and without travel: what the test judges.
Toolpath layer_of(const Layout& layout, const PrintWish& print);

}  // namespace bead
