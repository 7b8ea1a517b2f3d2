// Meshes to test with, all closed and facing outwards unless the name says otherwise. Lengths in
// mm.
#pragma once
#include <algorithm>
#include <cstdint>
#include <random>
#include <utility>

#include "geom/polygon.h"
#include "mesh/mesh.h"

namespace bead::shapes {

// `sides` points on a circle, counter-clockwise.
inline Polyline regular(double radius, int sides, Vec2 centre = {}) {
    Polyline loop;
    for (int i = 0; i < sides; ++i) loop.push_back(centre + radius * unit(2 * pi * i / sides));
    return loop;
}

// The side walls of an upright prism over a counter-clockwise loop, from z = 0 to `height`.
// Point i lies at the bottom, point n + i above it.
inline Mesh walls(const Polyline& loop, double height) {
    Mesh mesh;
    for (const Vec2 p : loop) mesh.points.push_back(at_height(p, 0));
    for (const Vec2 p : loop) mesh.points.push_back(at_height(p, height));
    const int n = static_cast<int>(loop.size());
    for (int i = 0; i < n; ++i) {
        const int j = (i + 1) % n;
        mesh.triangles.push_back({i, j, n + j});
        mesh.triangles.push_back({i, n + j, n + i});
    }
    return mesh;
}

// The upright prism over a loop that can be seen whole from the point `centre` (star-shaped).
inline Mesh extruded(const Polyline& loop, double height, Vec2 centre = {}) {
    Mesh mesh = walls(loop, height);
    const int n = static_cast<int>(loop.size());
    mesh.points.push_back(at_height(centre, 0));
    mesh.points.push_back(at_height(centre, height));
    for (int i = 0; i < n; ++i) {
        const int j = (i + 1) % n;
        mesh.triangles.push_back({2 * n, j, i});
        mesh.triangles.push_back({2 * n + 1, n + i, n + j});
    }
    return mesh;
}

inline Mesh box(Vec3 size) {
    return extruded({{0, 0}, {size.x, 0}, {size.x, size.y}, {0, size.y}}, size.z,
                    {size.x / 2, size.y / 2});
}

inline Mesh cylinder(double radius, double height, int sides) {
    return extruded(regular(radius, sides), height);
}

// The prism between two counter-clockwise loops of the same number of points, the second inside.
inline Mesh extruded_ring(const Polyline& outer, const Polyline& inner, double height) {
    Mesh mesh = walls(outer, height);
    const Mesh bore = walls(inner, height);
    const int n = static_cast<int>(outer.size());
    mesh.points.insert(mesh.points.end(), bore.points.begin(), bore.points.end());
    for (const auto& [a, b, c] : bore.triangles)
        mesh.triangles.push_back({2 * n + a, 2 * n + c, 2 * n + b});
    for (int i = 0; i < n; ++i) {
        const int j = (i + 1) % n;
        mesh.triangles.push_back({i, 2 * n + i, 2 * n + j});
        mesh.triangles.push_back({i, 2 * n + j, j});
        mesh.triangles.push_back({n + i, 3 * n + j, 3 * n + i});
        mesh.triangles.push_back({n + i, n + j, 3 * n + j});
    }
    return mesh;
}

// A square plate about the origin with a round hole of `sides` (a multiple of 4) sides in its
// middle.
inline Mesh plate_with_hole(double width, double height, double radius, int sides) {
    const Polyline hole = regular(radius, sides);
    Polyline rim;  // the hole's points, pushed out to the square
    for (const Vec2 p : regular(1, sides))
        rim.push_back((width / 2 / std::max(std::abs(p.x), std::abs(p.y))) * p);
    return extruded_ring(rim, hole, height);
}

// A globe of `rings` bands of 2 * rings facets each, points on the sphere, centred at the origin.
inline Mesh sphere(double radius, int rings) {
    const int around = 2 * rings;
    Mesh mesh;
    for (int ring = 1; ring < rings; ++ring) {
        const Vec2 at = unit(pi * ring / rings - pi / 2);  // (cosine, sine) of the latitude
        for (const Vec2 p : regular(radius * at.x, around))
            mesh.points.push_back(at_height(p, radius * at.y));
    }
    const int south = static_cast<int>(mesh.points.size());
    mesh.points.push_back({0, 0, -radius});
    mesh.points.push_back({0, 0, radius});
    const int last = (rings - 2) * around;
    for (int i = 0; i < around; ++i) {
        const int j = (i + 1) % around;
        mesh.triangles.push_back({south, j, i});
        mesh.triangles.push_back({south + 1, last + i, last + j});
        for (int low = 0; low < last; low += around) {
            mesh.triangles.push_back({low + i, low + j, low + around + j});
            mesh.triangles.push_back({low + i, low + around + j, low + around + i});
        }
    }
    return mesh;
}

// A wild outline of `points` points between `least` and `most` from the origin, which sees them
// all.
inline Polyline random_star(std::uint64_t seed, int points, double least, double most) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> radius(least, most);
    Polyline loop;
    for (const Vec2 direction : regular(1, points)) loop.push_back(radius(random) * direction);
    return loop;
}

inline Mesh random_extrusion(std::uint64_t seed, double height) {
    return extruded(random_star(seed, 24, 4, 20), height);
}

// Both, without any care for where they overlap.
inline Mesh together(Mesh mesh, const Mesh& other) {
    const int first = static_cast<int>(mesh.points.size());
    mesh.points.insert(mesh.points.end(), other.points.begin(), other.points.end());
    for (const auto& [a, b, c] : other.triangles)
        mesh.triangles.push_back({first + a, first + b, first + c});
    return mesh;
}

inline Mesh inside_out(Mesh mesh) {
    for (auto& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
    return mesh;
}

// Triangles that share no points, as STL files have them.
inline Mesh unwelded(const Mesh& mesh) {
    Mesh soup;
    for (const auto& triangle : mesh.triangles) {
        const int first = static_cast<int>(soup.points.size());
        for (const int i : triangle)
            soup.points.push_back(mesh.points[static_cast<std::size_t>(i)]);
        soup.triangles.push_back({first, first + 1, first + 2});
    }
    return soup;
}

}  // namespace bead::shapes
