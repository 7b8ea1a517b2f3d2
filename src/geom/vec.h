// Points and vectors in the plane and in space. Lengths are in mm, angles in rad,
// counter-clockwise.
#pragma once
#include <cmath>
#include <numbers>

namespace bead {

inline constexpr double pi = std::numbers::pi;

struct Vec2 {
    double x = 0, y = 0;
    bool operator==(const Vec2&) const = default;
};

constexpr Vec2 operator+(Vec2 a, Vec2 b) { return {a.x + b.x, a.y + b.y}; }
constexpr Vec2 operator-(Vec2 a, Vec2 b) { return {a.x - b.x, a.y - b.y}; }
constexpr Vec2 operator-(Vec2 a) { return {-a.x, -a.y}; }
constexpr Vec2 operator*(double s, Vec2 a) { return {s * a.x, s * a.y}; }
constexpr Vec2 operator/(Vec2 a, double s) { return {a.x / s, a.y / s}; }
constexpr double dot(Vec2 a, Vec2 b) { return a.x * b.x + a.y * b.y; }
// The z part of the cross product: positive when b lies to the left of a.
constexpr double cross(Vec2 a, Vec2 b) { return a.x * b.y - a.y * b.x; }
inline double length(Vec2 a) { return std::sqrt(dot(a, a)); }
inline double distance(Vec2 a, Vec2 b) { return length(b - a); }
inline Vec2 unit(double angle) { return {std::cos(angle), std::sin(angle)}; }
constexpr Vec2 left_of(Vec2 a) { return {-a.y, a.x}; }
constexpr Vec2 lerp(Vec2 a, Vec2 b, double t) { return a + t * (b - a); }
// `turn` is unit(angle): take it once for many points.
constexpr Vec2 rotated(Vec2 a, Vec2 turn) {
    return {turn.x * a.x - turn.y * a.y, turn.y * a.x + turn.x * a.y};
}

struct Vec3 {
    double x = 0, y = 0, z = 0;
    bool operator==(const Vec3&) const = default;
};

constexpr Vec3 operator+(Vec3 a, Vec3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
constexpr Vec3 operator-(Vec3 a, Vec3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
constexpr Vec3 operator*(double s, Vec3 a) { return {s * a.x, s * a.y, s * a.z}; }
constexpr double dot(Vec3 a, Vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
constexpr Vec3 cross(Vec3 a, Vec3 b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline double length(Vec3 a) { return std::sqrt(dot(a, a)); }
constexpr Vec2 flat(Vec3 a) { return {a.x, a.y}; }
constexpr Vec3 at_height(Vec2 a, double z) { return {a.x, a.y, z}; }

}  // namespace bead
