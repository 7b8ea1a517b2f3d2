// Drivers that turn to a smaller current once their motor has been at rest for a while: a motor
// that rests draws its holding loss after the delay, and its full one again as soon as it turns.
#pragma once
#include <algorithm>
#include <array>

#include "machine/power.h"

namespace bead {

class Standstill {
  public:
    explicit Standstill(const PowerModel& power) : delay_(power.standstill_delay) {
        for (std::size_t i = 0; i < saving_.size(); ++i) {
            saving_[i] = std::max(0.0, power.motors[i].standing - holding(power.motors[i]));
            reduces_ = reduces_ || saving_[i] > 0;
        }
    }

    // Of the time that passes, how long each motor is held with less.
    std::array<double, 4> pass(double seconds, const std::array<bool, 4>& turns) {
        std::array<double, 4> reduced{};
        if (!reduces_) return reduced;
        for (std::size_t i = 0; i < reduced.size(); ++i) {
            if (turns[i]) {
                rest_[i] = 0;
                continue;
            }
            rest_[i] += seconds;
            reduced[i] = std::clamp(rest_[i] - delay_, 0.0, seconds);
        }
        return reduced;
    }

    [[nodiscard]] bool reduces() const { return reduces_; }
    [[nodiscard]] double saving(std::size_t motor) const { return saving_[motor]; }  // W

  private:
    double delay_;
    bool reduces_ = false;
    std::array<double, 4> saving_{}, rest_{};  // W, s
};

}  // namespace bead
