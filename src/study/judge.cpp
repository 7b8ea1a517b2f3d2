#include "study/judge.h"

namespace bead {

Judge::Judge(const Machine& machine, MotionSink watch, Judging judging)
    : watch_(std::move(watch)),
      planner_(make_planner(machine.printer.limits, machine.motion,
                            [this](const MotionEvent& event) { hear(event); })) {
    if (judging == Judging::motion_and_energy) meter_.emplace(machine.printer, machine.material);
}

Assessment Judge::finish() {
    planner_->finish();
    return {meter_ ? meter_->report() : EnergyReport{}, totals_, features_};
}

// Tells the meter what blocks do not say: where the head stands after homing, before which every
// planner has done all its blocks, and where a program says that it starts. A later G92 only gives
// places other names.
void Judge::follow(const Command& command) {
    Vec2 place = meter_->place();
    if (const Home* home = std::get_if<Home>(&command.what)) {
        if (home->axes[axis_x]) place.x = 0;
        if (home->axes[axis_y]) place.y = 0;
    } else if (const SetPosition* here = std::get_if<SetPosition>(&command.what)) {
        if (moved_) return;
        place = {here->to[axis_x].value_or(place.x), here->to[axis_y].value_or(place.y)};
    } else {
        moved_ = moved_ || std::holds_alternative<Move>(command.what) ||
                 std::holds_alternative<Arc>(command.what);
        return;
    }
    meter_->place(place);
}

void Judge::hear(const MotionEvent& event) {
    if (meter_) meter_->add(event);
    bead::add(totals_, event);
    if (const Block* block = std::get_if<Block>(&event)) features_ += features_of(*block);
    if (watch_) watch_(event);
}

}  // namespace bead
