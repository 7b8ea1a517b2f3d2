// The time laws per point of a path, and the response to a print of an hour: a layer of rings of
// chords with travel in between, over and over.
#include <benchmark/benchmark.h>

#include <cmath>
#include <random>
#include <string>

#include "vibration/piece.h"
#include "vibration/response_meter.h"
#include "vibration/timed.h"

namespace {

using namespace bead;

std::vector<Piece> rings(std::size_t count) {
    std::mt19937_64 random(5);
    const auto uniform = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    Path ring{.role = Role::wall, .bead = {0.4, 0.2}, .speed = 50, .points = {}};
    Toolpath toolpath;
    for (std::size_t points = 0; points < count; points += ring.points.size()) {
        const double radius = std::exp(uniform(std::log(3), std::log(60)));
        const auto chords = std::size_t(std::max(12.0, 2 * pi * radius / uniform(0.5, 2.5)));
        const Vec2 middle{uniform(0, 200), uniform(0, 200)};
        ring.points.clear();
        for (std::size_t i = 0; i <= chords; ++i) {
            const Vec2 at = middle + radius * unit(2 * pi * double(i) / double(chords));
            ring.points.push_back({at.x, at.y, 0});
        }
        toolpath.push_back(ring);
    }
    return pieces_of(toolpath, 120);
}

TimeLaw law_of(std::int64_t index) { return named_laws[std::size_t(index)].law; }

void law_on_path(benchmark::State& state) {
    const auto pieces = rings(std::size_t(state.range(0)));
    const TimeLaw law = law_of(state.range(1));
    for (auto _ : state) {
        double time = 0;
        timed(pieces, law, [&](const MotionSegment& segment) { time += segment.duration; });
        benchmark::DoNotOptimize(time);
    }
    state.SetItemsProcessed(state.iterations() * std::int64_t(pieces.size()));
    state.SetLabel(std::string(named_laws[std::size_t(state.range(1))].name));
}
BENCHMARK(law_on_path)
    ->ArgsProduct({{8'400, 33'000, 134'000}, {0, 1}})
    ->Unit(benchmark::kMillisecond);

void response_of_an_hour(benchmark::State& state) {
    const auto pieces = rings(20'000);
    const TimeLaw law = law_of(state.range(0));
    double rms = 0;
    for (auto _ : state) {
        ResponseMeter meter({}, law, 0.0005);
        double time = 0;
        Timing timing(law, [&](const MotionSegment& segment) {
            time += segment.duration;
            meter.add(segment);
        });
        while (time < 3600)
            for (const Piece& piece : pieces) timing.add(piece);
        timing.finish();
        const Response response = meter.finish();
        rms = response.rms_acceleration;
        state.counters["hours"] = response.time / 3600;
    }
    benchmark::DoNotOptimize(rms);
    state.SetLabel(std::string(named_laws[std::size_t(state.range(0))].name));
}
BENCHMARK(response_of_an_hour)->Arg(0)->Arg(1)->Arg(3)->Arg(6)->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
