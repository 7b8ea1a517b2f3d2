#include "vibration/assess.h"

#include "core/expects.h"
#include "vibration/piece.h"
#include "vibration/response_meter.h"
#include "vibration/timed.h"

namespace bead {

Response assess(const Toolpath& path, const ShakenMachine& machine, const TimeLaw& law,
                const AssessOptions& options) {
    const std::vector<Piece> pieces = pieces_of(path, options.travel_speed);
    BEAD_EXPECTS(!pieces.empty());
    ResponseMeter meter(machine, law, options.step);
    timed(pieces, law, [&](const MotionSegment& segment) { meter.add(segment); });
    return meter.finish();
}

}  // namespace bead
