// How much the nozzle shakes along a print: the root mean square of its acceleration, window by
// window, all of the same length, for prints of any length in bounded memory. Windows begin as
// single samples; when there are too many, neighbours are put together two by two.
#pragma once
#include <cstddef>
#include <vector>

#include "geom/vec.h"

namespace bead {

struct RmsWindow {
    double from = 0, to = 0;  // s
    double rms = 0;           // mm/s², both axes together
};

class RmsOverTime {
  public:
    // `step`: s from sample to sample. Never more than `most` windows, at least half as many where
    // there are so many samples.
    explicit RmsOverTime(double step, std::size_t most = 1000);

    void add(Vec2 acceleration);
    [[nodiscard]] std::vector<RmsWindow> windows() const;

  private:
    void halve();

    double step_;
    std::size_t most_;
    std::size_t per_window_ = 1;  // samples
    std::size_t count_ = 0;       // samples so far
    std::vector<double> sums_;    // of squares, (mm/s²)²
};

}  // namespace bead
