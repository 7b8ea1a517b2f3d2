// A plot as SVG: axes with round steps, curves and points, a key. For the few plots that the
// program makes of its own results.
//
//     file.stream() << chart({.title = "…", .x = {"angle, °", 0, 90}, .y = {"%", -20, 20}, …});
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "geom/vec.h"

namespace bead {

struct ChartAxis {
    std::string name;  // with its unit
    double from = 0, to = 1;
    double step = 0;  // between marks; 0: some round one
};

enum class ChartMark { curve, dots, rings };
struct ChartSeries {
    std::string name;  // in the key; empty: not there
    std::string_view ink;
    ChartMark mark = ChartMark::curve;
    std::vector<Vec2> points;  // those outside the axes are left out, curves are broken there
};

struct Chart {
    std::string title;
    ChartAxis x, y;
    std::vector<ChartSeries> series;  // later ones lie on top
};

// Colours that can be told apart, dark enough for thin lines on white.
inline constexpr std::string_view chart_inks[]{"#b5702f", "#2c5a85", "#3f746c",
                                               "#86351d", "#7fb0dd", "#8674a0"};

// The same input gives the same bytes.
std::string chart(const Chart& chart);

}  // namespace bead
