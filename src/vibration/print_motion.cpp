#include "vibration/print_motion.h"

#include <algorithm>

#include "motion/phases.h"

namespace bead {
namespace {

constexpr double least_way = 1e-7;  // mm

}  // namespace

PrintMotion::PrintMotion(double filament, const std::optional<TimeLaw>& law, SegmentSink sink)
    : filament_(filament), sink_(std::move(sink)) {
    if (law) timing_.emplace(*law, sink_);
}

void PrintMotion::add(const MotionEvent& event) {
    if (const Block* const block = std::get_if<Block>(&event))
        add(*block);
    else if (const Dwell* const dwell = std::get_if<Dwell>(&event))
        stand(dwell->duration);
}

void PrintMotion::finish() {
    if (timing_) timing_->finish();
}

void PrintMotion::stand(double time) {
    if (timing_)
        timing_->stand(time);
    else if (time > 0)
        sink_({.duration = time, .from = at_});
}

void PrintMotion::add(const Block& block) {
    const Vec2 way{block.delta[axis_x], block.delta[axis_y]};
    const double flat = length(way), share = block.length > 0 ? flat / block.length : 0;
    if (flat < least_way) {
        stand(duration(block));
        return;
    }
    const bool prints = block.role != Role::travel && block.delta[axis_e] > 0;
    const MotionSegment like{.from = at_,
                             .direction = way / flat,
                             .nominal = block.v_nominal * share,
                             .flow = prints ? block.delta[axis_e] * filament_ / flat : 0};
    if (timing_)
        timing_->add({at_, at_ + way, like.nominal, block.acceleration * share, like.flow});
    else
        tell_trapezoid(block, like, share);
    at_ = at_ + way;
}

void PrintMotion::tell_trapezoid(const Block& block, const MotionSegment& like, double share) {
    const std::array<double, 3> times{block.t_accel, block.t_cruise, block.t_decel};
    const auto phases = phases_of(block);
    for (std::size_t k = 0; k < phases.size(); ++k) {
        if (times[k] <= 0) continue;
        MotionSegment segment = like;
        segment.duration = times[k];
        segment.from = like.from + phases[k].from * share * like.direction;
        segment.speed = phases[k].entry * share;
        segment.acceleration = phases[k].acceleration * share;
        segment.length = (phases[k].to - phases[k].from) * share;
        sink_(segment);
    }
}

}  // namespace bead
