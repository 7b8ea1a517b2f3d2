#include "motion/planner.h"

#include "motion/prusa.h"

namespace bead {

std::unique_ptr<Planner> make_planner(const Limits& limits, const PlannerOptions& options,
                                      MotionSink sink) {
    const PrusaQuirks quirks = options.corrected ? corrected_quirks() : faithful_quirks();
    return std::make_unique<PrusaPlanner>(limits, PrusaOptions{quirks, options.lookahead},
                                          std::move(sink));
}

}  // namespace bead
