// A print as places in time, a line for every millisecond: for machines that follow setpoints
// instead of planning for themselves. Places are the commands of a time law, its shaper and
// feed-forward applied (vibration/command.h); each layer is driven from rest to rest, Z moves in
// between.
#pragma once
#include <array>
#include <optional>
#include <string>

#include "core/output_file.h"
#include "vibration/assess.h"
#include "vibration/command.h"

namespace bead::cli {

class Setpoints {
  public:
    Setpoints(const std::string& file, const ShakenMachine& machine, const TimeLaw& law);

    void add(const Toolpath& layer, double z);
    void finish() { file_.keep(); }

  private:
    void write(double x, double y, double z, double volume);

    OutputFile file_;
    TimeLaw law_;
    std::array<CommandFilter, 2> filters_;
    std::int64_t samples_ = 0;
    double volume_ = 0;  // mm³ laid down
    std::optional<double> z_;
};

}  // namespace bead::cli
