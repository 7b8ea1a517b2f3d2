// A print's motion events, which are trapezoids by some firmware's planner, as segments in the
// plane of X and Y: as the firmware moves, or by a time law of our own along the firmware's very
// moves (its chords of arcs, its feeds and accelerations). While Z or the filament move alone the
// head stands still.
#pragma once
#include <optional>

#include "motion/block.h"
#include "vibration/timed.h"

namespace bead {

class PrintMotion {
  public:
    // No law: as the firmware moves. The filament's cross-section in mm².
    PrintMotion(double filament, const std::optional<TimeLaw>& law, SegmentSink sink);
    PrintMotion(const PrintMotion&) = delete;
    PrintMotion& operator=(const PrintMotion&) = delete;
    void add(const MotionEvent& event);
    void finish();

  private:
    void add(const Block& block);
    void tell_trapezoid(const Block& block, const MotionSegment& like, double share);
    void stand(double duration);

    double filament_;
    SegmentSink sink_;
    std::optional<Timing> timing_;
    Vec2 at_;
};

}  // namespace bead
