// Curves for laws: wild cubics with weights, the same for the same seed.
#pragma once
#include "geom/nurbs.h"
#include "support/regions.h"

namespace bead::test {

// A clamped cubic of 5 to 12 control points, weights 1 to 1.8, knots at random places.
inline Nurbs wild_cubic(RandomRegions& random, double size = 50) {
    const int n = random.whole(5, 12);
    Nurbs curve{3, {0, 0, 0, 0}, {}, {}};
    double knot = 0;
    for (int i = 0; i < n; ++i) {
        curve.points.push_back(random.point(size));
        curve.weights.push_back(random.uniform(1, 1.8));
        if (i >= 4) curve.knots.push_back(knot += random.uniform(0.5, 1.5));
    }
    curve.knots.insert(curve.knots.end(), 4, knot + 1);
    return curve;
}

inline Nurbs scaled(Nurbs curve, double factor) {
    for (Vec2& p : curve.points) p = factor * p;
    return curve;
}

}  // namespace bead::test
