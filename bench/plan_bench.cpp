// Planning a tapering plate of 50 × 90 mm with a dozen holes, 100 layers, on one thread: what is
// done once per part, and what a search does for every candidate layer.
#include <benchmark/benchmark.h>

#include "../tests/support/layers.h"
#include "plan/plan.h"
#include "plan/program.h"

namespace {

using namespace bead;

Region plate(double taper) {
    Region region = shapes::rectangle({taper, taper}, {50 - taper, 90 - taper});
    for (int i = 0; i < 12; ++i) {
        const Vec2 centre{10.0 + 15 * (i % 3), 12.0 + 22 * static_cast<int>(i / 3)};
        region = difference(region, {{shapes::regular(3.0 + 0.2 * i, 48, centre), {}}});
    }
    return region;
}

std::vector<Layer> layers() {
    std::vector<Region> regions;
    regions.reserve(100);
    for (int i = 0; i < 100; ++i) regions.push_back(plate(0.02 * i));
    return shapes::stacked(regions);
}

PlanOptions options_for(const benchmark::State& state) {
    PlanOptions options;
    options.threads = 1;
    options.pattern = patterns.at(static_cast<std::size_t>(state.range(0)));
    return options;
}

void take_apart(benchmark::State& state) {
    PlanOptions options;
    options.threads = 1;
    const std::vector<Layer> part = layers();
    for (auto _ : state) benchmark::DoNotOptimize(parts_of(part, options));
    state.counters["layers"] = static_cast<double>(part.size());
}

void match_spacing(benchmark::State& state) {
    const PlanOptions options = options_for(state);
    const std::vector<LayerParts> parts = parts_of(layers(), options);
    for (auto _ : state)
        benchmark::DoNotOptimize(matched_spacing(parts, options, {&options.pattern, 1}));
    state.SetLabel(std::string(options.pattern.name));
}

// A candidate of a search: the layer's toolpath and its commands.
void plan_one_layer(benchmark::State& state) {
    const PlanOptions options = options_for(state);
    const LayerParts layer = parts_of(layers(), options)[50];
    for (auto _ : state) {
        const Toolpath path = plan_layer(layer, {options.pattern, 0.3}, {}, options, {});
        std::vector<Command> commands;
        Nozzle nozzle;
        append_layer(commands, path, layer.z, layer.height, layer.index, nozzle, {});
        benchmark::DoNotOptimize(commands);
    }
    state.SetLabel(std::string(options.pattern.name));
}

BENCHMARK(take_apart)->Unit(benchmark::kMillisecond);
BENCHMARK(match_spacing)
    ->DenseRange(0, static_cast<int>(patterns.size()) - 1)
    ->Unit(benchmark::kMillisecond);
BENCHMARK(plan_one_layer)
    ->DenseRange(0, static_cast<int>(patterns.size()) - 1)
    ->Unit(benchmark::kMicrosecond);

}  // namespace
