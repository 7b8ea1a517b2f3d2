#include "energy/course.h"

#include <gtest/gtest.h>

#include "support/blocks.h"
#include "support/power_twin.h"

namespace bead {
namespace {

using namespace test;

Printer warm_printer() {
    Printer printer;
    printer.power.hotend = {
        .heater = 40, .capacity = 12, .resistance_still = 20, .resistance_blown = 10};
    return printer;
}

TEST(Course, KnowsTimeHeatingAndFilament) {
    Course course(warm_printer(), {});
    course.add(SetHeat{Heater::hotend, 200, true});
    const double heating = course.heating();
    EXPECT_GT(heating, 50);
    for (int i = 0; i < 100; ++i) course.add(trapezoid({100, 0, 0, 5}, 0, 0, 80, 1000));
    course.add(Dwell{.duration = 10});
    const double moving = 100 * 1.33;
    EXPECT_NEAR(course.duration(), heating + moving + 10, 1e-9);
    EXPECT_EQ(course.heating(), heating);

    const double grams = 500 * pi / 4 * 1.75 * 1.75 * 1.24e-3;
    EXPECT_NEAR(course.at(1e9).filament, grams, 1e-9);
    EXPECT_NEAR(course.at(heating + moving / 2).filament, grams / 2, grams * 0.01);
    EXPECT_EQ(course.at(heating).filament, 0);
    EXPECT_NEAR(course.at(heating / 2).heating, heating / 2, 1e-9);
    EXPECT_EQ(course.at(-5).time, 0);
}

TEST(Course, OfWhatIsWarmAlreadyDoesNotWait) {
    Course course(warm_printer(), {});
    course.add(SetHeat{Heater::hotend, 200, true});
    const double once = course.heating();
    course.add(SetHeat{Heater::hotend, 200, true});
    EXPECT_EQ(course.heating(), once);
}

}  // namespace
}  // namespace bead
