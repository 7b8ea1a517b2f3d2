// What a machine is told, one command at a time: the common form of our own plans and of anybody's
// G-code. Motion is simulated from these and G-code is written from these, so that what is judged
// is what is printed. Positions are absolute mm in the frame that SetPosition (G92) leaves; speeds
// mm/s.
//
//     const CommandSink count = [&](const Command& command) { ++commands; };
//     read_gcode(file, {}, count);
#pragma once
#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <variant>

#include "toolpath/path.h"

namespace bead {

enum Axis : std::uint8_t { axis_x, axis_y, axis_z, axis_e };
inline constexpr int axis_count = 4;
template <class T>
using PerAxis = std::array<T, axis_count>;  // X, Y, Z, E
using Position = PerAxis<double>;           // mm; E is the filament's length

struct Move {  // G0, G1: a straight line, all axes together
    Position to{};
    double feed = 0;  // mm/s, asked for, along X, Y and Z (along E if nothing else moves)
    Role role = Role::travel;
    Bead bead;  // as far as it is known; 0 if not
};
enum class Plane : std::uint8_t { xy, zx, yz };  // G17, G18, G19
struct Arc {   // G2, G3: along a circle; what is not in its plane, E too, goes evenly along
    Move end;  // where it leads; feed is along the arc
    std::array<double, 2> centre{};  // mm, absolute, in the plane's axes (XY, ZX or YZ)
    bool clockwise = false;
    Plane plane = Plane::xy;
    int more_turns = 0;  // whole circles before the rest (P)
};
struct SetPosition {  // G92: the machine stands still and calls its place by other numbers
    PerAxis<std::optional<double>> to{};
};
struct Home {  // G28: the named axes stand at 0 afterwards
    std::array<bool, 3> axes{true, true, true};
};
struct Dwell {            // G4
    double duration = 0;  // s
};
struct Drain {};  // M400: wait until all moves are done
enum class Heater : std::uint8_t { hotend, bed };
struct SetHeat {  // M104, M109, M140, M190
    Heater heater = Heater::hotend;
    double celsius = 0;
    bool wait = false;
};
struct SetFan {       // M106, M107
    double duty = 0;  // 0 … 1
};
struct SetLimits {  // M201, M203, M204, M205, SET_VELOCITY_LIMIT: only what is named changes
    PerAxis<std::optional<double>> max_acceleration{}, max_feedrate{}, jerk{};
    std::optional<double> acceleration{}, retract_acceleration{}, travel_acceleration{};
    std::optional<double> junction_deviation{};  // mm, M205 J
    // SET_VELOCITY_LIMIT, which only Klipper obeys; its acceleration is the head's whole one
    std::optional<double> max_velocity{}, max_acceleration_head{}, square_corner_velocity{},
        minimum_cruise_ratio{};
};
struct LayerStart {
    double z = 0;       // mm, top of the layer
    double height = 0;  // mm; 0 if the file does not say
};

struct Command {
    std::variant<Move, Arc, SetPosition, Home, Dwell, Drain, SetHeat, SetFan, SetLimits, LayerStart>
        what;
    std::int64_t line = 0;  // of the file it came from, from 1; 0: from no file
};

using CommandSink = std::function<void(const Command&)>;

}  // namespace bead
