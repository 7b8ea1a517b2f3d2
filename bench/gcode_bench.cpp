// Lines and bytes per second of the reader, into a sink that only counts, and of the writer. The
// text is like a slicer's: short extruding lines, a travel every 40. BEAD_GCODE names a file to
// read instead.
#include <benchmark/benchmark.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

#include "gcode/reader.h"
#include "gcode/writer.h"

namespace {

using namespace bead;

constexpr int moves = 500'000;

std::vector<Command> wavy_print() {
    std::vector<Command> commands{{LayerStart{.z = 0.2, .height = 0.2}, 0}};
    Position at{};
    for (int i = 0; i < moves; ++i) {
        const bool travel = i % 40 == 0;
        at[axis_x] = 125 + 50 * std::cos(0.037 * i);
        at[axis_y] = 105 + 50 * std::sin(0.041 * i);
        at[axis_z] = 0.2;
        at[axis_e] += travel ? 0 : 0.02221;
        Move move;
        move.to = at;
        move.feed = travel ? 130 : 45;
        move.role = travel ? Role::travel : i % 1000 < 500 ? Role::wall : Role::infill;
        move.bead = travel ? Bead{} : Bead{.width = 0.45, .height = 0.2};
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

void reading(benchmark::State& state) {
    std::istringstream text(text_to_read());
    std::int64_t commands = 0;
    GcodeReport report;
    for (auto _ : state) {
        text.clear();
        text.seekg(0);
        report = read_gcode(text, {}, [&](const Command&) { ++commands; });
    }
    benchmark::DoNotOptimize(commands);
    const auto times = std::int64_t(state.iterations());
    state.SetBytesProcessed(times * report.bytes);
    state.counters["lines"] =
        benchmark::Counter(double(times * report.lines), benchmark::Counter::kIsRate);
}
BENCHMARK(reading)->Unit(benchmark::kMillisecond);

void writing(benchmark::State& state) {
    const std::vector<Command> commands = wavy_print();
    std::size_t bytes = 0;
    for (auto _ : state) bytes += text_of(commands).size();
    state.SetBytesProcessed(std::int64_t(bytes));
    state.SetItemsProcessed(std::int64_t(state.iterations()) * moves);
}
BENCHMARK(writing)->Unit(benchmark::kMillisecond);

}  // namespace
