// The motion planner of Prusa's 8-bit firmware (Prusa-Firmware commit 6dbf35f6 of 2023-03-24,
// planner.cpp; that of March 2017 differs in what quirks_2017 says), from commands to timed blocks.
//
// Every move becomes whole steps, one block with nominal speed and acceleration. A block may be
// entered no faster than the jerk limits of its junction allow and no faster than it can brake
// before what follows (look_ahead.h). docs/motion.md tells the whole story with the places where
// the firmware is not what physics would ask; each of those is a switch below.
#pragma once
#include "motion/arc_chords.h"
#include "motion/look_ahead.h"
#include "motion/planner.h"
#include "motion/step_frame.h"

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
    bool travel_acceleration = true;  // moves without filament have an acceleration of their own
    bool any_e_drains = true;         // G92 E waits for the queue to run dry, E0 alone does not
};
constexpr PrusaQuirks faithful_quirks() { return {}; }
// Without what is wrong; how the version reads its commands stays.
constexpr PrusaQuirks corrected(const PrusaQuirks& quirks) {
    return {false,
            false,
            false,
            false,
            false,
            false,
            false,
            false,
            false,
            quirks.travel_acceleration,
            quirks.any_e_drains};
}
constexpr PrusaQuirks corrected_quirks() { return corrected(faithful_quirks()); }
// March 2017 kept its flags in a bool, so that two of them were lost; one acceleration for all
// moves of the head; G92 drains unless the line has an E.
constexpr PrusaQuirks quirks_2017() {
    PrusaQuirks quirks;
    quirks.unbounded_halt = quirks.nominal_shortcut = false;
    quirks.travel_acceleration = quirks.any_e_drains = false;
    return quirks;
}

struct PrusaOptions {
    PrusaQuirks quirks;
    int lookahead = 16;  // ring size; one place stays free and one block runs. 0: unlimited
    ArcStyle arcs = ArcStyle::prusa;
};

class PrusaPlanner final : public Planner {
  public:
    PrusaPlanner(const Limits& limits, const PrusaOptions& options, MotionSink sink);
    void add(const Command& command) override;
    void finish() override { drain(); }
    [[nodiscard]] const Limits& limits() const override { return limits_; }

  private:
    template <class P>
    friend struct Obey;
    template <class P>
    friend void obey(P& planner, const Command& command);
    struct Previous {  // the block added last
        PerAxis<double> speed{};
        double nominal = 0, safe = 0;
    };

    void move(const Move& move, std::int64_t line);
    void arc(const Arc& arc, std::int64_t line);
    void set_position(const SetPosition& position);
    void home(const Home& home);
    void change(const SetLimits& limits);
    void pass(const MotionEvent& event) { queue_.pass(event); }
    void drain();
    void measure(const Move& move, const StepMove& taken, Block& block,
                 PerAxis<double>& speed) const;
    [[nodiscard]] double path_acceleration(const StepMove& taken, const Block& block) const;
    [[nodiscard]] double safe_speed(double nominal, const PerAxis<double>& speed) const;
    [[nodiscard]] double junction_speed(double nominal, const PerAxis<double>& speed) const;
    [[nodiscard]] Junction enter(const Block& block, const PerAxis<double>& speed);

    Limits limits_;
    PerAxis<double> mm_per_step_{};
    PrusaQuirks quirks_;
    ArcStyle arcs_;
    LookAhead queue_;
    StepFrame frame_;
    Position place_{};  // mm, as told
    Previous previous_;
    std::int64_t since_drain_ = 0;  // blocks since the queue last ran dry
};

}  // namespace bead
