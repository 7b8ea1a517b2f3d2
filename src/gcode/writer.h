// Commands to G-code text of the Marlin and Prusa dialect: absolute X, Y, Z with 3 decimals, E absolute
// or relative with 5, F in whole mm/min where that is exact; axes and words that do not change are left
// out. Features, layers and beads are named as PrusaSlicer names them, so that its viewer and its users'
// scripts read them. Reading the text back gives the same commands.
#pragma once
#include <memory>
#include <ostream>
#include <string>

#include "toolpath/command.h"

namespace bead {

struct WriteOptions {
    bool relative_e = true;
    std::string header;  // lines of comment at the top, without ';'
};

class GcodeWriter {
  public:
    GcodeWriter(std::ostream& out, const WriteOptions& options);
    GcodeWriter(GcodeWriter&&) noexcept;
    ~GcodeWriter();
    void write(const Command& command);

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace bead
