// A firmware's motion planner, from commands to timed blocks, as a stream: memory is bounded by the
// look-ahead. Whose planner it is, is chosen by name; each has a file of its own.
//
//     const auto planner = make_planner(limits, {Firmware::klipper}, [&](const MotionEvent& e)
//     {…}); for (const Command& command : program) planner->add(command); planner->finish();
#pragma once
#include <memory>

#include "machine/firmware.h"
#include "machine/limits.h"
#include "motion/block.h"

namespace bead {

class Planner {
  public:
    virtual ~Planner() = default;
    Planner() = default;
    Planner(const Planner&) = delete;
    Planner& operator=(const Planner&) = delete;

    virtual void add(const Command& command) = 0;
    virtual void finish() = 0;                               // the queue runs dry
    [[nodiscard]] virtual const Limits& limits() const = 0;  // as they stand now
};

struct PlannerOptions {
    Firmware firmware = Firmware::prusa;
    bool corrected = false;  // what physics asks for with the same limits, not what firmware does
    int lookahead = 16;      // blocks in the ring, one of them free, one running. 0: unlimited
};

std::unique_ptr<Planner> make_planner(const Limits& limits, const PlannerOptions& options,
                                      MotionSink sink);

}  // namespace bead
