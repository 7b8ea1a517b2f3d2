// What the servos are told instead of the path: with feed-forward, the place plus c2 times its
// acceleration, so that the machine's lag in bends is made up for; then shaped. Both are symmetric
// in time on the mean: the command is not late. The acceleration is seen through a bell as wide as
// the first mode is slow, and leads by no more than what the law's acceleration asks for: corners,
// where it would be more, are not led into.
#pragma once
#include <span>
#include <vector>

#include "machine/vibration.h"
#include "vibration/time_law.h"

namespace bead {

class CommandFilter {
  public:
    // For one axis, sampled every `step` s.
    CommandFilter(const DriveAxis& axis, const TimeLaw& law, double step);

    // Samples that a value needs on either side.
    [[nodiscard]] std::size_t margin() const { return margin_; }
    // s²: the quasi-static gain of shaper and drive is 1 + c2·ω². Below 0 where the shaper rounds
    // off more than the drive lags.
    [[nodiscard]] double lead() const { return lead_; }
    // The filtered values of all samples but the margins'; expects more samples than those.
    void filter(std::span<const double> samples, std::vector<double>& out) const;

    // The mean of 2 half + 1 samples and a share of the next on both sides.
    struct Box {
        std::size_t half = 0;
        double ends = 0, weight = 1;
    };

  private:
    struct Tap {
        std::ptrdiff_t offset = 0;
        double weight = 0;
    };
    [[nodiscard]] std::vector<double> led(std::span<const double> samples) const;

    std::vector<Tap> taps_;               // the shaper, its delays between two samples
    std::size_t margin_ = 0, reach_ = 0;  // of all, of the taps
    // The bell: two boxes of so many samples, 0 without one, and two that make up for the rest.
    std::size_t pair_ = 0;
    Box box_;
    double lead_ = 0, bound_ = 0, scale_ = 0;  // s², mm, 1/s²
};

}  // namespace bead
