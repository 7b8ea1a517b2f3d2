// Axis-aligned boxes. A new box is empty and grows by what it is made to include.
#pragma once
#include <algorithm>
#include <limits>

#include "geom/vec.h"

namespace bead {

struct Box2 {
    Vec2 low{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
    Vec2 high{-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};

    [[nodiscard]] bool is_empty() const { return low.x > high.x || low.y > high.y; }
    [[nodiscard]] Vec2 size() const { return high - low; }
    [[nodiscard]] Vec2 centre() const { return 0.5 * (low + high); }
    void include(Vec2 p) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    void include(const Box2& box) {
        if (box.is_empty()) return;
        include(box.low);
        include(box.high);
    }
};

struct Box3 {
    Vec3 low{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity(),
             std::numeric_limits<double>::infinity()};
    Vec3 high{-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(),
              -std::numeric_limits<double>::infinity()};

    [[nodiscard]] bool is_empty() const { return low.x > high.x; }
    [[nodiscard]] Vec3 size() const { return high - low; }
    void include(Vec3 p) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    }
};

}  // namespace bead
