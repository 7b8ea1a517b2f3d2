#include "gcode/curve.h"

#include <algorithm>
#include <cmath>

namespace bead {
namespace {

constexpr float least_step = 0.002F, usual_step = 0.1F;  // of the parameter
constexpr double tolerance = 0.1;                        // mm

// De Casteljau's way, exact at both ends.
Vec2 curve_at(const std::array<Vec2, 4>& c, double t) {
    const auto between = [t](Vec2 a, Vec2 b) { return (1 - t) * a + t * b; };
    const Vec2 ab = between(c[0], c[1]), bc = between(c[1], c[2]), cd = between(c[2], c[3]);
    return between(between(ab, bc), between(bc, cd));
}

// Whether the point halfway in the parameter is about halfway between the ends.
bool is_straight(Vec2 begin, Vec2 middle, Vec2 end) {
    const Vec2 off = middle - (begin + end) / 2;
    return std::abs(off.x) + std::abs(off.y) <= tolerance;
}

float shorter_step_end(const std::array<Vec2, 4>& control, Vec2 from, float t, float end) {
    while (end - t >= least_step) {
        const float half = 0.5F * (t + end);
        if (is_straight(from, curve_at(control, half), curve_at(control, end))) break;
        end = half;
    }
    return end;
}

float longer_step_end(const std::array<Vec2, 4>& control, Vec2 from, float t, float end) {
    while (end - t <= usual_step) {
        const float twice = t + 2 * (end - t);
        if (twice >= 1) break;
        if (!is_straight(from, curve_at(control, end), curve_at(control, twice))) break;
        end = twice;
    }
    return end;
}

}  // namespace

std::vector<CurvePoint> curve_chords(const std::array<Vec2, 4>& control) {
    std::vector<CurvePoint> points;
    Vec2 from = control[0];
    float step = usual_step;
    for (float t = 0; t < 1;) {
        const float first = std::min(1.0F, t + step);
        float end = shorter_step_end(control, from, t, first);
        if (end == first) end = longer_step_end(control, from, t, end);
        step = end - t;
        t = end;
        from = curve_at(control, t);
        points.push_back({from, t});
    }
    return points;
}

}  // namespace bead
