#include "fem/mesh_size.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace bead {
namespace {

struct Hit {
    double far = std::numeric_limits<double>::infinity();
    std::size_t loop = 0;
    double at = 0;
};

// The nearest boundary that a ray from inside meets.
Hit first_hit(const std::vector<MeasuredLoop>& loops, Vec2 from, Vec2 direction) {
    Hit best;
    for (std::size_t n = 0; n < loops.size(); ++n) {
        const Polyline& points = loops[n].points;
        for (std::size_t i = 0; i < points.size(); ++i) {
            const Vec2 a = points[i], side = points[(i + 1) % points.size()] - a;
            const double turn = cross(direction, side);
            if (std::abs(turn) < 1e-12 * length(side)) continue;
            const double far = cross(a - from, side) / turn;
            const double t = cross(a - from, direction) / turn;
            if (far < 1e-6 || far >= best.far || t < 0 || t > 1) continue;
            best = {far, n, loops[n].at[i] + t * length(side)};
        }
    }
    return best;
}

}  // namespace

double turn_at(const MeasuredLoop& loop, std::size_t i) {
    const std::size_t n = loop.points.size();
    const Vec2 in = loop.points[i] - loop.points[(i + n - 1) % n];
    const Vec2 out = loop.points[(i + 1) % n] - loop.points[i];
    return std::atan2(cross(in, out), dot(in, out));
}

SizeField::SizeField(const std::vector<MeasuredLoop>& loops, const MeshSizes& wanted)
    : wanted_(wanted) {
    for (std::size_t n = 0; n < loops.size(); ++n) {
        const MeasuredLoop& loop = loops[n];
        const std::size_t count = loop.points.size();
        for (std::size_t i = 0; i < count; ++i) {
            const double turn = std::abs(turn_at(loop, i));
            if (turn > corner_turn || turn < 1e-4) continue;
            const double sides = distance(loop.points[(i + count - 1) % count], loop.points[i]) +
                                 distance(loop.points[i], loop.points[(i + 1) % count]);
            add(loop.points[i], wanted.turn * sides / 2 / turn);
        }
        const int samples = std::max(8, int(std::ceil(loop.length / wanted.size)));
        for (int k = 0; k < samples; ++k) {
            const double at = loop.length * (k + 0.5) / samples;
            const Vec2 p = point_at(loop, at);
            const Vec2 along = point_at(loop, at + 1e-5 * loop.length) - p;
            if (length(along) == 0) continue;
            const Hit hit = first_hit(loops, p, left_of(along / length(along)));
            const double way = std::abs(hit.at - at);
            // At a sharp corner every ray is short.
            if (hit.loop == n && std::min(way, loop.length - way) < 3 * hit.far) continue;
            add(p, hit.far / wanted.across);
        }
    }
}

void SizeField::add(Vec2 place, double size) {
    size = std::max(size, wanted_.least * wanted_.size);
    if (size < 0.95 * wanted_.size && at(place) > 1.1 * size) sources_.push_back({place, size});
}

double SizeField::least() const {
    double size = wanted_.size;
    for (const Source& source : sources_) size = std::min(size, source.size);
    return size;
}

double SizeField::at(Vec2 p) const {
    double size = wanted_.size;
    for (const Source& source : sources_)
        size = std::min(size, source.size + wanted_.growth * distance(p, source.place));
    return size;
}

}  // namespace bead
