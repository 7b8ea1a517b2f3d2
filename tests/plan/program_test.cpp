#include "plan/program.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "plan/plan.h"
#include "support/layers.h"

namespace bead {
namespace {

// The commands of a print, and its toolpath.
struct Printed {
    std::vector<Command> commands;
    Toolpath path;
};

constexpr int layers = 4;

Printed printed(const Region& region, const ProgramOptions& program, PlanOptions options = {}) {
    options.top_layers = options.bottom_layers = 1;
    const std::vector<LayerParts> parts = parts_of(shapes::prism(region, layers), options);
    const FillSpacing lines = matched_spacing(parts, options, {&options.pattern, 1});
    Printed result;
    Nozzle nozzle;
    append_start(result.commands, nozzle, program);
    for (const LayerParts& layer : parts) {
        const Toolpath path = plan_layer(layer, {options.pattern, layer_angle(0.3, layer.index)},
                                         lines, options, {nozzle.at[axis_x], nozzle.at[axis_y]});
        append_layer(result.commands, path, layer.z, layer.height, layer.index, nozzle, program);
        result.path.insert(result.path.end(), path.begin(), path.end());
    }
    append_end(result.commands, nozzle, program);
    return result;
}

// Calls visit(move, how far each axis goes).
template <class Visit>
void for_each_move(const std::vector<Command>& commands, const Visit& visit) {
    Position at{};
    for (const Command& command : commands) {
        if (const auto* set = std::get_if<SetPosition>(&command.what))
            for (std::size_t i = 0; i < axis_count; ++i) at[i] = set->to[i].value_or(at[i]);
        if (const auto* move = std::get_if<Move>(&command.what)) {
            Position way;
            for (std::size_t i = 0; i < axis_count; ++i) way[i] = move->to[i] - at[i];
            visit(*move, way);
            at = move->to;
        }
    }
}

template <class What>
std::vector<What> all_of(const std::vector<Command>& commands) {
    std::vector<What> found;
    for (const Command& command : commands)
        if (const auto* what = std::get_if<What>(&command.what)) found.push_back(*what);
    return found;
}

RC_GTEST_PROP(Program, FilamentIsTheVolumeThatIsDeposited, ()) {
    const Printed print = printed(shapes::star(*rc::gen::arbitrary<std::uint64_t>()), {});
    double filament = 0, asked = 0;
    for_each_move(print.commands, [&](const Move& move, const Position& way) {
        if (move.role != Role::travel) filament += way[axis_e];
    });
    for (const Path& path : print.path) asked += volume(path);
    RC_ASSERT(std::abs(filament * pi / 4 * 1.75 * 1.75 / asked - 1) < 1e-5);
}

RC_GTEST_PROP(Program, NumbersAreThoseThatTheirTextIsReadAs, ()) {
    const Printed print = printed(shapes::star(*rc::gen::arbitrary<std::uint64_t>()), {});
    for (const Move& move : all_of<Move>(print.commands)) {
        for (const Axis axis : {axis_x, axis_y, axis_z})
            RC_ASSERT(std::stod(fmt::format("{:.3f}", move.to[axis])) == move.to[axis]);
        RC_ASSERT(std::stod(fmt::format("{:.5f}", move.to[axis_e])) == move.to[axis_e]);
    }
}

RC_GTEST_PROP(Program, EveryRetractionIsMadeGoodBeforePrinting, ()) {
    const Printed print = printed(united(shapes::star(*rc::gen::arbitrary<std::uint64_t>()),
                                         shapes::rectangle({30, 30}, {40, 40})),
                                  {});
    double back = 0;
    int retractions = 0;
    for_each_move(print.commands, [&](const Move& move, const Position& way) {
        if (move.role != Role::travel) {
            RC_ASSERT(std::abs(back) < 1e-4);
            return;
        }
        if (way[axis_e] < 0) ++retractions;
        back = std::abs(back + way[axis_e]) < 2e-5 ? 0 : back + way[axis_e];
    });
    RC_ASSERT(std::abs(back + ProgramOptions{}.retract_length) < 1e-4);
    RC_ASSERT(retractions >= layers);
}

TEST(Program, MovesGoSomewhereAndNeverDown) {
    const Printed print = printed(shapes::star(7), {});
    for_each_move(print.commands, [](const Move& move, const Position& way) {
        EXPECT_NE(way, Position{});
        EXPECT_GE(way[axis_z], 0);
        EXPECT_GT(move.feed, 0);
    });
}

TEST(Program, LayersAreAnnouncedAndTheFanWaitsForTheSecond) {
    const Printed print = printed(shapes::star(7), {});
    EXPECT_EQ(all_of<LayerStart>(print.commands).size(), layers);
    std::vector<double> duties;
    for (const SetFan& fan : all_of<SetFan>(print.commands)) duties.push_back(fan.duty);
    EXPECT_EQ(duties, (std::vector<double>{0, 0, 1, 0}));
}

TEST(Program, AccelerationOfTheFirstLayerIsTakenBack) {
    PlanOptions options;
    options.first_layer_acceleration = 500;
    ProgramOptions program;
    program.limits.acceleration = 1250;
    const Printed print = printed(shapes::star(7), program, options);
    std::vector<double> asked;
    for (const SetLimits& limits : all_of<SetLimits>(print.commands))
        asked.push_back(limits.acceleration.value_or(0));
    EXPECT_EQ(asked, (std::vector<double>{1250, 500, 1250}));
    EXPECT_TRUE(all_of<SetLimits>(printed(shapes::star(7), {}, options).commands).empty());
}

TEST(Program, PointsThatRoundingMergesKeepTheirFilament) {
    const Bead bead{0.45, 0.2};
    Path path{Role::wall, bead, 30, 0, false, {{0, 0, 0.2}}};
    for (int i = 1; i <= 20000; ++i) path.points.push_back({i * 1e-4, 0, 0.2});
    Nozzle nozzle;
    std::vector<Command> commands;
    append_layer(commands, {path}, 0.2, 0.2, 3, nozzle, {});
    double filament = 0;
    long moves = 0;
    for_each_move(commands, [&](const Move& move, const Position& way) {
        if (move.role == Role::travel) return;
        filament += way[axis_e];
        ++moves;
    });
    EXPECT_EQ(moves, 2000);
    EXPECT_NEAR(filament * pi / 4 * 1.75 * 1.75, 2 * section(bead), 1e-4);
}

TEST(Program, StartsWarmAtHomeAndEndsCold) {
    std::vector<Command> commands;
    Nozzle nozzle;
    append_start(commands, nozzle, {});
    EXPECT_TRUE(all_of<SetLimits>(commands).empty());
    EXPECT_EQ(all_of<Home>(commands).size(), 1U);
    commands.clear();
    append_end(commands, nozzle, {});
    for (const SetHeat& heat : all_of<SetHeat>(commands)) EXPECT_EQ(heat.celsius, 0);
    EXPECT_EQ(all_of<SetHeat>(commands).size(), 2U);
    EXPECT_TRUE(nozzle.retracted);
}

}  // namespace
}  // namespace bead
