// The meaning of G-code: lines of text to commands, given the state that earlier lines left (units,
// absolute or relative, place, feed) and the firmware's dialect. An F that is not above 0 is passed
// over, as firmware does.
#pragma once
#include <array>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "gcode/comments.h"
#include "gcode/dialect.h"
#include "gcode/file_state.h"
#include "gcode/limit_words.h"
#include "gcode/move_words.h"
#include "gcode/reader.h"
#include "gcode/retraction.h"
#include "gcode/scanner.h"

namespace bead {

class Interpreter {
  public:
    // The sink must outlive the interpreter.
    Interpreter(const ReadOptions& options, const CommandSink& sink)
        : name_(options.name),
          sink_(sink),
          dialect_(dialect_of(options.firmware)),
          feed_(options.first_feed),
          retraction_(usual_retraction(dialect_)) {}

    // Whole lines, each with its end.
    void read_lines(std::string_view text);
    [[nodiscard]] std::int64_t lines() const { return report_.lines; }
    [[nodiscard]] std::int64_t malformed() const { return report_.malformed; }
    [[nodiscard]] const Annotations& annotations() const { return annotations_; }
    [[nodiscard]] FileState state() const {
        return {.place = frame_.place,
                .feed = feed_,
                .unit = unit_,
                .absolute_e = !relative_[axis_e],
                .relative_xyz = g91_,
                .renamed_xy = frame_.shift[axis_x] != 0 || frame_.shift[axis_y] != 0,
                .pulled_back = retracted_};
    }
    // After the last line. Throws Error if nothing ever moved.
    GcodeReport finish();

  private:
    struct Rule;
    // Where the machine is. Commands count from where a SetPosition left them; the file counts from
    // elsewhere once the firmware has moved by itself (G10) or gone back to a saved state.
    struct Frame {
        Position place{};  // mm, as the file counts
        Position shift{};  // what commands count more
        Position base{};   // what the machine counts more, having heard of no G92
    };
    struct SavedState {
        Frame frame;
        bool g91 = false, m83 = false;
        double feed = 0;
    };

    // interpreter.cpp: lines, what they come to, the report
    void read(std::string_view line);
    static const Rule* rule_of(const Line& line);
    void obey(const Rule& rule, const Words& words);
    void run_macro(const Line& line);
    template <class What>
    void tell(const What& what) {
        if (const auto layer = annotations_.layer_due()) sink_({*layer, report_.lines});
        sink_({what, report_.lines});
    }
    void note_malformed();
    void ignore(std::string_view name, std::string_view how = {});
    [[noreturn]] void fail(const std::string& complaint) const;
    [[nodiscard]] bool in(unsigned dialects) const { return (dialect_ & dialects) != 0; }
    void become_reprap();
    void set_relative(bool on);
    void set_extruder_relative(bool on);
    void update_modes();
    void pause();
    void dwell(const Words& words);
    void set_heat(const Words& words, Heater heater, bool wait);
    void set_fan(const Words& words);
    void set_max_accelerations(const Words& words);
    void set_feedrates(const Words& words);
    void set_jerk(const Words& words);
    void set_klipper_retraction(std::string_view words);
    void tell_limits(const std::optional<SetLimits>& limits);

    // interpreter_moves.cpp: what changes the place
    [[nodiscard]] double place_at(double place, std::size_t axis) const;  // or fails
    [[nodiscard]] Position target(const MoveWords& words) const;
    void take_feed(const MoveWords& words);
    void move(const MoveWords& words);
    void arc(const Words& words, bool clockwise);
    [[nodiscard]] std::optional<Arc> arc_told(const Words& words, const Position& to,
                                              bool clockwise) const;
    void curve(const Words& words);
    void go(const Position& to);
    const Move& begin(const Position& to, bool across);
    [[nodiscard]] Position as_commanded(const Position& place) const;
    void home(const Words& words);
    void set_position(const Words& words);
    void retract(const Words& words);
    void recover();
    void shift(Axis axis, double by, double feed);
    void save_state(std::string_view words);
    void restore_state(std::string_view words);

    std::string name_;
    const CommandSink& sink_;
    Dialect dialect_;
    GcodeReport report_;
    Annotations annotations_;
    std::string_view line_, command_;  // being read
    bool moved_ = false;

    Frame frame_;
    double feed_;              // mm/s
    double unit_ = 1;          // mm per unit of the text
    Plane plane_ = Plane::xy;  // of arcs
    bool g91_ = false, m83_ = false;
    PerAxis<bool> relative_{};  // what these two come to
    Retraction retraction_;
    bool retracted_ = false;
    double pulled_back_ = 0, lifted_ = 0;      // mm, by G10
    std::optional<double> head_acceleration_;  // mm/s², as last told to Klipper
    AxisLimits feedrates_told_{};              // mm/s, as long as they are taken for that
    std::map<std::string, SavedState, std::less<>> saved_;
    Command move_{Move{}, 0};  // made once, changed for every move
};

}  // namespace bead
