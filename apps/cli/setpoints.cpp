#include "setpoints.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "smooth/travel_kind.h"
#include "vibration/piece.h"
#include "vibration/timed.h"

namespace bead::cli {
namespace {

constexpr double step = 0.001;  // s
constexpr double z_speed = 10;  // mm/s

struct Samples {
    std::array<std::vector<double>, 2> places;  // mm
    std::vector<double> volumes;                // mm³ laid down
};

// At every step from the start, and where it ends.
Samples samples_of(const Toolpath& layer, const TimeLaw& law, double volume) {
    Samples samples;
    double wait = 0;  // s, until the next sample
    Vec2 last = flat(layer.front().points.front());
    const auto keep = [&](Vec2 at, double laid) {
        samples.places[0].push_back(at.x);
        samples.places[1].push_back(at.y);
        samples.volumes.push_back(laid);
    };
    timed(pieces_of(layer, usual_travel_speed), law, [&](const MotionSegment& segment) {
        for (; wait < segment.duration; wait += step) {
            const double gone = std::clamp(way(segment, wait), 0.0, segment.length);
            keep(segment.from + gone * segment.direction, volume + gone * segment.flow);
        }
        wait -= segment.duration;
        volume += segment.length * segment.flow;
        last = end(segment);
    });
    keep(last, volume);
    return samples;
}

std::vector<double> padded(const std::vector<double>& values, std::size_t count) {
    std::vector<double> all(count, values.front());
    all.insert(all.end(), values.begin(), values.end());
    all.insert(all.end(), count, values.back());
    return all;
}

}  // namespace

Setpoints::Setpoints(const std::string& file, const ShakenMachine& machine, const TimeLaw& law)
    : file_(file),
      law_(law),
      filters_{CommandFilter(machine.model.axes[0], law, step),
               CommandFilter(machine.model.axes[1], law, step)} {
    file_.stream() << "time_s,x_mm,y_mm,z_mm,extruded_mm3\n";
}

void Setpoints::write(double x, double y, double z, double volume) {
    file_.stream() << fmt::format("{:.3f},{:.4f},{:.4f},{:.3f},{:.5f}\n", double(samples_) * step,
                                  x, y, z, volume);
    ++samples_;
}

void Setpoints::add(const Toolpath& layer, double z) {
    if (layer.empty()) return;
    Samples samples = samples_of(layer, law_, volume_);
    volume_ = samples.volumes.back();
    const std::size_t margin = std::max(filters_[0].margin(), filters_[1].margin());
    std::array<std::vector<double>, 2> commands;
    for (std::size_t k = 0; k < 2; ++k)
        filters_[k].filter(padded(samples.places[k], margin + filters_[k].margin()), commands[k]);
    const std::vector<double> volumes = padded(samples.volumes, margin);
    const double from = z_.value_or(z);
    const int rise = int(std::ceil(std::abs(z - from) / z_speed / step));
    for (int i = 0; i < rise; ++i)
        write(commands[0].front(), commands[1].front(), std::lerp(from, z, double(i) / rise),
              volumes.front());
    for (std::size_t i = 0; i < volumes.size(); ++i)
        write(commands[0][i], commands[1][i], z, volumes[i]);
    z_ = z;
}

}  // namespace bead::cli
