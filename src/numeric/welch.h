// Power spectral density of a long signal in bounded memory (Welch 1967): segments that overlap by
// half, each freed of its mean, seen through a Hamming window and transformed; their squares are
// averaged. A signal of two components is one of complex numbers; their densities are added.
#pragma once
#include <complex>
#include <cstddef>
#include <vector>

namespace bead {

class Welch {
  public:
    explicit Welch(std::size_t segment = 512);  // samples, even
    void add(std::complex<double> value);

    struct Density {
        std::size_t segments = 0;   // averaged
        std::size_t length = 0;     // samples of a segment; bin k is at k/length times the rate
        std::vector<double> power;  // one-sided, per sample rate: divide by it to have it per Hz
    };
    // A signal shorter than a segment is one segment. At least two samples, else nothing.
    [[nodiscard]] Density density() const;

  private:
    std::size_t length_;
    std::vector<std::complex<double>> pending_;
    std::vector<double> sum_;
    std::size_t segments_ = 0;
};

}  // namespace bead
