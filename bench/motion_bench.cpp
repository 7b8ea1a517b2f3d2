// Blocks per second of every planner, and lines and bytes per second of all that `simulate` does:
// read, plan, sum up times and the motors' features. The text is like a slicer's (short extruding
// chords, a travel every 40); BEAD_GCODE names a file to take instead.
#include <benchmark/benchmark.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

#include "energy/published.h"
#include "gcode/reader.h"
#include "gcode/writer.h"
#include "motion/planner.h"
#include "motion/totals.h"

namespace {

using namespace bead;

constexpr int moves = 500'000;

std::vector<Command> wavy_print() {
    std::vector<Command> commands{{LayerStart{.z = 0.2, .height = 0.2}, 0}};
    Position at{};
    for (int i = 0; i < moves; ++i) {
        const bool travel = i % 40 == 0;
        const double turn = 0.004 * i + (travel ? 0.5 : 0.0);
        at[axis_x] = 125 + 50 * std::cos(turn) + 0.3 * std::cos(7 * turn);
        at[axis_y] = 105 + 50 * std::sin(turn);
        at[axis_z] = 0.2;
        at[axis_e] += travel ? 0 : 0.0072;
        Move move;
        move.to = at;
        move.feed = travel ? 130 : 45;
        move.role = travel ? Role::travel : i % 1000 < 500 ? Role::wall : Role::infill;
        commands.push_back({move, 0});
    }
    return commands;
}

std::string text_of(const std::vector<Command>& commands) {
    std::ostringstream text;
    GcodeWriter writer(text, {});
    for (const Command& command : commands) writer.write(command);
    return text.str();
}

std::string text_to_read() {
    const char* const file = std::getenv("BEAD_GCODE");
    if (file == nullptr) return text_of(wavy_print());
    std::ifstream text(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(text), {}};
}

struct Sums {
    MotionTotals totals;
    Features features;
    void add(const MotionEvent& event) {
        bead::add(totals, event);
        if (const Block* block = std::get_if<Block>(&event)) features += features_of(*block);
    }
};

void planning(benchmark::State& state, PlannerOptions options) {
    std::istringstream text(text_to_read());
    std::vector<Command> commands;
    read_gcode(text, {.firmware = options.firmware},
               [&](const Command& command) { commands.push_back(command); });
    std::int64_t blocks = 0;
    for (auto _ : state) {
        const auto planner = make_planner({}, options, [&](const MotionEvent& event) {
            blocks += std::int64_t(event.index() == 0);
        });
        for (const Command& command : commands) planner->add(command);
        planner->finish();
    }
    state.counters["blocks"] = benchmark::Counter(double(blocks), benchmark::Counter::kIsRate);
}

void simulating(benchmark::State& state, PlannerOptions options) {
    std::istringstream text(text_to_read());
    GcodeReport report;
    double time = 0;
    for (auto _ : state) {
        text.clear();
        text.seekg(0);
        Sums sums;
        const auto planner =
            make_planner({}, options, [&](const MotionEvent& event) { sums.add(event); });
        report = read_gcode(text, {.firmware = options.firmware},
                            [&](const Command& command) { planner->add(command); });
        planner->finish();
        time += sums.totals.duration;
    }
    benchmark::DoNotOptimize(time);
    const auto times = std::int64_t(state.iterations());
    state.SetBytesProcessed(times * report.bytes);
    state.counters["lines"] =
        benchmark::Counter(double(times * report.lines), benchmark::Counter::kIsRate);
}

[[maybe_unused]] const bool registered = [] {
    for (std::size_t i = 0; i < firmware_names.size(); ++i) {
        const std::string name(firmware_names[i]);
        for (const int depth : {16, 0}) {
            const PlannerOptions options{.firmware = Firmware(i), .lookahead = depth};
            const std::string suffix = name + (depth == 0 ? "/unlimited" : "");
            benchmark::RegisterBenchmark(("planning/" + suffix).c_str(), planning, options)
                ->Unit(benchmark::kMillisecond);
            benchmark::RegisterBenchmark(("simulating/" + suffix).c_str(), simulating, options)
                ->Unit(benchmark::kMillisecond);
        }
    }
    return true;
}();

}  // namespace
