// How fast a file asks a machine to go, along the path and per axis, before any limit: beside the
// speeds reached, what the machine's limits cost.
#pragma once
#include "toolpath/command.h"

namespace bead {

class AskedSpeeds {
  public:
    void add(const Command& command);
    [[nodiscard]] double path() const { return path_; }                  // mm/s, moves of the head
    [[nodiscard]] const PerAxis<double>& axes() const { return axes_; }  // mm/s

  private:
    void take(const Move& move);
    void take(const Arc& arc);

    Position place_{};
    double path_ = 0;
    PerAxis<double> axes_{};
};

}  // namespace bead
