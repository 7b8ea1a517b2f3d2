// What of a file's layer can be written anew: its motion as a Toolpath, and the lines before,
// within and behind that motion.
//
//     head   up to the first bead of the layer: heat, fan, comments, the way there
//     body   from the first bead to the last one
//     tail   what follows, in the last layer the end code
//
// The body can be replaced if nothing in it is bound to its place. Of head and tail the moves may
// go too, if nothing else in them depends on where the nozzle stands (`free`).
#pragma once
#include <string>

#include "gcode/layer_reader.h"
#include "gcode/motion_style.h"

namespace bead {

struct LayerPlan {
    std::string obstacle;  // why the body must stay as it is; empty: it can be replaced
    std::size_t head_end = 0, tail_begin = 0;  // lines
    bool head_free = false, tail_free = false;
    Toolpath whole;  // all motion of the layer
    Toolpath body;   // travel included
    double z = 0;    // mm, of the body
    // Where the nozzle is and how much filament is pulled back (mm) before, at the head's end, at
    // the tail's begin and behind, as the file has it.
    struct Place {
        Position at{};
        double pulled_back = 0, feed = 0;
        double acceleration = 0;  // mm/s², as last asked for; 0: unknown
    };
    Place before, head, tail, after;
};

// Reads layers in their order: each is seen with what the ones before it left.
class LayerPlanner {
  public:
    explicit LayerPlanner(double filament_diameter) { style_.filament = filament_diameter; }

    LayerPlan plan(const FileLayer& layer);
    // As of the layers up to now.
    [[nodiscard]] const MotionStyle& style() const { return style_; }

  private:
    class Reading;
    MotionStyle style_;
    double pulled_back_ = 0, acceleration_ = 0;
    double last_z_ = 0;  // mm, of the layer before
    double height_ = 0;  // mm, of this one
};

}  // namespace bead
