#include "energy/course.h"

#include <algorithm>
#include <cmath>

namespace bead {
namespace {

constexpr double resolution = 1;  // s between points

}  // namespace

Course::Course(const Printer& printer, const Material& material)
    : meter_(printer, material),
      grams_per_mm_(pi / 4 * printer.filament * printer.filament * material.density * 1e-3),
      points_(1) {}

void Course::add(const MotionEvent& event) {
    if (const Block* block = std::get_if<Block>(&event)) {
        // To heaters a block is time; where motors go does not matter to how long they take.
        meter_.add(Dwell{.duration = bead::duration(*block)});
        pass(bead::duration(*block), 0, block->delta[axis_e] * grams_per_mm_);
        return;
    }
    meter_.add(event);
    if (const Dwell* dwell = std::get_if<Dwell>(&event)) pass(dwell->duration, 0, 0);
    if (std::holds_alternative<SetHeat>(event)) {
        const double waited = meter_.report().heat_up_duration - now_.heating;
        if (waited > 0) pass(waited, waited, 0);
    }
}

void Course::pass(double seconds, double heating, double filament) {
    const bool changes = heating > 0 || now_.time - points_.back().time >= resolution;
    if (changes && now_.time > points_.back().time) points_.push_back(now_);
    now_.time += seconds;
    now_.heating += heating;
    now_.filament += filament;
    if (heating > 0) points_.push_back(now_);
}

Course::Point Course::at(double time) const {
    const auto after = std::ranges::upper_bound(points_, time, {}, &Point::time);
    if (after == points_.begin()) return points_.front();
    const Point& before = *(after - 1);
    const Point& next = after == points_.end() ? now_ : *after;
    const double length = next.time - before.time;
    const double share = length > 0 ? std::clamp((time - before.time) / length, 0.0, 1.0) : 0;
    return {std::lerp(before.time, next.time, share),
            std::lerp(before.heating, next.heating, share),
            std::lerp(before.filament, next.filament, share)};
}

}  // namespace bead
