#include "motion/planner.h"

#include "motion/klipper.h"
#include "motion/marlin.h"
#include "motion/prusa.h"
#include "motion/s_curve.h"

namespace bead {

std::unique_ptr<Planner> make_planner(const Limits& limits, const PlannerOptions& options,
                                      MotionSink sink) {
    const auto prusa = [&](const PrusaQuirks& faithful, ArcStyle arcs) {
        return std::make_unique<PrusaPlanner>(
            limits,
            PrusaOptions{options.corrected ? corrected(faithful) : faithful, options.lookahead,
                         arcs},
            std::move(sink));
    };
    switch (options.firmware) {
        case Firmware::prusa:
            return prusa(faithful_quirks(), ArcStyle::prusa);
        case Firmware::prusa_2017:
            return prusa(quirks_2017(), ArcStyle::prusa_2017);
        case Firmware::marlin_jerk:
        case Firmware::marlin_jd:
            return std::make_unique<MarlinPlanner>(
                limits,
                MarlinOptions{options.firmware == Firmware::marlin_jd, options.corrected,
                              options.lookahead},
                std::move(sink));
        case Firmware::klipper:
            return std::make_unique<KlipperPlanner>(limits, std::move(sink));
        case Firmware::s_curve:
            return std::make_unique<SCurvePlanner>(limits, std::move(sink));
    }
    return nullptr;
}

}  // namespace bead
