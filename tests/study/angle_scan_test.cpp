#include "study/angle_scan.h"

#include <gtest/gtest.h>

namespace bead {
namespace {

// Draws about what an i3 does.
Machine a_machine() {
    Machine machine;
    PowerModel& power = machine.printer.power;
    power.electronics = 9;
    power.supply_efficiency = 0.88;
    power.motors = {Motor{0.66, 0.0558, 2, 0.7, 0.7}, Motor{1.01, 0.0544, 3, 1.0, 0.7},
                    Motor{1.17, 0, 12, 1.5, 0.3}, Motor{2.19, 0, 30, 0.3, 0.5}};
    power.hotend = {38, 12.1, 20.5, 10.1};
    power.bed = {152, 450, 1.1, false};
    return machine;
}

double change(double value, double from) { return value / from - 1; }

struct Tilted {
    ModelEnergies straight, tilted;
};
Tilted tilted_by(double degrees, double from) {
    const Machine machine = a_machine();
    return {model_energies({patterns[0], from * pi / 180}, machine),
            model_energies({patterns[0], (from + degrees) * pi / 180}, machine)};
}

TEST(AngleScan, ShowsTheLoopholeOfThePublishedModelAtBothEnds) {
    for (const auto& [from, by] : {std::pair{0.0, 1.0}, {90.0, -1.0}}) {
        const auto [straight, tilted] = tilted_by(by, from);
        EXPECT_LT(change(tilted.published, straight.published), -0.12);
    }
}

TEST(AngleScan, IsSmoothAtBothEndsByPhysics) {
    for (const auto& [from, sign] : {std::pair{0.0, 1.0}, {90.0, -1.0}})
        for (const double by : {1.0, 2.0}) {
            const auto [straight, tilted] = tilted_by(sign * by, from);
            EXPECT_GT(change(tilted.xy_motors, straight.xy_motors), -0.01);
            EXPECT_GT(change(tilted.machine, straight.machine), -0.01);
            EXPECT_GT(change(tilted.standing, straight.standing), -0.01);
        }
}

TEST(SpeedScan, DiagonalsLoseWhenFastAndWinWhenSlowByThePublishedModel) {
    const std::array speeds{15.0, 80.0};
    const std::vector<SpeedPoint> points = speed_scan(speeds, a_machine());
    EXPECT_LT(points[0].diagonal.published, points[0].straight.published);
    EXPECT_GT(points[1].diagonal.published, points[1].straight.published);
}

TEST(SpeedScan, BreaksEvenWhereTheCoefficientsSay) {
    EXPECT_NEAR(break_even_speed(), 29.08, 0.01);
    const MotorCoefficients k;
    const double v = break_even_speed(k), way = 100;
    EXPECT_NEAR(k.c * way + k.h * way / v, k.c * way * std::sqrt(2.0), 1e-9);
}

}  // namespace
}  // namespace bead
