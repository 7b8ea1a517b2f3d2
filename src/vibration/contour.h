// How far a point is from the path about a place on it: the path of a print passes everywhere, so
// only a few mm of it before and after the command count. The path comes and goes as a stream.
#pragma once
#include <vector>

#include "geom/vec.h"

namespace bead {

class Contour {
  public:
    explicit Contour(double window = 3) : window_(window) {}
    // The path goes on to this point; the first one is where it begins.
    void add(Vec2 point);
    // mm from `point` to the path within the window about `way` (mm since its beginning). Ways must
    // not go backwards by more than a window.
    double error(Vec2 point, double way);

  private:
    void forget();

    double window_;
    std::vector<Vec2> points_;
    std::vector<double> ways_;
    std::size_t first_ = 0;  // point from which the window may begin
};

// Of values that come one by one.
class Extremes {
  public:
    void add(double value) {
        least_ = count_ == 0 || value < least_ ? value : least_;
        most_ = value > most_ ? value : most_;
        sum_ += value;
        ++count_;
    }
    [[nodiscard]] double mean() const { return count_ == 0 ? 0 : sum_ / double(count_); }
    [[nodiscard]] double least() const { return least_; }
    [[nodiscard]] double most() const { return most_; }
    [[nodiscard]] std::size_t count() const { return count_; }

  private:
    std::size_t count_ = 0;
    double sum_ = 0, most_ = 0, least_ = 0;
};

// The value that a part of all do not exceed, to 0.1 %.
class Percentiles {
  public:
    void add(double value);
    [[nodiscard]] double at(double part) const;

  private:
    std::vector<std::size_t> bins_;  // by logarithm
    std::size_t count_ = 0;
};

}  // namespace bead
