// A planner of our own for machines that limit jerk: the corner speeds of square corner velocity,
// every axis' limits of speed and acceleration projected onto the path, and between slow places one
// S-shaped rise and fall of speed (jerk_limited.h) across as many blocks as it takes.
//
// Moves of the filament alone stand between full stops. Blocks wait for a window of moves, which is
// planned as if the machine stopped at its end; its first half goes.
#pragma once
#include <utility>
#include <vector>

#include "motion/corner.h"
#include "motion/planner.h"

namespace bead {

class SCurvePlanner final : public Planner {
  public:
    SCurvePlanner(const Limits& limits, MotionSink sink);
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
        bool head = true;         // else filament alone
        double max_entry = 0;     // mm/s, at the corner before it
        std::size_t between = 0;  // events in between_ that come before it
        [[nodiscard]] Block& block() { return std::get<Block>(event); }
    };

    void move(const Move& move, std::int64_t line);
    void arc(const Arc& arc, std::int64_t line);
    void set_position(const SetPosition& position);
    void home(const Home& home);
    void change(const SetLimits& limits);
    void pass(const MotionEvent& event);
    void drain();
    void measure(const Move& move, Queued& queued) const;
    [[nodiscard]] double corner(const Queued& before, const Queued& after) const;
    void release(bool all);
    void tell(std::size_t count);

    Limits limits_;
    MotionSink sink_;
    Position place_{};  // mm
    std::vector<Queued> window_;
    std::size_t full_;  // moves at which the window is planned
    double entry_ = 0;  // mm/s, at which its first move begins
    std::vector<MotionEvent> between_;
};

}  // namespace bead
