// Power over time as means of equal steps, so that the sum of power × step is the energy.
//
//     PowerCurve curve(1, [&](const PowerStep& step) { … });
//     meter.listen({[&](double t) { return curve.end_of_step(t); },
//                   [&](const PowerPiece& piece) { curve.add(piece); }});
//     …
//     curve.finish();
#pragma once
#include <functional>

#include "energy/power_pieces.h"

namespace bead {

struct PowerStep {
    double time = 0;  // s, its beginning
    Energy power;     // W, means over the step
};

class PowerCurve {
  public:
    // `step` in s, above 0.
    PowerCurve(double step, std::function<void(const PowerStep&)> sink);

    [[nodiscard]] double end_of_step(double time) const;
    // Pieces in the order of time, none across the end of a step.
    void add(const PowerPiece& piece);
    // The last step, in which the print ends, counts as a whole one.
    void finish();

  private:
    [[nodiscard]] double index(double time) const;
    void tell_until(double index);

    double step_;
    std::function<void(const PowerStep&)> sink_;
    double now_ = 0;  // the step's number
    Energy sum_;
    bool begun_ = false;
};

}  // namespace bead
