// What commands leave lying, layer by layer: extruding moves as paths whose beads have the
// cross-section of the filament that went into them, whoever wrote the file. Arcs become chords.
//
//     LaidLayers laid(1.75, 0.2);
//     read_gcode(file, [&](const Command& command) { laid.add(command); });
//     const std::vector<LaidLayer> layers = std::move(laid).finished();
#pragma once
#include <vector>

#include "toolpath/command.h"

namespace bead {

struct LaidLayer {
    double z = 0, height = 0;  // mm; z is the top
    Toolpath paths;            // no travel
};

class LaidLayers {
  public:
    // mm; `height` counts where the file does not say how high a layer is.
    LaidLayers(double filament_diameter, double height);
    void add(const Command& command);
    [[nodiscard]] std::vector<LaidLayer> finished() &&;

  private:
    void follow(const Move& move);
    void follow(const Arc& arc);
    void lay(const Move& move, double section, Vec2 from);
    LaidLayer& layer_at(double z);

    double filament_area_, height_;
    Position at_{};
    double said_z_ = -1, said_height_ = 0;  // by the last LayerStart; -1: none
    std::vector<LaidLayer> layers_;
};

}  // namespace bead
