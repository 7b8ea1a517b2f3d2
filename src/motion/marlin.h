// Marlin's motion planner (bugfix-2.1.x of 2023-01-07, planner.cpp), with either of its rules for
// corners: classic jerk, a step of each axis' speed, or junction deviation, a circle that passes
// the corner at a distance. It plans in 32-bit floats; where a corner is nearly straight their
// rounding decides its speed, so they are kept here.
//
// Against Prusa's (prusa.h): limits on acceleration are projected onto the path, safe speeds too,
// a print begins and ends at 0.05 mm/s, G92 does not stop.
#pragma once
#include "motion/look_ahead.h"
#include "motion/planner.h"
#include "motion/step_frame.h"

namespace bead {

struct MarlinOptions {
    bool junction_deviation = true;  // else classic jerk
    bool corrected = false;  // jerk from speeds both brought to the junction's, exact corner angle
    int lookahead = 16;      // ring size; one place stays free and one block runs. 0: unlimited
};

class MarlinPlanner final : public Planner {
  public:
    MarlinPlanner(const Limits& limits, const MarlinOptions& options, MotionSink sink);
    void add(const Command& command) override;
    void finish() override { drain(); }
    [[nodiscard]] const Limits& limits() const override { return limits_; }

  private:
    template <class P>
    friend struct Obey;
    template <class P>
    friend void obey(P& planner, const Command& command);
    using Floats = PerAxis<float>;

    struct Planned {  // of the block being added, in the firmware's own precision
        Floats way{}, speed{};
        float length = 0, nominal = 0, acceleration = 0;
        bool extrudes = false;
    };

    void move(const Move& move, std::int64_t line);
    void arc(const Arc& arc, std::int64_t line);
    void set_position(const SetPosition& position);
    void home(const Home& home);
    void change(const SetLimits& limits);
    void pass(const MotionEvent& event) { queue_.pass(event); }
    void drain() { queue_.drain(); }
    [[nodiscard]] Planned measured(const StepMove& taken, double feed) const;
    [[nodiscard]] float path_acceleration(const StepMove& taken, float steps_per_mm) const;
    [[nodiscard]] float corner_by_deviation(const Planned& planned, bool first);
    [[nodiscard]] float corner_by_jerk(const Planned& planned, bool first);

    Limits limits_;
    MarlinOptions options_;
    LookAhead queue_;
    StepFrame frame_;
    Position place_{};  // mm, as told

    // Of the block added last.
    Floats previous_speed_{}, previous_direction_{};
    float previous_nominal_ = 0, previous_safe_ = 0;
};

}  // namespace bead
