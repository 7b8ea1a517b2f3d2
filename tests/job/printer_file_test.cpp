#include "job/printer_file.h"

#include <gtest/gtest.h>

#include "core/error.h"
#include "energy/interval.h"
#include "energy/meter.h"
#include "job/material_file.h"
#include "support/blocks.h"
#include "support/scratch_file.h"

namespace bead {
namespace {

using namespace test;

// All keys that a printer file of somebody else's may rely on, at other values than the usual
// printer's.
constexpr std::string_view every_limit = R"(
kinematics = "corexy"
bed_mm = [300, 200, 100]
nozzle_mm = 0.6
filament_mm = 2.85
[limits]
steps_per_mm = [80, 81, 401, 93]
max_feedrate_mm_s = [500, 501, 5, 25]
max_acceleration_mm_s2 = [500, 501, 100, 5001]
acceleration_mm_s2 = 502
retract_acceleration_mm_s2 = 503
travel_acceleration_mm_s2 = 504
jerk_mm_s = [8, 9, 0.3, 5]
junction_deviation_mm = 0.02
square_corner_velocity_mm_s = 6
minimum_cruise_ratio = 0.4
extrude_only_velocity_mm_s = 51
extrude_only_acceleration_mm_s2 = 52
instantaneous_corner_velocity_mm_s = 1.5
arc_resolution_mm = 0.5
drop_segments_steps = 0
slowdown = true
[vibration]
frequency_hz = [9, 13]
damping_ratio = [0.03, 0.05]
)";

std::string printer_complaint(const std::string& text) {
    const ScratchFile file("printer.toml", text);
    try {
        load_printer(file.path());
    } catch (const Error& e) {
        EXPECT_EQ(e.fault(), Fault::input);
        return e.what();
    }
    return "none";
}

TEST(PrinterFile, ReadsEveryKeyOfTheContract) {
    const ScratchFile file("mine.toml", every_limit);
    const Printer p = load_printer(file.path());
    EXPECT_EQ(p.kinematics, Kinematics::corexy);
    EXPECT_EQ(p.bed, (std::array<double, 3>{300, 200, 100}));
    EXPECT_EQ(p.nozzle, 0.6);
    EXPECT_EQ(p.filament, 2.85);
    const Limits& l = p.limits;
    EXPECT_EQ(l.steps_per_mm, (std::array<double, 4>{80, 81, 401, 93}));
    EXPECT_EQ(l.max_feedrate, (std::array<double, 4>{500, 501, 5, 25}));
    EXPECT_EQ(l.max_acceleration, (std::array<double, 4>{500, 501, 100, 5001}));
    EXPECT_EQ(l.acceleration, 502);
    EXPECT_EQ(l.retract_acceleration, 503);
    EXPECT_EQ(l.travel_acceleration, 504);
    EXPECT_EQ(l.jerk, (std::array<double, 4>{8, 9, 0.3, 5}));
    EXPECT_EQ(l.junction_deviation, 0.02);
    EXPECT_EQ(l.square_corner_velocity, 6);
    EXPECT_EQ(l.minimum_cruise_ratio, 0.4);
    EXPECT_EQ(l.extrude_only_velocity, 51);
    EXPECT_EQ(l.extrude_only_acceleration, 52);
    EXPECT_EQ(l.instantaneous_corner_velocity, 1.5);
    EXPECT_EQ(l.arc_resolution, 0.5);
    EXPECT_EQ(l.drop_segments, 0);
    EXPECT_TRUE(l.slowdown);
}

TEST(PrinterFile, DeltaHasItsOwnGeometryOrTheUsualProportions) {
    const ScratchFile told("told.toml",
                           "kinematics = \"delta\"\n"
                           "[delta]\nradius_mm = 150\narm_mm = 300\nhead_mass_kg = 0.2\n");
    const Delta mine = load_printer(told.path()).delta;
    EXPECT_EQ(mine.radius, 150);
    EXPECT_EQ(mine.arm, 300);
    EXPECT_EQ(mine.head_mass, 0.2);
    const ScratchFile silent("silent.toml", "kinematics = \"delta\"\nbed_mm = [200, 200, 300]\n");
    const Printer usual = load_printer(silent.path());
    EXPECT_GT(usual.delta.arm, usual.delta.radius + 100);  // reaches the far edge
    EXPECT_EQ(middle_of_bed(usual), (Vec2{0, 0}));
}

TEST(PrinterFile, LeftEmptyIsTheUsualPrinter) {
    const ScratchFile file("mine.toml", "");
    const Printer mine = load_printer(file.path()), usual = load_printer("prusa-mk3s");
    EXPECT_EQ(mine.bed, usual.bed);
    EXPECT_EQ(mine.limits.max_feedrate, usual.limits.max_feedrate);
    EXPECT_EQ(mine.power.hotend.capacity, usual.power.hotend.capacity);
    EXPECT_EQ(mine.power.motors[axis_x].per_speed, usual.power.motors[axis_x].per_speed);
    EXPECT_NE(mine.name, usual.name);
}

TEST(PrinterFile, UsualPrinterIsTheOneOfTheDefaultLimits) {
    const Limits file = load_printer("prusa-mk3s").limits, built_in;
    EXPECT_EQ(file.steps_per_mm, built_in.steps_per_mm);
    EXPECT_EQ(file.max_feedrate, built_in.max_feedrate);
    EXPECT_EQ(file.max_acceleration, built_in.max_acceleration);
    EXPECT_EQ(file.acceleration, built_in.acceleration);
    EXPECT_EQ(file.travel_acceleration, built_in.travel_acceleration);
    EXPECT_EQ(file.jerk, built_in.jerk);
}

TEST(PrinterFile, NamesFileLineAndNearestKeyOfWhatItDoesNotKnow) {
    const std::string text = printer_complaint("nozzle_mm = 0.4\n[limits]\nmax_acceleration = 5\n");
    EXPECT_NE(text.find("printer.toml:3: limits.max_acceleration is not a key"), text.npos) << text;
    EXPECT_NE(text.find("did you mean limits.max_acceleration_mm_s2?"), text.npos) << text;
    EXPECT_NE(printer_complaint("[prices]\nfilament = 20\n").find(":1: prices"), text.npos);
}

TEST(PrinterFile, RefusesWhatCannotBe) {
    struct Wrong {
        const char* text;
        const char* says;
    };
    for (const Wrong& wrong : {
             Wrong{"nozzle_mm = \"fine\"", "nozzle_mm must be a number"},
             Wrong{"nozzle_mm = -0.4", "nozzle_mm is -0.4 but must be above 0"},
             Wrong{"nozzle_mm = nan", "must be above 0"},
             Wrong{"bed_mm = [200, 200]", "bed_mm must be an array of 3 numbers"},
             Wrong{"bed_mm = [200, 200, \"high\"]", "bed_mm must be a number"},
             Wrong{"kinematics = \"scara\"", "must be one of cartesian, corexy, corexz, delta"},
             Wrong{"kinematics = 3", "kinematics must be text"},
             Wrong{"limits = 5", "limits must be a table"},
             Wrong{"[limits]\nslowdown = 1", "must be true or false"},
             Wrong{"[limits]\ndrop_segments_steps = 1.5", "must be a whole number"},
             Wrong{"[limits]\njerk_mm_s = [10, 10, inf, 5]", "must be at least"},
             Wrong{"[power]\nsupply_efficiency = 1.5", "above 0 and at most 1"},
             Wrong{"[power.bed]\nresistance_k_w = 0", "must be above 0"},
             Wrong{"[delta]\nradius_mm = 100\narm_mm = 100",
                   "delta.arm_mm is 100 but must be above"},
             Wrong{"nozzle_mm = = 4", ":1: not valid TOML"},
         })
        EXPECT_NE(printer_complaint(wrong.text).find(wrong.says), std::string::npos)
            << wrong.text << "\n"
            << printer_complaint(wrong.text);
}

TEST(PrinterFile, ThatIsNotThereIsBadInputAndAnUnknownNameIsWrongUsage) {
    EXPECT_THROW(load_printer("nowhere/printer.toml"), Error);
    const std::string folder = testing::TempDir() + "/folder.toml";
    std::filesystem::create_directory(folder);
    EXPECT_THROW(load_printer(folder), Error);
    std::filesystem::remove(folder);
    try {
        load_printer("ender-3");
        FAIL();
    } catch (const Error& e) {
        EXPECT_EQ(e.fault(), Fault::usage);
        const std::string text = e.what();
        for (const std::string& name : printer_names())
            EXPECT_NE(text.find(name), text.npos) << text;
        EXPECT_NE(text.find("did you mean ender3?"), text.npos) << text;
    }
}

// Heated up as the maker's start does, then lines of 30 mm at 60 mm/s, 3.6 mm³/s.
EnergyReport printing(const Printer& printer, const Material& material, double fan) {
    EnergyMeter meter(printer.power, material, printer.filament);
    meter.add(SetHeat{Heater::hotend, material.hotend, false});
    meter.add(SetHeat{Heater::bed, material.bed, true});
    meter.add(SetHeat{Heater::hotend, material.hotend, true});
    meter.add(SetFan{fan});
    meter.add(LayerStart{0.2, 0.2});
    const double filament = 30 * 0.45 * 0.2 / (pi / 4 * printer.filament * printer.filament);
    for (int i = 0; i < 1000; ++i)
        meter.add(trapezoid({i % 2 == 0 ? 30. : -30., 2, 0, filament}, 5, 5, 60, 1000));
    return meter.report();
}

double mean_power(const EnergyReport& report) {
    return report.by_layer.at(0).total / report.by_layer.at(0).duration;
}

// Its maker says 80 W with PLA and 120 W with ABS.
TEST(PrusaMk3s, DrawsWhatItsMakerSays) {
    const Printer printer = load_printer("prusa-mk3s");
    const EnergyReport pla = printing(printer, load_material("pla"), 1);
    EXPECT_NEAR(mean_power(pla), 80, 12);
    EXPECT_NEAR(mean_power(printing(printer, load_material("abs"), 0)), 120, 18);
    const double supplied = pla.peak_power * printer.power.supply_efficiency;
    EXPECT_TRUE(supplied > 190 && supplied < 240);  // bed and nozzle; what the supply is made for
}

// Prusa's firmware models this heater with 38 W, 12.1 J/K and 20.5 to 10.1 K/W.
TEST(PrusaMk3s, HeatsAsItsFirmwareSays) {
    const PowerModel power = load_printer("prusa-mk3s").power;
    const auto steady = [&](double duty) {
        EnergyMeter meter(power, load_material("pla"), 1.75);
        meter.add(SetHeat{Heater::hotend, 215, true});
        meter.add(SetFan{duty});
        const double warm = meter.report().energy.hotend;
        meter.add(Dwell{100});
        return (meter.report().energy.hotend - warm) * power.supply_efficiency / 100;
    };
    EXPECT_NEAR(steady(0), 9.3, 0.05);
    EXPECT_NEAR(steady(1), 18.8, 0.05);
    EnergyMeter meter(power, load_material("pla"), 1.75);
    meter.add(SetHeat{Heater::hotend, 215, true});
    const EnergyReport hot = meter.report();
    const double stored = 12.1 * 190, least = stored / 38;
    EXPECT_NEAR(hot.terms.hotend.stored, stored, 1e-6);
    EXPECT_GT(hot.terms.hotend.lost, 0.5 * 9.3 * least);  // half of what it loses when hot
    EXPECT_LT(hot.terms.hotend.lost, 9.3 * hot.heat_up_duration);
    EXPECT_NEAR(hot.energy.hotend * power.supply_efficiency, 38 * hot.heat_up_duration, 1e-6);
}

TEST(PrusaMk3s, HoldsWithWhatItRunsWith) {
    const PowerModel power = load_printer("prusa-mk3s").power;
    for (const Motor& motor : power.motors) EXPECT_DOUBLE_EQ(holding(motor), motor.standing);
    EXPECT_NEAR((power.motors[0].standing + power.motors[1].standing) / 2, 0.833, 0.001);
    EXPECT_EQ(power.bed_axis, std::size_t{axis_y});
}

TEST(Windings, ComeFromCurrentsOrFromWatts) {
    const Printer mk3s = load_printer("prusa-mk3s");
    const auto set = [&](const std::string& text) {
        return with_setting(mk3s, text).printer.power;
    };
    const PowerModel strong = set("power.motors.run_current_a=[1,1,1,1]");
    EXPECT_NEAR(strong.motors[0].standing, 2 * 3.49, 1e-12);
    EXPECT_NEAR(holding(strong.motors[0]), 2 * 3.49, 1e-12);
    const PowerModel saving = set("power.motors.hold_current_a=[0.1,0.1,0.1,0.1]");
    EXPECT_NEAR(saving.motors[0].standing, mk3s.power.motors[0].standing, 1e-12);
    EXPECT_NEAR(holding(saving.motors[0]), 0.0698, 1e-12);
    const PowerModel watts = set("power.motors.standing_w=[2,2,2,2]");
    EXPECT_EQ(watts.motors[3].standing, 2);
    EXPECT_EQ(holding(watts.motors[3]), 2);
    EXPECT_EQ(holding(set("power.motors.holding_w=[0.1,0.2,0.3,0.4]").motors[3]), 0.4);
    EXPECT_FALSE(set("power.motors.bed_axis=none").bed_axis);
}

TEST(Windings, ThatMakeNoSenseAreRefused) {
    const Printer mk3s = load_printer("prusa-mk3s");
    EXPECT_THROW(with_setting(mk3s, "power.motors.hold_current_a=[9,9,9,9]"), Error);
    EXPECT_THROW(with_setting(mk3s, "power.motors.holding_w=[9,9,9,9]"), Error);
    EXPECT_THROW(with_setting(mk3s, "power.motors.winding_ohm=[0,1,1,1]"), Error);
    EXPECT_THROW(with_setting(load_printer("ender3"), "power.motors.winding_ohm=[1,1,1,1]"), Error);
    EXPECT_THROW(with_setting(load_printer("kossel"), "power.motors.bed_axis=y"), Error);
    EXPECT_THROW(with_setting(mk3s, "power.motors.standstill_delay_s=-1"), Error);
}

TEST(BuiltInPrinters, AreCompleteAndCanPrint) {
    const std::vector<std::string> names = printer_names();
    for (const char* name : {"prusa-mk3s", "ender3", "voron-corexy", "ldam-1000"})
        EXPECT_NE(std::ranges::find(names, name), names.end()) << name;
    for (const std::string& name : names) {
        const Printer printer = load_printer(name);
        EXPECT_EQ(printer.name, name);
        const EnergyReport report = printing(printer, load_material("pla"), 0.5);
        const Energy& e = report.energy;
        for (const double joules : {e.bed, e.hotend, e.motors, e.fans, e.electronics})
            EXPECT_GT(joules, 0) << name;
        EXPECT_LT(report.heat_up_duration, 3600) << name;
        const Interval interval = interval_95(e, printer.power);
        EXPECT_LT(interval.low, 0.95 * total(e)) << name;
        EXPECT_GT(interval.low, 0) << name;
    }
}

}  // namespace
}  // namespace bead
