// Regions for laws: random ones that are the same for the same seed, and a few plain shapes.
#pragma once
#include <algorithm>
#include <random>
#include <vector>

#include "geom/clip.h"

namespace bead::test {

inline Region rectangle(Vec2 low, Vec2 high) {
    return {{{low, {high.x, low.y}, high, {low.x, high.y}}, {}}};
}

inline Region square(double side) {
    return rectangle({-side / 2, -side / 2}, {side / 2, side / 2});
}

inline Polyline regular(Vec2 centre, double radius, int corners, double angle = 0) {
    Polyline loop;
    for (int i = 0; i < corners; ++i)
        loop.push_back(centre + radius * unit(angle + 2 * pi * i / corners));
    return loop;
}

inline Region disc(Vec2 centre, double radius, int corners = 64) {
    return {{regular(centre, radius, corners), {}}};
}

inline Region ring(double outer, double inner) {
    return difference(disc({}, outer), disc({}, inner));
}

inline Region ell(double side, double leg) {
    return {{{{0, 0}, {side, 0}, {side, leg}, {leg, leg}, {leg, side}, {0, side}}, {}}};
}

class RandomRegions {
  public:
    explicit RandomRegions(unsigned seed) : random_(seed) {}

    double uniform(double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random_);
    }
    int whole(int low, int high) { return std::uniform_int_distribution<int>(low, high)(random_); }
    Vec2 point(double reach) { return {uniform(-reach, reach), uniform(-reach, reach)}; }

    // Corners at rising angles and random distances: simple, rarely convex.
    Region star(Vec2 centre, double radius) {
        const int corners = whole(3, 40);
        Polyline loop;
        for (int i = 0; i < corners; ++i)
            loop.push_back(centre + uniform(0.3, 1.0) * radius *
                                        unit(2 * pi * (i + uniform(0.0, 0.9)) / corners));
        return region_of({loop}, FillRule::even_odd);
    }

    Region convex(Vec2 centre, double radius) {
        std::vector<double> angles;
        for (int i = whole(3, 12); i > 0; --i) angles.push_back(uniform(0, 2 * pi));
        std::sort(angles.begin(), angles.end());
        Polyline loop;
        for (const double angle : angles) loop.push_back(centre + radius * unit(angle));
        return {{loop, {}}};
    }

    Region star_with_holes(Vec2 centre, double radius) {
        Region region = star(centre, radius);
        for (int i = whole(0, 6); i > 0; --i)
            region = difference(region,
                                star(centre + point(0.6 * radius), radius * uniform(0.02, 0.25)));
        return region;
    }

    Region sliver(Vec2 centre, double span) {
        const double width = span * uniform(1e-4, 0.02);
        return moved(rectangle({-span / 2, -width / 2}, {span / 2, width / 2}), uniform(0, 2 * pi),
                     {}, centre);
    }

    // Any of the above, a ring, an L, or several islands; about 10 to 60 mm across.
    Region any() {
        const double size = uniform(10, 60);
        const Vec2 centre = point(30);
        switch (whole(0, 6)) {
            case 0:
                return star(centre, size / 2);
            case 1:
                return convex(centre, size / 2);
            case 2:
                return sliver(centre, size);
            case 3:
                return moved(ring(size / 2, size * uniform(0.05, 0.48)), 0, {}, centre);
            case 4:
                return moved(ell(size, size * uniform(0.05, 0.9)), uniform(0, 2 * pi), {}, centre);
            case 5:
                return united(
                    united(star(centre, size / 3), star_with_holes(centre + point(40), size / 3)),
                    sliver(centre + point(40), size));
            default:
                return star_with_holes(centre, size / 2);
        }
    }

  private:
    std::mt19937_64 random_;
};

}  // namespace bead::test
