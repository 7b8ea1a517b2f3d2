#include "smooth/engine_block.h"

#include <algorithm>

#include "core/expects.h"
#include "geom/clip.h"

namespace bead {
namespace {

constexpr Vec2 centre{171, 112};
constexpr double half = 97, corner_radius = 6, pitch = 44;

Polyline polygon(Vec2 middle, double radius, int corners) {
    Polyline loop;
    for (int i = 0; i < corners; ++i) loop.push_back(middle + radius * unit(2 * pi * i / corners));
    return loop;
}

Polyline box(Vec2 middle, double width, double height) {
    const Vec2 a{width / 2, height / 2}, b{width / 2, -height / 2};
    return {middle - a, middle + b, middle + a, middle - b};
}

// A quarter of a circle at every corner, in six chords.
Polyline rounded_square() {
    constexpr int chords = 6;
    constexpr double inner = half - corner_radius;
    Polyline loop;
    for (int corner = 0; corner < 4; ++corner) {
        const Vec2 out = std::sqrt(2.0) * unit(pi / 4 + corner * pi / 2);
        for (int i = 0; i <= chords; ++i)
            loop.push_back(centre + inner * out +
                           corner_radius * unit(corner * pi / 2 + i * pi / 2 / chords));
    }
    return loop;
}

void add_holes(std::vector<Polyline>& holes, int per_row, double radius, int corners) {
    for (int i = 0; i < per_row; ++i)
        for (int j = 0; j < per_row; ++j) {
            const Vec2 place = pitch * Vec2{i - (per_row - 1) / 2.0, j - (per_row - 1) / 2.0};
            holes.push_back(polygon(centre + place, radius, corners));
        }
}

// Half-way between neighbouring bores, across the line that joins them.
void add_coolant_slots(std::vector<Polyline>& holes, double length, double width) {
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 3; ++j) {
            const double along = (i - 1.5) * pitch, between = (j - 1) * pitch;
            holes.push_back(box(centre + Vec2{along, between}, length, width));
            holes.push_back(box(centre + Vec2{between, along}, width, length));
        }
}

}  // namespace

Region engine_block(int height_percent) {
    BEAD_EXPECTS(std::ranges::count(engine_block_heights, height_percent) == 1);
    std::vector<Polyline> holes;
    add_holes(holes, 4, 17, 75);
    add_holes(holes, 5, 4, 24);
    if (height_percent == 25) add_coolant_slots(holes, 16, 3.5);
    if (height_percent == 50) add_coolant_slots(holes, 12, 4.5);
    if (height_percent == 15)
        for (const double side : {-80.5, 80.5})
            holes.push_back(box(centre + Vec2{side, 0}, 3.2, 120));
    return difference({{rounded_square(), {}}}, region_of(holes, FillRule::positive));
}

}  // namespace bead
