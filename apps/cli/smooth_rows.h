// The figures of one side of a smoothing, before or after, gathered layer by layer.
#pragma once
#include <optional>

#include "json_result.h"
#include "vibration/response_meter.h"
#include "vibration/timed.h"

namespace bead::cli {

// What a toolpath shows without a clock; sums over layers but for those marked.
struct PathFigures {
    double length = 0, travel = 0, infill_length = 0;  // mm, travel included
    double points = 0, infill_points = 0, turning = 0, windowed = 0;
    double chord_error = 0;              // mm times points: mean over the points when divided
    double true_chord_error = 0;         // mm, largest
    double volume = 0;                   // mm³
    double underfill = 0, overfill = 0;  // mm², of the sampled layers
    double outline_deviation = 0;        // mm, largest, of the sampled layers

    void add(const PathFigures& layer);
};
PathFigures path_figures(const Toolpath& layer);

// One side under a law. Layers come in order; sampled ones are one motion from rest to rest.
class SmoothSide {
  public:
    SmoothSide(const ShakenMachine& machine, const TimeLaw& law);

    void add(const Toolpath& sampled_layer);
    void add_time(double seconds) { other_time_ += seconds; }  // of a layer that is not sampled
    void add(const PathFigures& figures) { figures_.add(figures); }
    void finish();
    [[nodiscard]] Json json() const;
    [[nodiscard]] const PathFigures& figures() const { return figures_; }
    [[nodiscard]] const Response& response() const { return response_; }
    [[nodiscard]] double time() const { return response_.time + other_time_; }
    [[nodiscard]] DriveEnergy energy() const;
    [[nodiscard]] double material() const;  // g
    [[nodiscard]] double co2() const;       // g

  private:
    const ShakenMachine& machine_;
    ResponseMeter meter_;
    Timing timing_;
    std::optional<Vec2> at_;
    bool any_ = false;
    double other_time_ = 0;  // s, of layers that are not sampled
    PathFigures figures_;
    Response response_;
};

}  // namespace bead::cli
