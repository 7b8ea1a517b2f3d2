// Every n-th sample of a signal, after what could not be told from lower frequencies then has been
// filtered out: a sinc of 20 n + 1 taps seen through a Hamming window, without shift in time.
#pragma once
#include <complex>
#include <cstddef>
#include <vector>

namespace bead {

class Decimator {
  public:
    explicit Decimator(std::size_t ratio);
    // True when value() is new. The signal is taken as 0 before it begins; feed `delay()` zeros at
    // its end to have all of it.
    bool add(std::complex<double> value);
    [[nodiscard]] std::complex<double> value() const;
    [[nodiscard]] std::size_t delay() const { return taps_.size() / 2; }

  private:
    std::size_t ratio_, seen_ = 0;
    std::vector<double> taps_;
    std::vector<std::complex<double>> ring_;  // the last samples, twice over
};

}  // namespace bead
