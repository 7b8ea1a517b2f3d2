// A layer's Toolpath as lines of G-code in the style of the file they are put into: rounded to 1 µm
// and 10 nm of filament, so that what is read back is what is written; filament lengths from beads;
// retraction, lift, feature comments and accelerations as the file has them elsewhere.
#pragma once
#include <optional>
#include <string>

#include "gcode/motion_style.h"
#include "toolpath/command.h"

namespace bead {

struct MotionState {
    Position at{};            // mm, as the text counts
    double pulled_back = 0;   // mm of filament
    double feed = 0;          // mm/s, as the text last said
    double acceleration = 0;  // mm/s², likewise; 0: unknown
};

class MotionText {
  public:
    MotionText(const MotionStyle& style, const MotionState& state);

    // With lines of G2 and G3 where points lie on an arc, to within this (mm).
    void fit_arcs(double tolerance) { arc_tolerance_ = tolerance; }
    // The first path may begin elsewhere than the nozzle is: it goes there.
    void follow(const Toolpath& layer, double z);
    // From here on with this acceleration (mm/s²), if the file has words for it.
    void ask(double acceleration);
    // Leads to the state, as text that follows expects it.
    void restore(const MotionState& to);

    [[nodiscard]] const std::string& text() const { return text_; }
    [[nodiscard]] const MotionState& state() const { return state_; }
    [[nodiscard]] double filament() const { return fed_; }  // mm, pulling back not counted

  private:
    void travel(const Path& path);
    void print(const Path& path);
    void print_line(Vec2 to, double filament, double speed);
    void print_pieces(const Path& path, double per_mm);
    void print_arc(Vec2 to, Vec2 centre, bool clockwise, double filament, double speed);
    void name(const Path& path);

    void pull_back(double to, double speed);
    void raise(double z);
    void go(Vec2 to, double speed);
    void set_e(double e);
    void feed_word(double speed);
    void word(char letter, double value, int decimals);
    void end_line();
    [[nodiscard]] bool is_at(Vec2 place) const;

    const MotionStyle& style_;
    MotionState state_;
    std::string text_;
    double arc_tolerance_ = 0;
    double z_ = 0, fed_ = 0, exact_e_ = 0;
    std::optional<Role> role_;
    std::int64_t width_ = -1, height_ = -1;  // µm, as last named
};

}  // namespace bead
