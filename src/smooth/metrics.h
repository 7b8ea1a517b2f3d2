// What can be said of a layer's line without a machine: lengths, points, turns, chords, volume.
// What is compared before and after smoothing, together with coverage.h and a time law.
//
//     const PathMetrics before = path_metrics(layer);
//
// Lengths in mm. Segments below 0.02 mm are passed over where turns are counted.
#pragma once
#include "geom/polygon.h"
#include "toolpath/path.h"

namespace bead {

struct PathMetrics {
    double length = 0;  // travel included
    double extruded = 0, travel = 0;
    PerRole<double> lengths{};
    double infill_length = 0;   // the infill and the travel that leads to it
    int points = 0;             // of the whole line, where paths meet once
    int infill_points = 0;      // where segments of that phase end
    int turning_points_30 = 0;  // turns by more than 30°, 45°, 60°
    int turning_points = 0;     // 45°
    int turning_points_60 = 0;
    int windowed_turning_points = 0;         // heading changes by more than 45° within 1 mm
    int windowed_infill_turning_points = 0;  // of the infill phase alone
    double mean_turn = 0;                    // rad, over all points
    double chord_error_mean = 0;             // mm, of Eq. 31: see sagitta()
    double volume = 0;                       // mm³
    int travels_crossing_walls = 0;
    double shortest_segment = 0;  // 0 if there is none
};

PathMetrics path_metrics(const Toolpath& layer);

// Eq. 31: how far the circle through three points rises above the chord from the first to the
// second; 0 if they are on a line. Large at a corner between long segments, where nothing is amiss.
double sagitta(Vec2 first, Vec2 second, Vec2 third);

// Over all triples of points in a row; 0 if there is none.
double mean_sagitta(const Polyline& line);

// Travels, as a whole each, that cut across the middle of a wall. Where they begin and end, within
// 0.05 mm, they may touch one.
int travels_crossing_walls(const Toolpath& layer);

}  // namespace bead
