// How a print goes on: when it heats up and when it lays down filament, for laying a power meter's
// log beside it.
//
//     Course course(machine.printer, machine.material);
//     Judge judge(machine, [&](const MotionEvent& event) { course.add(event); });
#pragma once
#include <vector>

#include "energy/meter.h"

namespace bead {

class Course {
  public:
    Course(const Printer& printer, const Material& material);
    void add(const MotionEvent& event);

    [[nodiscard]] double duration() const { return now_.time; }    // s, all of it
    [[nodiscard]] double heating() const { return now_.heating; }  // s of it

    struct Point {
        double time = 0;      // s since the start
        double heating = 0;   // s of it spent waiting for heaters
        double filament = 0;  // g, net of retractions
    };
    // Interpolated; the first or last point beyond the ends.
    [[nodiscard]] Point at(double time) const;

  private:
    void pass(double seconds, double heating, double filament);

    EnergyMeter meter_;  // knows how long heating up takes
    double grams_per_mm_;
    std::vector<Point> points_;  // times grow; about one a second
    Point now_;
};

}  // namespace bead
