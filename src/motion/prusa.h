// The motion planner of Prusa's 8-bit firmware (Prusa-Firmware commit 6dbf35f6 of 2023-03-24,
// planner.cpp), from commands to timed blocks, as a stream: memory is bounded by the look-ahead.
//
// Every move becomes whole steps, one block with nominal speed and acceleration. A block may be
// entered no faster than the jerk limits of its junction allow and no faster than it can brake
// before what follows; those entry speeds come from a backward and a forward sweep over the queue.
// docs/motion.md tells the whole story with the places where the firmware is not what physics would
// ask; each of those is a switch below.
//
//     PrusaPlanner planner(limits, {}, [&](const MotionEvent& event) { … });
//     for (const Command& command : program) planner.add(command);
//     planner.finish();
#pragma once
#include <deque>
#include <vector>

#include "machine/limits.h"
#include "motion/planner.h"

namespace bead {

// What the firmware does; false is what physics asks for with the same limits.
struct PrusaQuirks {
    bool crude_axis_cap =
        true;  // an axis' acceleration limit caps the longest axis' step rate, even
               // when the limited axis takes fewer steps; rates are rounded up
    bool crude_safe_speed =
        true;  // the first axis above its jerk sets the path's safe speed to that jerk
    bool unscaled_entry =
        true;  // at a junction into a faster block, the jerk is taken from its full speed
    bool shared_halt_speed =
        true;  // at a full halt the old block exits with the new block's safe speed
    bool unbounded_halt =
        true;  // a block that starts from a halt is not slowed down for what follows
    bool second_block_halts =
        true;  // after the queue ran dry two blocks start from a halt, not one
    bool late_raise =
        true;  // the running block's exit is fixed, its successor's entry may still rise
    bool nominal_shortcut =
        true;  // blocks that reach nominal speed from their own safe speed skip the sweeps
    bool at_most_stays =
        true;  // an entry that once was at its junction's maximum is not looked at again
};
constexpr PrusaQuirks faithful_quirks() { return {}; }
constexpr PrusaQuirks corrected_quirks() {
    return {false, false, false, false, false, false, false, false, false};
}

struct PrusaOptions {
    PrusaQuirks quirks;
    int lookahead = 16;  // ring size; one place stays free and one block runs. 0: unlimited
};

class PrusaPlanner final : public Planner {
  public:
    PrusaPlanner(const Limits& limits, const PrusaOptions& options, MotionSink sink);
    void add(const Command& command) override;
    void finish() override;
    [[nodiscard]] const Limits& limits() const override { return limits_; }

  private:
    struct Planned {
        Block block;
        double max_entry = 0;    // mm/s, what the junction allows
        double brake_entry = 0;  // mm/s, from which what follows can be braked for
        double entry = 0;        // mm/s, which the blocks before can reach too
        double safe = 0;         // mm/s, from which it may stop dead
        bool halt = false;       // starts from a full halt
        bool nominal = false;    // reaches its nominal speed from its safe speed
        bool pinned = false;     // entry is final
        bool running = false;    // exit (block.v_exit) is final too
        std::vector<MotionEvent> before;
    };
    struct Previous {  // the block added last
        PerAxis<double> speed{};
        double nominal = 0, safe = 0;
    };

    void move(const Move& move, std::int64_t line);
    void set_position(const SetPosition& position);
    void pass(const MotionEvent& event);
    void drain();
    void enqueue(Planned planned);
    [[nodiscard]] double path_acceleration(const PerAxis<std::int64_t>& steps,
                                           const Block& b) const;
    [[nodiscard]] double safe_speed(const Block& block, const PerAxis<double>& speed) const;
    [[nodiscard]] double junction_speed(const Block& block, const PerAxis<double>& speed) const;
    void enter(Planned& planned, const PerAxis<double>& speed);
    void sweep();
    std::size_t sweep_back();
    void sweep_forward(std::size_t unchanged);
    [[nodiscard]] double end_speed(std::size_t k) const;
    void release(std::size_t count);
    void release_front();
    void run_front();
    [[nodiscard]] bool is_apart(const Planned& planned) const;
    [[nodiscard]] std::size_t settled() const;

    Limits limits_;
    PrusaOptions options_;
    MotionSink sink_;
    std::deque<Planned> queue_;
    std::vector<MotionEvent> pending_;  // to be passed on before the next block
    PerAxis<std::int64_t> steps_{};     // where the machine is
    Previous previous_;
    std::int64_t since_drain_ = 0;  // blocks since the queue last ran dry
    std::size_t next_look_ = 0;     // queue length at which to look for settled blocks
};

}  // namespace bead
