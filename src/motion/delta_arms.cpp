#include "motion/delta_arms.h"

#include <fmt/format.h>

#include "core/error.h"
#include "core/expects.h"

namespace bead {
namespace {

constexpr double flattest = 5 * pi / 180;  // rad above the horizontal
constexpr std::array<double, 3> bearings{210 * pi / 180, 330 * pi / 180, 90 * pi / 180};

void expect_in_reach(const Delta& delta, Vec2 tower, Vec2 head, std::int64_t line) {
    if (distance(head, tower) <= delta.arm * std::cos(flattest)) return;
    throw Error(fmt::format(
        "{}the head cannot be at X{:.6g} Y{:.6g} on this delta: arms of {:.6g} mm with towers "
        "{:.6g} "
        "mm from the middle do not reach there; check [delta] of the printer file, and that the "
        "G-code has X0 Y0 in the middle of the bed",
        line > 0 ? fmt::format("line {}: ", line) : "", head.x, head.y, delta.arm, delta.radius));
}

}  // namespace

Carriages carriages_of(const Delta& delta, Vec2 from, const Block& block) {
    BEAD_EXPECTS(block.length > 0);
    const Vec3 step =
        (1 / block.length) * Vec3{block.delta[axis_x], block.delta[axis_y], block.delta[axis_z]};
    const Vec2 to = from + Vec2{block.delta[axis_x], block.delta[axis_y]};
    const auto carriage = [&](double bearing) {
        const Vec2 tower = delta.radius * unit(bearing);
        expect_in_reach(delta, tower, from, block.line);
        expect_in_reach(delta, tower, to, block.line);
        return Carriage(delta.arm, from - tower, step);
    };
    return {carriage(bearings[0]), carriage(bearings[1]), carriage(bearings[2])};
}

}  // namespace bead
