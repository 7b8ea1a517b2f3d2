// A toolpath as it grows: what is laid next is reached by travel from where the last one ended.
#pragma once
#include "plan/parts.h"

namespace bead {

// What a line is laid as.
struct Laid {
    Role role = Role::other;
    Bead bead;
    bool on_infill = false;  // skin on sparse infill
};

class Route {
  public:
    Route(const LayerParts& layer, const PlanOptions& options, Vec2 start);

    [[nodiscard]] Vec2 at() const { return at_; }
    // Goes to the line's start and lays it. Long travel that leaves `around` is retracted.
    void lay(const Laid& as, const Polyline& line, const Region& around);
    [[nodiscard]] Toolpath finished() && { return std::move(path_); }

  private:
    void travel(Vec2 to, const Region& around);
    [[nodiscard]] double speed_of(const Laid& as) const;
    [[nodiscard]] double acceleration_of(const Laid& as) const;
    [[nodiscard]] std::vector<Vec3> raised(const Polyline& line) const;

    const double z_;
    const bool is_first_layer_;
    const PlanOptions& options_;
    Vec2 at_;
    Toolpath path_;
};

// Whether the straight line from `a` to `b` lies in the region.
bool stays_inside(const Region& region, Vec2 a, Vec2 b);

}  // namespace bead
