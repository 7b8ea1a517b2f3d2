// A heated body with a thermostat, taken as one temperature T over an ambient Ta:
//     C dT/dt = P - G (T - Ta) - load,     P = most it can draw below the target, 0 above it,
// and exactly what holds T once it is there (less, and T sags, where that is more than it can
// draw). Constant coefficients make this an exponential, so a step of any length is exact.
#pragma once

namespace bead {

struct HeatDraw {
    double energy = 0;  // J: what is stored, what G lets go, and the load while it is aimed at heat
    double excess = 0;  // K s, integral of T - Ta: G times it is what was let go
    double peak = 0;    // W, the controller's pulses averaged out
};

class HeatedBody {
  public:
    // W, J/K and °C. One that can draw nothing is not modelled: whatever it is told costs nothing.
    HeatedBody(double max_power, double capacity, double ambient);

    // At ambient or below, as 0 is, the heater is off: the body cools and nothing is charged.
    void aim(double celsius);
    [[nodiscard]] double target() const { return target_; }
    [[nodiscard]] double temperature() const { return temperature_; }

    // s until the target is reached from below, else 0. What cannot reach it waits five time
    // constants, when 99 % of what it can do is done. `conductance` G in W/K, `load` in W.
    [[nodiscard]] double warm_up_time(double conductance, double load = 0) const;
    [[nodiscard]] double stored() const { return capacity_ * (temperature_ - ambient_); }  // J
    HeatDraw advance(double seconds, double conductance, double load = 0);

  private:
    [[nodiscard]] double time_to_target(double rest, double time_constant) const;

    double max_power_, capacity_, ambient_;
    double temperature_, target_;
};

}  // namespace bead
