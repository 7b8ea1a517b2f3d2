#include "smooth_rows.h"

#include <algorithm>
#include <cmath>

#include "smooth/metrics.h"
#include "smooth/travel_kind.h"
#include "vibration/piece.h"

namespace bead::cli {
namespace {

constexpr double response_step = 0.001;  // s, of the simulation

}  // namespace

PathFigures path_figures(const Toolpath& layer) {
    const PathMetrics m = path_metrics(layer);
    PathFigures f;
    f.length = m.length;
    f.travel = m.travel;
    f.infill_length = m.infill_length;
    f.points = m.points;
    f.infill_points = m.infill_points;
    f.turning = m.turning_points;
    f.windowed = m.windowed_turning_points;
    f.chord_error = m.chord_error_mean * m.points;
    f.volume = m.volume;
    return f;
}

void PathFigures::add(const PathFigures& layer) {
    length += layer.length;
    travel += layer.travel;
    infill_length += layer.infill_length;
    points += layer.points;
    infill_points += layer.infill_points;
    turning += layer.turning;
    windowed += layer.windowed;
    chord_error += layer.chord_error;
    true_chord_error = std::max(true_chord_error, layer.true_chord_error);
    volume += layer.volume;
    underfill += layer.underfill;
    overfill += layer.overfill;
    outline_deviation = std::max(outline_deviation, layer.outline_deviation);
}

SmoothSide::SmoothSide(const ShakenMachine& machine, const TimeLaw& law)
    : machine_(machine),
      meter_(machine, law, response_step),
      timing_(law, [this](const MotionSegment& segment) { meter_.add(segment); }) {}

void SmoothSide::add(const Toolpath& layer) {
    if (layer.empty()) return;
    const Vec2 first = flat(layer.front().points.front());
    if (at_ && distance(*at_, first) > 1e-3)
        timing_.add(
            {.from = *at_, .to = first, .feed = usual_travel_speed, .acceleration = 0, .flow = 0});
    for (const Piece& piece : pieces_of(layer, usual_travel_speed)) {
        timing_.add(piece);
        any_ = true;
    }
    at_ = flat(layer.back().points.back());
}

void SmoothSide::finish() {
    timing_.finish();
    if (any_) response_ = meter_.finish();
}

// Melting goes by the volume, the base by the time; the drives' share of layers that are not
// sampled is as that of those that are.
DriveEnergy SmoothSide::energy() const {
    DriveEnergy all = response_.energy;
    if (response_.time <= 0 || response_.volume <= 0) return all;
    const double by_time = time() / response_.time;
    all.servo *= by_time;
    all.copper *= by_time;
    all.base *= by_time;
    all.melt *= figures_.volume / response_.volume;
    return all;
}
double SmoothSide::material() const { return figures_.volume * machine_.material.density / 1000; }
double SmoothSide::co2() const {
    constexpr double j_per_kwh = 3.6e6;
    return 1000 * machine_.model.energy_co2 * total(energy()) / j_per_kwh +
           machine_.model.material_co2 * material();
}

Json SmoothSide::json() const {
    const PathFigures& f = figures_;
    const Response& r = response_;
    const DriveEnergy e = energy();
    return {{"length_mm", f.length},
            {"points", std::int64_t(f.points)},
            {"infill_length_mm", f.infill_length},
            {"infill_points", std::int64_t(f.infill_points)},
            {"turning_points", std::int64_t(f.turning)},
            {"windowed_turning_points", std::int64_t(f.windowed)},
            {"chord_error_mean_mm", f.points > 0 ? f.chord_error / f.points : 0},
            {"true_chord_error_mm", f.true_chord_error},
            {"deviation_mm",
             {{"min", r.deviation.min}, {"mean", r.deviation.mean}, {"max", r.deviation.max}}},
            {"contour_error_mm",
             {{"mean", r.contour.mean}, {"p99", r.contour.p99}, {"max", r.contour.max}}},
            {"energy_j", total(e)},
            {"energy_shares_j",
             {{"servo", e.servo}, {"copper", e.copper}, {"melt", e.melt}, {"base", e.base}}},
            {"material_g", material()},
            {"co2_g", co2()},
            {"time_s", time()},
            {"travel_mm", f.travel},
            {"volume_mm3", f.volume},
            {"underfill_mm2", f.underfill},
            {"overfill_mm2", f.overfill},
            {"outline_deviation_mm", f.outline_deviation},
            {"rms_acceleration_mm_s2", r.rms_acceleration},
            {"rms_5_40hz", r.rms_5_40hz},
            {"psd_top3", r.psd_top3}};
}

}  // namespace bead::cli
