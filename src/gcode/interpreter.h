// The meaning of G-code: lines of text to commands, given the state that earlier lines left (units,
// absolute or relative, place, feed). The firmware followed is Prusa's of 2023: G90 and G91 leave
// the extruder's mode alone, M82 and M83 set it, an F that is not above 0 is passed over.
#pragma once
#include <optional>
#include <string>
#include <string_view>

#include "gcode/comments.h"
#include "gcode/reader.h"
#include "gcode/scanner.h"

namespace bead {

class Interpreter {
  public:
    // The sink must outlive the interpreter.
    Interpreter(const ReadOptions& options, const CommandSink& sink)
        : name_(options.name), sink_(sink), feed_(options.first_feed) {}

    void read(std::string_view line);
    // After the last line. Throws Error if nothing ever moved.
    GcodeReport finish();

  private:
    struct Rule;
    static const Rule* rule_of(const Line& line);
    void obey(const Rule& rule, const Words& words);

    void move(const Words& words);
    void tell_move(double from_z, bool extrudes);
    void home(const Words& words);
    void set_position(const Words& words);
    void dwell(const Words& words);
    void set_heat(const Words& words, Heater heater, bool wait);
    void set_fan(const Words& words);
    void set_limits(const Words& words, PerAxis<std::optional<double>> SetLimits::*limits);
    void set_accelerations(const Words& words);
    void set_relative(bool on) { relative_[axis_x] = relative_[axis_y] = relative_[axis_z] = on; }
    template <class What>
    void tell(const What& what);

    [[nodiscard]] double place_told(const Words& words, Axis axis, bool relative) const;
    void note_malformed();
    void ignore(std::string_view name, std::string_view how = {});
    [[noreturn]] void fail(const std::string& complaint) const;

    std::string name_;
    const CommandSink& sink_;
    GcodeReport report_;
    Annotations annotations_;
    std::string_view command_;  // of the line being read, for the report
    bool moved_ = false;

    Position place_{};  // mm, in the frame of the last G92
    double feed_;       // mm/s
    double unit_ = 1;   // mm per unit of the text
    PerAxis<bool> relative_{};
    Command move_{Move{}, 0};  // made once, changed for every move
};

}  // namespace bead
