// What a layer's travel is like, for that which takes its place: how fast it is, and when filament
// is pulled back for it. Slicers that do so for some short travel but not for longer ones look at
// the walls: they let it ooze where nobody will see.
#pragma once
#include "smooth/walls.h"

namespace bead {

inline constexpr double usual_travel_speed = 120;  // mm/s, of layers that do not say

// How most of a layer's travel goes, by length: short wipes are slower.
struct TravelPace {
    double speed = usual_travel_speed;  // mm/s
    double acceleration = 0;            // mm/s²; 0: the printer's usual
    bool operator==(const TravelPace&) const = default;
};
TravelPace usual_pace(const Toolpath& layer);

class TravelKind {
  public:
    explicit TravelKind(const Toolpath& layer);

    // One path, level at z.
    [[nodiscard]] Path path_along(const Polyline& points, double z) const;

    [[nodiscard]] bool is_retracted(const Polyline& points) const;
    [[nodiscard]] double shortest_retracted() const { return shortest_; }  // mm

  private:
    TravelPace pace_;
    double shortest_;       // mm, of what is retracted
    bool by_walls_ = true;  // of those as long only what crosses a wall
    Walls walls_;
};

}  // namespace bead
