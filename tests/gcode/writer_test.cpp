#include "gcode/writer.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <locale>
#include <sstream>

#include "gcode/text.h"
#include "support/commands.h"

namespace bead {
namespace {

constexpr double tolerance = 1e-9;

std::string text_of(const std::vector<Command>& commands, const WriteOptions& options = {}) {
    std::ostringstream text;
    GcodeWriter writer(text, options);
    for (const Command& command : commands) writer.write(command);
    return text.str();
}

bool near(double a, double b) { return std::abs(a - b) <= tolerance; }
bool near(const std::optional<double>& a, const std::optional<double>& b) {
    return a.has_value() == b.has_value() && (!a || near(*a, *b));
}
template <class T>
bool near(const PerAxis<T>& a, const PerAxis<T>& b) {
    for (std::size_t axis = 0; axis < a.size(); ++axis)
        if (!near(a[axis], b[axis])) return false;
    return true;
}
bool near(const Bead& a, const Bead& b) {
    return near(a.width, b.width) && near(a.height, b.height);
}
bool near(const Move& a, const Move& b) {
    return near(a.to, b.to) && near(a.feed, b.feed) && a.role == b.role && near(a.bead, b.bead);
}
bool near(const Arc& a, const Arc& b) {
    return near(a.end, b.end) && near(a.centre[0], b.centre[0]) && near(a.centre[1], b.centre[1]) &&
           a.clockwise == b.clockwise && a.plane == b.plane && a.more_turns == b.more_turns;
}
bool near(const SetPosition& a, const SetPosition& b) { return near(a.to, b.to); }
bool near(const Home& a, const Home& b) { return a.axes == b.axes; }
bool near(const Dwell& a, const Dwell& b) { return near(a.duration, b.duration); }
bool near(const Drain&, const Drain&) { return true; }
bool near(const SetHeat& a, const SetHeat& b) {
    return a.heater == b.heater && near(a.celsius, b.celsius) && a.wait == b.wait;
}
bool near(const SetFan& a, const SetFan& b) { return near(a.duty, b.duty); }
bool near(const SetLimits& a, const SetLimits& b) {
    return near(a.max_acceleration, b.max_acceleration) && near(a.max_feedrate, b.max_feedrate) &&
           near(a.jerk, b.jerk) && near(a.acceleration, b.acceleration) &&
           near(a.retract_acceleration, b.retract_acceleration) &&
           near(a.travel_acceleration, b.travel_acceleration) &&
           near(a.junction_deviation, b.junction_deviation) &&
           near(a.max_velocity, b.max_velocity) &&
           near(a.max_acceleration_head, b.max_acceleration_head) &&
           near(a.square_corner_velocity, b.square_corner_velocity) &&
           near(a.minimum_cruise_ratio, b.minimum_cruise_ratio);
}
bool near(const LayerStart& a, const LayerStart& b) {
    return near(a.z, b.z) && near(a.height, b.height);
}

bool same(const Command& a, const Command& b) {
    if (a.what.index() != b.what.index()) return false;
    return std::visit(
        [&](const auto& what) {
            return near(what, std::get<std::decay_t<decltype(what)>>(b.what));
        },
        a.what);
}

RC_GTEST_PROP(Writer, is_undone_by_the_reader, (bool relative)) {
    const std::vector<Command> commands = stream_of(*stream_plans());
    const std::string text = text_of(commands, {.relative_e = relative});
    const Reading reading = reading_of(text);
    RC_LOG() << text;
    RC_ASSERT(reading.commands.size() == commands.size());
    for (std::size_t i = 0; i < commands.size(); ++i)
        RC_ASSERT(same(commands[i], reading.commands[i]));
    RC_ASSERT(reading.report.ignored.empty());
    RC_ASSERT(reading.report.malformed == 0);
}

// Arcs in every plane, with and without an end elsewhere, between moves and G92.
std::vector<Command> arcs_of(const std::vector<StreamStep>& steps) {
    std::vector<Command> commands;
    Position at{};
    for (const StreamStep& step : steps) {
        Arc arc{.end = {},
                .centre = {step.x * 1e-3 + 500, step.y * 1e-3},
                .clockwise = step.choice % 2 == 0,
                .plane = Plane(step.choice % 3),
                .more_turns = step.choice % 5 == 0 ? step.choice % 7 : 0};
        if (step.kind % 4 != 0) at = {step.y * 1e-3, step.x * 1e-3, step.z * 1e-3, at[axis_e]};
        const bool extrudes = step.kind % 3 == 0;
        if (extrudes) at[axis_e] += step.e * 1e-5;
        arc.end = {at, 10, extrudes ? Role::wall : Role::travel, {}};
        commands.push_back({arc, 0});
        if (step.kind == 7) {
            at[axis_x] = 0.5;
            commands.push_back({SetPosition{{0.5, {}, {}, {}}}, 0});
        }
    }
    commands.push_back({Home{}, 0});
    return commands;
}

RC_GTEST_PROP(Writer, is_undone_by_the_reader_for_arcs, (bool relative)) {
    const std::vector<Command> commands = arcs_of(*stream_plans());
    const Reading reading =
        reading_of(text_of(commands, {.relative_e = relative}), Firmware::marlin_jd);
    RC_ASSERT(reading.commands.size() == commands.size());
    for (std::size_t i = 0; i < commands.size(); ++i)
        RC_ASSERT(same(commands[i], reading.commands[i]));
    RC_ASSERT(reading.report.malformed == 0);
}

TEST(Writer, is_undone_by_the_reader_for_each_firmwares_limits) {
    SetLimits marlin;
    marlin.jerk[axis_x] = 7.5;
    marlin.junction_deviation = 0.01234;
    const SetLimits klipper{.max_velocity = 300,
                            .max_acceleration_head = 5000,
                            .square_corner_velocity = 5.5,
                            .minimum_cruise_ratio = 0.125};
    for (const auto& [limits, firmware] :
         {std::pair{marlin, Firmware::marlin_jd}, {klipper, Firmware::klipper}}) {
        const Reading reading = reading_of(text_of({{Home{}, 0}, {limits, 0}}), firmware);
        EXPECT_TRUE(near(reading.last<SetLimits>(), limits)) << name_of(firmware);
    }
}

RC_GTEST_PROP(Writer, writes_what_it_wrote_when_read, (bool relative)) {
    const WriteOptions options{.relative_e = relative};
    const std::string text = text_of(stream_of(*stream_plans()), options);
    RC_ASSERT(text_of(reading_of(text).commands, options) == text);
}

TEST(Writer, does_not_drift) {
    std::vector<Command> commands;
    Move move;
    move.role = Role::wall;
    move.feed = 10;
    for (int i = 1; i <= 30'000; ++i) {
        move.to[axis_x] = i % 2;
        move.to[axis_e] = i * 0.033333333;
        commands.push_back({move, 0});
    }
    for (const bool relative : {false, true}) {
        const Move last = reading_of(text_of(commands, {.relative_e = relative})).last<Move>();
        EXPECT_NEAR(last.to[axis_e], move.to[axis_e], 0.5e-5 + tolerance);
    }
}

TEST(Writer, writes_short_lines_that_a_slicers_user_knows) {
    Move move;
    move.to = {10, -0.5, 0.2, 0};
    move.feed = 130;
    std::vector<Command> commands{{Home{}, 0}, {LayerStart{0.2, 0.2}, 0}, {move, 0}};
    move = {{20, -0.5, 0.2, 1.5}, 130, Role::outer_wall, {0.45, 0.2}};
    commands.push_back({move, 0});
    move.to[axis_x] = 20.0625;
    move.to[axis_e] = 1.5123456;
    move.feed = 12.3456;
    commands.push_back({move, 0});
    EXPECT_EQ(text_of(commands, {.header = "one\ntwo"}),
              "; one\n; two\nG21\nG90\nM83\nG28\n;LAYER_CHANGE\n;Z:0.2\n;HEIGHT:0.2\n"
              "G1 X10 Y-0.5 Z0.2 F7800\n;TYPE:External perimeter\n;WIDTH:0.45\nG1 X20 E1.5\n"
              "G1 X20.063 E0.01235 F740.736\n");
}

TEST(Writer, tells_arcs_by_their_centre_from_the_start) {
    const Move quarter{{10, 10, 0, 0.5}, 10, Role::wall, {0.45, 0.2}};
    const Move rise{{10, 20, 10, 0.5}, 10, Role::travel, {}};
    EXPECT_EQ(text_of({{Arc{quarter, {10, 0}, true, Plane::xy, 0}, 0},
                       {Arc{rise, {10, 10}, false, Plane::yz, 2}, 0}},
                      {.header = ""}),
              "G21\nG90\nM83\n;TYPE:Perimeter\n;WIDTH:0.45\n;HEIGHT:0.2\n"
              "G2 I10 J0 X10 Y10 E0.5 F600\nG19\nG3 J0 K10 P2 Y20 Z10\n");
}

TEST(Writer, tells_each_firmwares_limits) {
    SetLimits marlin;
    marlin.jerk[axis_e] = 5;
    marlin.junction_deviation = 0.0135;
    const SetLimits klipper{.max_velocity = 300,
                            .max_acceleration_head = 5000,
                            .square_corner_velocity = 5.5,
                            .minimum_cruise_ratio = 0.125};
    EXPECT_EQ(text_of({{marlin, 0}, {klipper, 0}}, {.header = ""}),
              "G21\nG90\nM83\nM205 E5 J0.0135\n"
              "SET_VELOCITY_LIMIT VELOCITY=300 ACCEL=5000 SQUARE_CORNER_VELOCITY=5.5 "
              "MINIMUM_CRUISE_RATIO=0.125\n");
}

struct Commas : std::numpunct<char> {
    [[nodiscard]] char do_decimal_point() const override { return ','; }
    [[nodiscard]] char do_thousands_sep() const override { return '.'; }
    [[nodiscard]] std::string do_grouping() const override { return "\3"; }
};

TEST(Writer, knows_no_locale) {
    const std::vector<Command> commands{{Move{{1234.5, 0, 0.25, 0}, 2000, Role::travel, {}}, 0}};
    std::ostringstream text;
    text.imbue(std::locale(std::locale::classic(), new Commas));
    GcodeWriter(text, {}).write(commands[0]);
    EXPECT_EQ(text.str(), text_of(commands));
}

TEST(Writer, leaves_out_what_changes_nothing) {
    const std::string empty = text_of({});
    EXPECT_EQ(text_of({{Move{}, 0}, {SetPosition{}, 0}, {SetLimits{}, 0}}), empty);
}

}  // namespace
}  // namespace bead
