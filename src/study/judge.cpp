#include "study/judge.h"

namespace bead {

Judge::Judge(const Machine& machine, MotionSink watch)
    : meter_(machine.printer.power, machine.material, machine.printer.filament),
      watch_(std::move(watch)),
      planner_(make_planner(machine.printer.limits, machine.motion,
                            [this](const MotionEvent& event) { hear(event); })) {}

Assessment Judge::finish() {
    planner_->finish();
    return {meter_.report(), totals_, features_};
}

void Judge::hear(const MotionEvent& event) {
    meter_.add(event);
    bead::add(totals_, event);
    if (const Block* block = std::get_if<Block>(&event))
        features_ = features_ + features_of(*block);
    if (watch_) watch_(event);
}

}  // namespace bead
