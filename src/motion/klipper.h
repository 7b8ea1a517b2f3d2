// Klipper's motion planner (toolhead.py, kinematics/extruder.py at commit 84104bbb): moves as they
// are told, no steps; corners by "approximated centripetal velocity" about a circle that the square
// corner velocity sets; the filament's own corners and limits; a full stop wherever filament moves
// alone. On top of the real plan runs a smoothed one with less acceleration, whose peak caps the
// cruise speed so that short moves spend their minimum share cruising.
//
// The queue is as long as it needs to be: blocks go once what is known settles them, looked at
// whenever a quarter of a second of moves has come in, as the firmware does.
#pragma once
#include <deque>
#include <utility>
#include <vector>

#include "motion/corner.h"
#include "motion/planner.h"

namespace bead {

class KlipperPlanner final : public Planner {
  public:
    KlipperPlanner(const Limits& limits, MotionSink sink);
    void add(const Command& command) override;
    void finish() override { drain(); }
    [[nodiscard]] const Limits& limits() const override { return limits_; }

  private:
    template <class P>
    friend struct Obey;
    template <class P>
    friend void obey(P& planner, const Command& command);

    struct Queued {
        MotionEvent event{Block{}};
        Leg leg;
        bool head = true;  // else filament alone: a full stop before and after
        // Speeds squared, (mm/s)².
        double max_start = 0, max_cruise = 0, delta = 0;    // the real plan
        double max_smoothed_start = 0, smoothed_delta = 0;  // the smoothed one
        [[nodiscard]] Block& block() { return std::get<Block>(event); }
        [[nodiscard]] const Block& block() const { return std::get<Block>(event); }
    };

    void move(const Move& move, std::int64_t line);
    void arc(const Arc& arc, std::int64_t line);
    void set_position(const SetPosition& position);
    void home(const Home& home);
    void change(const SetLimits& limits);
    void pass(const MotionEvent& event);
    void drain();
    void limit(Queued& queued, double speed, double acceleration) const;
    void join(const Queued& before, Queued& queued) const;
    void flush(bool all);
    void release(std::size_t count);

    Limits limits_;
    MotionSink sink_;
    Position place_{};  // mm
    std::deque<Queued> queue_;
    double until_flush_;    // s of moves still to come before the queue is looked at
    std::size_t gone_ = 0;  // blocks told so far
    std::deque<std::pair<std::size_t, MotionEvent>> between_;  // to be told before block …
};

}  // namespace bead
