#include "study/similar_case.h"

namespace bead {
namespace {

void stretch_line(Polyline& line, double scale) {
    for (Vec2& p : line) p = scale * p;
}

void stretch_circle(Circle& circle, double scale) {
    circle.centre = scale * circle.centre;
    circle.radius *= scale;
}

void stretch_place(Stretch& on, double scale) {
    on.from = scale * on.from;
    on.to = scale * on.to;
    if (on.arc) stretch_circle(on.arc->circle, scale);
}

void stretch_situation(Situation& situation, double scale) {
    for (Support& support : situation.supports) stretch_place(support.on, scale);
    for (Load& load : situation.loads) {
        stretch_place(load.on, scale);
        load.move *= scale;
    }
}

}  // namespace

LoadCase similar(LoadCase load_case, double scale) {
    if (scale == 1) return load_case;
    load_case.thickness *= scale;
    load_case.print.bead_width *= scale;
    load_case.print.layer_height *= scale;
    for (Polygon& polygon : load_case.part) {
        stretch_line(polygon.outer, scale);
        for (Polyline& hole : polygon.holes) stretch_line(hole, scale);
    }
    for (Circle& circle : load_case.circles) stretch_circle(circle, scale);
    for (Situation& situation : load_case.situations) stretch_situation(situation, scale);
    stretch_line(load_case.probes, scale);
    return load_case;
}

Layout similar(Layout layout, double scale) {
    if (scale != 1)
        for (LayoutLine& line : layout) stretch_line(line.points, scale);
    return layout;
}

Strength similar(Strength s, double scale) {
    const double square = scale * scale;
    s.volume *= scale * square;
    s.mass *= scale * square;
    s.covered *= square;
    s.stiffness *= scale;
    s.weakest = scale * s.weakest;
    for (double* load : {&s.failure_load, &s.buckling_load, &s.buckling_factor}) *load *= square;
    for (std::optional<double>* load : {&s.sideways_load, &s.peak_load, &s.anisotropic_load})
        if (*load) **load *= square;
    return s;
}

Reinforced similar(Reinforced found, double scale) {
    for (Candidate& candidate : found.candidates) {
        candidate.layout = similar(std::move(candidate.layout), scale);
        candidate.strength = similar(candidate.strength, scale);
    }
    found.stiffness_bound *= scale;
    return found;
}

}  // namespace bead
