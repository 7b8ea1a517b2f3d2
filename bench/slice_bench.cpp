// Reading a large mesh, checking it and cutting it into 240 layers. A globe of half a million
// facets is made on the spot, so that no file is needed.
#include <benchmark/benchmark.h>

#include "../tests/support/mesh_files.h"
#include "../tests/support/shapes.h"
#include "mesh/check.h"
#include "mesh/load.h"
#include "slice/slice.h"

namespace {

using namespace bead;

constexpr double radius = 24;
const SliceOptions options{.layer_height = 0.2, .first_layer_height = 0.2, .threads = 1};

// 4 rings² facets, less those that fall together at the poles.
Mesh globe(benchmark::State& state) {
    Mesh mesh = shapes::sphere(radius, static_cast<int>(state.range(0)));
    state.counters["facets"] = static_cast<double>(mesh.triangles.size());
    return mesh;
}

void read_binary_stl(benchmark::State& state) {
    const std::string bytes = binary_stl(globe(state));
    for (auto _ : state) benchmark::DoNotOptimize(parse_mesh(bytes, "a.stl"));
    state.SetBytesProcessed(state.iterations() * std::ssize(bytes));
}

void check_mesh(benchmark::State& state) {
    const Mesh mesh = globe(state);
    for (auto _ : state) benchmark::DoNotOptimize(check(mesh));
}

void slice_mesh(benchmark::State& state) {
    const Mesh mesh = globe(state);
    for (auto _ : state) benchmark::DoNotOptimize(slice(mesh, options));
}

BENCHMARK(read_binary_stl)->Arg(50)->Arg(360)->Unit(benchmark::kMillisecond);
BENCHMARK(check_mesh)->Arg(50)->Arg(360)->Unit(benchmark::kMillisecond);
BENCHMARK(slice_mesh)->Arg(50)->Arg(360)->Unit(benchmark::kMillisecond);

}  // namespace
