// What the servos are told instead of the path: with feed-forward, the place plus c2 times its
// acceleration (seen through a bell of about 10 ms, cut to a bound), so that the machine's lag in
// bends is made up for; then shaped. Both are symmetric in time on the mean: the command is not
// late.
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

  private:
    struct Tap {
        std::ptrdiff_t offset = 0;
        double weight = 0;
    };
    [[nodiscard]] std::vector<double> led(std::span<const double> samples) const;

    std::vector<Tap> taps_;               // the shaper, its delays between two samples
    std::size_t margin_ = 0, reach_ = 0;  // of all, of the taps
    std::size_t box_ = 0;  // samples of one of the four boxes that make the bell; 0: none
    double lead_ = 0, bound_ = 0, scale_ = 0;
};

}  // namespace bead
