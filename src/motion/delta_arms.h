// How the three carriages of a linear delta go while the head runs along a straight line: tower i
// at (xᵢ, yᵢ) has its carriage at
//     hᵢ = z + √(L² - (x - xᵢ)² - (y - yᵢ)²)
// which is concave along any line: a carriage turns at most once, from up to down.
#pragma once
#include <array>
#include <cmath>

#include "geom/vec.h"
#include "machine/kinematics.h"
#include "motion/block.h"

namespace bead {

// One carriage over a straight line, by the way s (mm) along it.
class Carriage {
  public:
    // `start`: the head's place as seen from the tower; `step`: the head's move per mm of s.
    Carriage(double arm, Vec2 start, Vec3 step)
        : start_(start),
          step_(step),
          along_(dot(start, flat(step))),
          flat_(dot(flat(step), flat(step))),
          reach_(arm * arm - dot(start, start)) {}

    [[nodiscard]] double height(double s) const { return step_.z * s + root(s); }  // mm above bed
    struct Slope {
        Vec2 lean;        // ∂h/∂x, ∂h/∂y of the head's place; ∂h/∂z is 1
        double rate = 0;  // dh/ds
        double bend = 0;  // d²h/ds², 1/mm
    };
    [[nodiscard]] Slope slope(double s) const {
        const double upright = 1 / root(s);
        const Vec2 lean = -upright * (start_ + s * flat(step_));
        const double level = dot(lean, flat(step_));
        return {lean, step_.z + level, -(flat_ + level * level) * upright};
    }
    // Where it would stand for a moment; not a number if nowhere, as for the point below.
    [[nodiscard]] double turning_point() const {
        const double steep =
            std::sqrt((along_ * along_ + flat_ * reach_) / (flat_ + step_.z * step_.z));
        return (step_.z * steep - along_) / flat_;
    }

    // While the head's acceleration along the line is constant, that of the carriage times the cube
    // of the arm's height only rises, or only falls, on either side of this point.
    [[nodiscard]] double splitting_point() const {
        const double c = along_ * along_ + flat_ * reach_;
        const double lean = std::sqrt(flat_ * c / (flat_ + step_.z * step_.z));
        return (-std::copysign(lean, step_.z) - along_) / flat_;
    }

  private:
    [[nodiscard]] double root(double s) const {
        return std::sqrt(reach_ - (2 * along_ + flat_ * s) * s);
    }
    Vec2 start_;
    Vec3 step_;
    double along_, flat_, reach_;
};

using Carriages = std::array<Carriage, 3>;

// Of the block, when it starts over `from` (mm). Expects a block of some length. Throws Error if
// the block leaves the room that the arms can serve: no machine goes there, so either the geometry
// or the file is of another one. An arm must not lie flatter than 5°, where its carriage would run
// eleven times as fast as the head.
Carriages carriages_of(const Delta& delta, Vec2 from, const Block& block);

}  // namespace bead
