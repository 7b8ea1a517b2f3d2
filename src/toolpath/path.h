// The waist of the program: what is printed, where, how thick and how fast, in printing order.
// Planners make a Toolpath, smoothing maps one to another, every cost reads one.
#pragma once
#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "geom/vec.h"

namespace bead {

enum class Role : std::uint8_t {
    travel,
    outer_wall,
    wall,
    skin,      // solid, closed below or above by other layers
    top_skin,  // solid, seen from above
    infill,
    support,
    skirt,
    other,  // priming, wipe towers, whatever a foreign file does not name
};
inline constexpr std::array<std::string_view, 9> role_names{
    "travel", "outer_wall", "wall", "skin", "top_skin", "infill", "support", "skirt", "other"};
inline constexpr std::string_view name_of(Role role) {
    return role_names[static_cast<std::size_t>(role)];
}

template <class T>
using PerRole = std::array<T, role_names.size()>;

// A deposited line is taken as a stadium: a rectangle with two half discs for its sides.
struct Bead {
    double width = 0, height = 0;  // mm
    bool operator==(const Bead&) const = default;
};

// Cross-section in mm²; a bead narrower than high counts as an ellipse.
constexpr double section(const Bead& bead) {
    if (bead.width < bead.height) return pi / 4 * bead.width * bead.height;
    return (bead.width - bead.height) * bead.height + pi / 4 * bead.height * bead.height;
}
// The bead of this height that has the cross-section (mm²).
constexpr Bead bead_of(double section, double height) {
    const double flat = section / height, round = pi / 4 * height;
    return {flat < round ? flat * 4 / pi : flat - round + height, height};
}
// Distance at which beads lie side by side so that section = spacing × height: they tile the plane.
constexpr double spacing(const Bead& bead) { return section(bead) / bead.height; }

struct Path {
    Role role = Role::travel;
    Bead bead;                 // of travel: none
    double speed = 0;          // mm/s, asked for
    double acceleration = 0;   // mm/s², asked for; 0: the printer's usual
    bool retracted = false;    // travel with the filament pulled back
    std::vector<Vec3> points;  // z is the nozzle's height
};

using Toolpath = std::vector<Path>;  // in printing order, travel included

double length(const Path& path);  // mm
double volume(const Path& path);  // mm³ of plastic; 0 for travel

}  // namespace bead
