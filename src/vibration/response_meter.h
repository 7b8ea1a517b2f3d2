// The response to a motion of any length as a stream, in bounded memory: segments of motion are
// sampled, filtered to commands (command.h), answered by both drives (drive_motion.h), and what the
// nozzle does is summed up.
//
//     ResponseMeter meter(machine, law, 0.0005);
//     Timing timing(law, [&](const MotionSegment& segment) { meter.add(segment); });
//     … timing.finish();
//     const Response response = meter.finish();
#pragma once
#include <functional>
#include <memory>

#include "vibration/assess.h"
#include "vibration/motion_segment.h"

namespace bead {

struct ResponseSample {
    double time = 0;     // s
    Vec2 asked, nozzle;  // mm
    Vec2 acceleration;   // mm/s², of the nozzle
    bool prints = false;
};

class ResponseMeter {
  public:
    ResponseMeter(const ShakenMachine& machine, const TimeLaw& law, double step);
    ResponseMeter(ResponseMeter&&) noexcept;
    ~ResponseMeter();

    void add(const MotionSegment& segment);
    // Every sample is told too.
    void listen(std::function<void(const ResponseSample&)> listener);
    // The machine rings out for 0.3 s, which the time does not count.
    Response finish();

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace bead
