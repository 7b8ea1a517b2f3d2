// A smooth cubic near to many points: least squares, with as few knots as the tolerance allows
// (L. Piegl, W. Tiller, The NURBS Book, 1997, ch. 9). Points get parameters by the square roots of
// their distances (E. Lee 1989), which calms uneven spacing; a knot is put into the span that
// strays most until none strays by more than the tolerance.
//
//     if (const auto fit = fitted_curve(noisy_line, 0.01)) … flattened(fit->curve, 0.001) …
#pragma once
#include <optional>

#include "geom/nurbs.h"

namespace bead {

struct CurveFit {
    Nurbs curve;           // of weights 1, through the first and the last point
    double deviation = 0;  // mm, the largest distance of a point from the curve at its parameter
};

// At least four points, no two neighbours alike. None when as many knots as points were not enough.
std::optional<CurveFit> fitted_curve(const Polyline& points, double tolerance);

}  // namespace bead
