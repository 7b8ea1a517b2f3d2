// The gyroid sin x cos y + sin y cos z + sin z cos x = 0 (A. Schoen 1970), cut at the layer's
// height: waves that turn from layer to layer until they run the other way. Where |cos z| >= |sin
// z| the surface gives y for every x: with A = √(sin² x + cos² z) and φ = atan2(sin x, cos z) it is
// A sin(y + φ) = -sin z cos x, which has two waves in every period. Elsewhere it gives x for every
// y: B sin(x + ψ) = -cos z sin y, B = √(cos² y + sin² z), ψ = atan2(sin z, cos y).
//
// Waves are 1.23 times as long as the way on average over all heights, 1.15 to 1.51 times: a layer
// may have more than its share, the part has not. Height 0 is one of the mean length.
#include <algorithm>

#include "core/expects.h"
#include "infill/cut.h"

namespace bead {
namespace {

constexpr double mean_stretch = 1.22937878;  // of the waves, found by integration
constexpr double mean_phase = 0.48924954;    // rad of height at which it is the mean
constexpr double gyroid_sagitta = 0.01;      // mm

struct Waves {
    double phase = 0;  // rad of height
    [[nodiscard]] bool upright() const {
        return std::abs(std::sin(phase)) > std::abs(std::cos(phase));
    }
    // How far the wave lies across, at `along` (both rad); the two of a period.
    [[nodiscard]] double across(double along, bool second) const {
        const double c = std::cos(phase), s = std::sin(phase);
        const double ca = std::cos(along), sa = std::sin(along);
        double turn = upright() ? std::atan2(s, ca) : std::atan2(sa, std::abs(c));
        if (!upright() && c < 0) turn = pi - turn;
        const double right = upright() ? -c * sa / std::hypot(ca, s) : -s * ca / std::hypot(sa, c);
        const double rise = std::asin(std::clamp(right, -1.0, 1.0));
        return (second ? pi - rise : rise) - turn;
    }
};

// `box` and lines in rad, about the centre.
std::vector<Polyline> waves_over(const Waves& waves, const Box2& box, int per_period) {
    const bool upright = waves.upright();
    const double step = 2 * pi / per_period;
    const auto along = [&](Vec2 p) { return upright ? p.y : p.x; };
    const auto across = [&](Vec2 p) { return upright ? p.x : p.y; };
    const auto first = static_cast<long>(std::floor(along(box.low) / step)) - 1;
    const auto last = static_cast<long>(std::ceil(along(box.high) / step)) + 1;
    constexpr double reach = 2.5 * pi;  // from a wave's place
    const auto lowest = static_cast<long>(std::floor((across(box.low) - reach) / (2 * pi)));
    const auto highest = static_cast<long>(std::ceil((across(box.high) + reach) / (2 * pi)));
    std::vector<Polyline> lines;
    for (long period = lowest; period <= highest; ++period)
        for (const bool second : {false, true}) {
            Polyline line;
            for (long i = first; i <= last; ++i) {
                const double u = static_cast<double>(i) * step;
                const double v = waves.across(u, second) + 2 * pi * static_cast<double>(period);
                line.push_back(upright ? Vec2{v, u} : Vec2{u, v});
            }
            lines.push_back(std::move(line));
        }
    return lines;
}

}  // namespace

std::vector<Polyline> gyroid(const Region& region, const FillOptions& options) {
    BEAD_EXPECTS(options.spacing > 0);
    if (region.empty()) return {};
    const double scale = mean_stretch * options.spacing / pi;  // mm per rad
    const Vec2 turn = scale * unit(options.angle), back = (1 / scale) * unit(-options.angle);
    Box2 box;
    for (const Polygon& polygon : region)
        for (const Vec2 p : polygon.outer) box.include(rotated(p - options.centre, back));
    const double chord = std::sqrt(8 * gyroid_sagitta / scale);  // rad
    const int per_period = 4 * std::max(4, static_cast<int>(std::ceil(pi / (2 * chord))));
    const Waves waves{mean_phase + options.height / scale};
    std::vector<Polyline> lines = waves_over(waves, box, per_period);
    for (Polyline& line : lines)
        for (Vec2& p : line) p = options.centre + rotated(p, turn);
    return cut_and_linked(lines, region, options.link);
}

}  // namespace bead
