#include "vibration/point_speeds.h"

#include <algorithm>
#include <cmath>

#include "motion/corner.h"

namespace bead {
namespace {

constexpr double real_corner = 20.5 * pi / 180;  // rad
constexpr double bend_window = 1.5;              // mm

double turn(const Piece& before, const Piece& after) {
    const Vec2 a = before.to - before.from, b = after.to - after.from;
    return std::atan2(cross(a, b), dot(a, b));
}

Leg leg_of(const Piece& piece, const TimeLaw& law) {
    const double way = length(piece), acceleration = acceleration_of(piece, law);
    const Vec2 direction = (piece.to - piece.from) / way;
    return {{direction.x, direction.y, 0, 0},
            way,
            acceleration,
            corner_deviation(law.square_corner_velocity, acceleration)};
}

double step_speed(double turned, double step) {
    return step / std::max(1e-9, 2 * std::sin(std::abs(turned) / 2));
}

// The smooth bend's speed at every inner point, real corner or not.
std::vector<double> bend_speeds(std::span<const Piece> pieces, const TimeLaw& law) {
    std::vector<double> speeds = windowed_curvature(pieces, bend_window);
    for (std::size_t i = 1; i < pieces.size(); ++i) {
        const double most =
            std::min(acceleration_of(pieces[i - 1], law), acceleration_of(pieces[i], law));
        speeds[i] = std::sqrt(most / std::max(speeds[i], 1e-9));
    }
    return speeds;
}

}  // namespace

double acceleration_of(const Piece& piece, const TimeLaw& law) {
    return piece.acceleration > 0 ? std::min(piece.acceleration, law.acceleration)
                                  : law.acceleration;
}

std::vector<double> windowed_curvature(std::span<const Piece> pieces, double window) {
    const std::size_t n = pieces.size();
    // Up to and without point i: place, turned angle, path that belongs to the points.
    std::vector<double> place(n + 1), turned(n + 2), share(n + 2);
    for (std::size_t i = 0; i < n; ++i) place[i + 1] = place[i] + length(pieces[i]);
    for (std::size_t i = 0; i <= n; ++i) {
        const bool inner = i > 0 && i < n;
        turned[i + 1] = turned[i] + (inner ? turn(pieces[i - 1], pieces[i]) : 0);
        share[i + 1] = share[i] + (place[std::min(i + 1, n)] - place[i > 0 ? i - 1 : 0]) / 2;
    }
    std::vector<double> curvature(n + 1);
    const double half = window / 2 + 1e-9;
    for (std::size_t i = 0, low = 0, high = 0; i <= n; ++i) {
        while (place[low] < place[i] - half) ++low;
        while (high <= n && place[high] <= place[i] + half) ++high;
        curvature[i] =
            std::abs(turned[high] - turned[low]) / std::max(window, share[high] - share[low]);
    }
    return curvature;
}

std::vector<double> point_speeds(std::span<const Piece> pieces, const TimeLaw& law) {
    const std::size_t n = pieces.size();
    const bool smooth = law.profile == SpeedProfile::jerk_limited;
    std::vector<double> speeds(n + 1);
    if (smooth) speeds = bend_speeds(pieces, law);
    for (std::size_t i = 1; i < n; ++i) {
        const double turned = std::abs(turn(pieces[i - 1], pieces[i]));
        const double corner =
            std::sqrt(corner_speed2(leg_of(pieces[i - 1], law), leg_of(pieces[i], law)));
        if (!smooth)
            speeds[i] = corner;
        else if (turned > real_corner)
            speeds[i] = std::min(speeds[i], corner);
        if (smooth && law.velocity_step > 0)
            speeds[i] = std::min(speeds[i], step_speed(turned, law.velocity_step));
    }
    speeds.front() = speeds.back() = 0;
    return speeds;
}

}  // namespace bead
