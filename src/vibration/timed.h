// A path in time by a law's speeds: trapezoids, or rises and falls of limited jerk
// (motion/jerk_limited.h). The head follows the path exactly; shaper and feed-forward, which leave
// it, come later (vibration/command.h).
//
//     Timing timing(law, [&](const MotionSegment& segment) { … });
//     for (const Piece& piece : pieces) timing.add(piece);
//     timing.finish();
#pragma once
#include <span>

#include "vibration/motion_segment.h"
#include "vibration/piece.h"
#include "vibration/time_law.h"

namespace bead {

// From rest to rest, all at once.
void timed(std::span<const Piece> pieces, const TimeLaw& law, const SegmentSink& sink);

// The same for a path that comes piece by piece. Memory is bounded by a window of pieces, which is
// planned as if it ended at rest; of it goes what comes before a place about its middle that the
// end has no influence on.
class Timing {
  public:
    Timing(const TimeLaw& law, SegmentSink sink) : law_(law), sink_(std::move(sink)) {}
    void add(const Piece& piece);
    // The head comes to rest and stands still for some seconds.
    void stand(double duration);
    void finish() { release(true); }

  private:
    void release(bool all);
    void forget(std::size_t count);

    TimeLaw law_;
    SegmentSink sink_;
    std::vector<Piece> window_;
    std::size_t gone_ = 0;  // first pieces of the window that are told, kept for their bend
    double entry_ = 0;      // mm/s, at which the others begin
    Vec2 at_;               // mm, where the path ends as far as it is known
    std::size_t full_ = usual_window;
    static constexpr std::size_t usual_window = 4096;
};

}  // namespace bead
