#include "motion/line_times.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

#include "motion/planner.h"

namespace bead {
namespace {

Move straight(double x, double y, double feed) {
    Move move;
    move.to = {x, y, 0, 0};
    move.feed = feed;
    return move;
}

// Moves and dwells, some without length; every command has a line of its own.
std::vector<Command> any_program() {
    std::vector<Command> program;
    const auto count = *rc::gen::inRange(0, 60);
    for (int i = 0; i < count; ++i) {
        const std::int64_t line = program.empty() ? 1 : program.back().line;
        const auto number = [&](int most) { return double(*rc::gen::inRange(0, most)); };
        Command command{Drain{}, line + *rc::gen::inRange(1, 4)};
        switch (*rc::gen::inRange(0, 8)) {
            case 0:
                command.what = Dwell{number(3)};
                break;
            case 1:
                command.what = SetFan{1};
                break;
            case 2:
                break;
            default:
                command.what = straight(number(9), number(9), 20 + number(100));
        }
        program.push_back(command);
    }
    return program;
}

struct Timed {
    std::vector<double> at;
    double total = 0;
};

Timed timed(const std::vector<Command>& program, const std::vector<std::int64_t>& lines,
            const PlannerOptions& options) {
    Timed result;
    LineTimes times(lines);
    const auto planner = make_planner(Limits{}, options, [&](const MotionEvent& event) {
        times.add(event);
        if (const Block* block = std::get_if<Block>(&event)) result.total += duration(*block);
        if (const Dwell* dwell = std::get_if<Dwell>(&event)) result.total += dwell->duration;
    });
    for (const Command& command : program) {
        times.add(command);
        planner->add(command);
    }
    planner->finish();
    result.at = times.finish();
    return result;
}

PlannerOptions any_planner() {
    return {static_cast<Firmware>(*rc::gen::inRange<std::size_t>(0, firmware_names.size())), false,
            *rc::gen::element(0, 16)};
}

RC_GTEST_PROP(LineTimes, NeverRunBackAndEndWithThePrint, ()) {
    const std::vector<Command> program = any_program();
    std::vector<std::int64_t> lines(300);
    for (std::size_t i = 0; i < lines.size(); ++i) lines[i] = std::int64_t(i + 1);
    const Timed result = timed(program, lines, any_planner());
    RC_ASSERT(std::ranges::is_sorted(result.at));
    RC_ASSERT(result.at.front() == 0);
    RC_ASSERT(result.at.back() == result.total);
}

RC_GTEST_PROP(LineTimes, DoNotDependOnWhatElseIsAsked, ()) {
    const std::vector<Command> program = any_program();
    const PlannerOptions options = any_planner();
    std::vector<std::int64_t> lines;
    for (const Command& command : program) lines.push_back(command.line);
    const Timed all = timed(program, lines, options);
    for (std::size_t i = 0; i < lines.size(); i += 7)
        RC_ASSERT(timed(program, {lines[i]}, options).at.front() == all.at[i]);
}

// From a standstill to a standstill each, so the time of one does not depend on its neighbours.
RC_GTEST_PROP(LineTimes, AreTheSumOfWhatStandsBefore, ()) {
    const PlannerOptions options = any_planner();
    std::vector<Command> program;
    std::vector<std::int64_t> lines;
    double sum = 0;
    std::vector<double> sums;
    double at = 0;
    for (std::int64_t line = 1; line < 60; line += 3) {
        const double step = double(*rc::gen::inRange(0, 30));
        at += step;
        lines.insert(lines.end(), {line, line + 1, line + 2});
        program.push_back({straight(at, 0, 50), line});
        program.push_back({Dwell{2}, line + 1});
        const double alone =
            timed({{straight(at - step, 0, 50), 1}, {Drain{}, 2}, {straight(at, 0, 50), 3}}, {3},
                  options)
                .total -
            timed({{straight(at - step, 0, 50), 1}}, {}, options).total;
        sums.insert(sums.end(), {sum, sum + alone, sum + alone + 2});
        sum += alone + 2;
    }
    const Timed result = timed(program, lines, options);
    for (std::size_t i = 0; i < lines.size(); ++i)
        RC_ASSERT(std::abs(result.at[i] - sums[i]) < 1e-6);
}

}  // namespace
}  // namespace bead
