#include "firmware_time.h"

#include <cmath>
#include <variant>

#include "geom/vec.h"
#include "smooth/travel_kind.h"

namespace bead::cli {
namespace {

class Clock {
  public:
    Clock(const FirmwareClock& how, const MotionStyle& style)
        : how_(how),
          style_(style),
          planner_(make_planner(how.limits, how.motion, [this](const MotionEvent& event) {
              if (const Block* block = std::get_if<Block>(&event)) time_ += duration(*block);
          })) {}

    void add(const Path& path) {
        ask(path.acceleration > 0 ? path.acceleration : how_.limits.acceleration);
        if (!started_) {
            const Vec3 p = path.points.front();
            at_ = {p.x, p.y, p.z, 0};
            planner_->add({SetPosition{{p.x, p.y, p.z, 0.0}}});
            started_ = true;
        }
        const bool pulls = path.role == Role::travel && path.retracted;
        if (pulls) pull_back(-1);
        follow(path);
        if (pulls) pull_back(1);
    }

    double finish() {
        planner_->finish();
        return time_;
    }

  private:
    void follow(const Path& path) {
        const double speed = path.speed > 0 ? path.speed : usual_travel_speed;
        const double fed = path.role == Role::travel
                               ? 0
                               : section(path.bead) / (pi / 4 * style_.filament * style_.filament);
        for (const Vec3 p : path.points) {
            at_[axis_e] += fed * std::hypot(p.x - at_[axis_x], p.y - at_[axis_y]);
            at_[axis_x] = p.x;
            at_[axis_y] = p.y;
            planner_->add({Move{at_, speed, path.role, path.bead}});
        }
    }

    // -1: the filament goes back, then the nozzle up; 1: the other way round.
    void pull_back(int way) {
        if (way > 0) lift(way);
        at_[axis_e] += way * style_.retract_length;
        planner_->add(
            {Move{at_, way < 0 ? style_.retract_speed : style_.return_speed, Role::travel, {}}});
        if (way < 0) lift(way);
    }
    void lift(int way) {
        if (style_.lift <= 0) return;
        at_[axis_z] -= way * style_.lift;
        planner_->add({Move{at_, style_.z_speed, Role::travel, {}}});
    }

    void ask(double acceleration) {
        if (acceleration == asked_) return;
        asked_ = acceleration;
        SetLimits change;
        change.acceleration = change.travel_acceleration = acceleration;
        planner_->add({change});
    }

    const FirmwareClock& how_;
    const MotionStyle& style_;
    double time_ = 0, asked_ = 0;
    bool started_ = false;
    Position at_{};
    std::unique_ptr<Planner> planner_;
};

}  // namespace

double firmware_time(const Toolpath& layer, const FirmwareClock& clock, const MotionStyle& style) {
    Clock running(clock, style);
    for (const Path& path : layer) running.add(path);
    return running.finish();
}

double retraction_way(double speed, const FirmwareClock& clock, const MotionStyle& style) {
    Path travel{Role::travel, {}, speed, 0, false, {{0, 0, 0}, {50, 0, 0}}};
    const double without = firmware_time({travel}, clock, style);
    travel.retracted = true;
    return speed * (firmware_time({travel}, clock, style) - without);
}

}  // namespace bead::cli
