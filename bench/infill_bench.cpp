// Time to fill a layer of 50 × 90 mm with a dozen holes: every pattern, solid and sparse.
#include <benchmark/benchmark.h>

#include "geom/clip.h"
#include "infill/fill.h"

namespace bead {
namespace {

Region plate() {
    Region region{{{{0, 0}, {50, 0}, {50, 90}, {0, 90}}, {}}};
    for (int i = 0; i < 12; ++i) {
        constexpr int corners = 48;
        const Vec2 centre{10.0 + 15 * (i % 3), 12.0 + 22 * static_cast<int>(i / 3)};
        Polyline hole;
        for (int k = 0; k < corners; ++k)
            hole.push_back(centre + (3.0 + 0.2 * i) * unit(2 * pi * k / corners));
        region = difference(region, {{hole, {}}});
    }
    return region;
}

void fill(benchmark::State& state) {
    const NamedPattern& pattern = patterns.at(static_cast<std::size_t>(state.range(0)));
    const double spacing = static_cast<double>(state.range(1)) / 1000;
    const Region region = plate();
    const FillOptions options{
        .spacing = spacing, .angle = pi / 4, .link = 5 * spacing, .centre = {25, 45}};
    for (auto _ : state) benchmark::DoNotOptimize(pattern.make(region, options));
    const auto lines = pattern.make(region, options);
    double sum = 0;
    for (const Polyline& line : lines) sum += length(line);
    state.SetLabel(std::string(pattern.name));
    state.counters["paths"] = static_cast<double>(lines.size());
    state.counters["length_per_area"] = sum * spacing / area(region);
}

// The second argument is the spacing in µm.
BENCHMARK(fill)
    ->ArgsProduct({benchmark::CreateDenseRange(0, static_cast<int>(patterns.size()) - 1, 1),
                   {400, 2250}})
    ->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace bead
