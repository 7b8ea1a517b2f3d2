// Acceleration of the nozzle in figures: root mean square as it is, and by Welch's spectrum at 200
// Hz (512 samples, Hamming, half overlapping) the part of it between 5 and 40 Hz, where large
// machines ring.
#pragma once
#include "geom/vec.h"
#include "numeric/decimate.h"
#include "numeric/welch.h"
#include "vibration/response.h"

namespace bead {

inline constexpr double spectrum_rate = 200;           // Hz
inline constexpr double band_low = 5, band_high = 40;  // Hz

class Shaking {
  public:
    // 1/step must be a multiple of the spectrum's rate.
    explicit Shaking(double step);
    void add(Vec2 acceleration);  // mm/s²
    // Fills in what is about acceleration.
    void report(Response& response);

  private:
    Decimator decimator_;
    Welch welch_;
    double sum_ = 0;
    std::size_t count_ = 0;
};

}  // namespace bead
