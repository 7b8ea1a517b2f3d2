// Rational B-spline curves in the plane (NURBS): C(u) = Σ N_i w_i P_i / Σ N_i w_i, with the basis
// functions of Cox and de Boor. Derivatives follow from those of the numerator A and the weight w:
// C' = (A' - w' C) / w, C'' = (A'' - 2 w' C' - w'' C) / w (L. Piegl, W. Tiller, The NURBS Book,
// 1997, ch. 2 to 4). The last parameter belongs to the last span that is not empty.
//
//     const Nurbs quarter = nurbs_of(PlanarArc{.centre = {}, .radius = 17, .start = 0, .sweep = pi
//     / 2}); const double bend = curvature(curve_at(quarter, 0.5));  // 1/17 per mm
#pragma once
#include <vector>

#include "geom/arc.h"

namespace bead {

struct Nurbs {
    int degree = 3;               // 1 to 7
    std::vector<double> knots;    // never falling, points + degree + 1 of them
    Polyline points;              // mm, more than `degree`
    std::vector<double> weights;  // above 0, one per point
};

// Whether numbers and order are as above; what the functions below expect.
bool is_curve(const Nurbs& curve);

double first_parameter(const Nurbs& curve);
double last_parameter(const Nurbs& curve);

// Place, first and second derivative by the parameter, which is held to the curve's range.
struct CurvePlace {
    Vec2 point, first, second;
};
CurvePlace curve_at(const Nurbs& curve, double parameter);

// 1/mm, positive when it bends to the left; 0 where the curve stands still.
double curvature(const CurvePlace& place);

// The largest |curvature| at `samples` places of every span.
double peak_curvature(const Nurbs& curve, int samples = 64);

// Points of the curve whose chords stray at most `tolerance` (mm) from it: every quarter of a span
// halved until the middle of each part, and its quarters, lie that near to the chord. The
// tip of a cusp with a radius below the tolerance may be cut by more.
Polyline flattened(const Nurbs& curve, double tolerance);

// The arc itself, not an approximation: rational quadratics of at most a quarter turn each.
Nurbs nurbs_of(const PlanarArc& arc);

// A Bézier curve as one span from 0 to 1; 2 to 8 control points.
Nurbs bezier(Polyline points);

}  // namespace bead
