#include "strength/printed_pixels.h"

#include <algorithm>
#include <cmath>

namespace bead {
namespace {

constexpr double touching = 1e-9;         // mm², by which a pixel's middle on the very rim counts
constexpr double other_direction = 0.35;  // rad

int bounded(double value, int most) {
    return static_cast<int>(std::clamp(std::floor(value), 0.0, static_cast<double>(most)));
}

// Calls visit(pixel, distance from the segment) for the pixels whose middle lies within `radius`.
template <class Visit>
void for_pixels_near(const PixelGrid& grid, Vec2 a, Vec2 b, double radius, const Visit& visit) {
    const Vec2 way = b - a;
    const double square = dot(way, way);
    const Vec2 low = (Vec2{std::min(a.x, b.x), std::min(a.y, b.y)} - grid.origin) / grid.size;
    const Vec2 high = (Vec2{std::max(a.x, b.x), std::max(a.y, b.y)} - grid.origin) / grid.size;
    const double reach = radius / grid.size;
    if (high.x + reach < 0 || high.y + reach < 0) return;
    for (int j = bounded(low.y - reach, grid.rows);
         j < std::min(grid.rows, bounded(high.y + reach, grid.rows) + 1); ++j)
        for (int i = bounded(low.x - reach, grid.columns);
             i < std::min(grid.columns, bounded(high.x + reach, grid.columns) + 1); ++i) {
            const std::size_t pixel = grid.pixel(i, j);
            const Vec2 p = grid.centre(pixel);
            const double t = square > 0 ? std::clamp(dot(p - a, way) / square, 0.0, 1.0) : 0;
            const Vec2 off = p - (a + t * way);
            if (dot(off, off) <= radius * radius + touching) visit(pixel, length(off));
        }
}

template <class Visit>
void for_printed_segments(const Toolpath& layer, const Visit& visit) {
    for (const Path& path : layer) {
        if (path.role == Role::travel) continue;
        for (std::size_t i = 1; i < path.points.size(); ++i)
            visit(flat(path.points[i - 1]), flat(path.points[i]), spacing(path.bead) / 2);
    }
}

}  // namespace

std::vector<double> printed_pixels(const Toolpath& layer, const PixelGrid& grid) {
    std::vector<double> solid(grid.pixels(), 0.0);
    for_printed_segments(layer, [&](Vec2 a, Vec2 b, double radius) {
        for_pixels_near(grid, a, b, radius, [&](std::size_t pixel, double) { solid[pixel] = 1; });
    });
    return solid;
}

double height_of(const Toolpath& layer) {
    for (const Path& path : layer)
        if (path.role != Role::travel) return path.bead.height;
    return 0;
}

std::vector<BeadDirection> bead_directions(const Toolpath& layer, const PixelGrid& grid) {
    std::vector<BeadDirection> directions(grid.pixels());
    for_printed_segments(layer, [&](Vec2 a, Vec2 b, double radius) {
        const double angle = std::atan2(b.y - a.y, b.x - a.x);
        for_pixels_near(grid, a, b, radius, [&](std::size_t pixel, double off) {
            BeadDirection& known = directions[pixel];
            if (known.off < 1e9F)
                known.is_crossed |=
                    std::abs(std::remainder(static_cast<double>(known.angle) - angle, pi)) >
                    other_direction;
            if (off >= static_cast<double>(known.off)) return;
            known.angle = static_cast<float>(angle);
            known.off = static_cast<float>(off);
        });
    });
    return directions;
}

}  // namespace bead
