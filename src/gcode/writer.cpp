#include "gcode/writer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string_view>

#include "core/expects.h"
#include "gcode/comments.h"
#include "gcode/fixed_point.h"

namespace bead {
namespace {

constexpr std::string_view written_axes = "XYZE";
constexpr PerAxis<int> decimals{3, 3, 3, 5};
constexpr int value_decimals = 3;    // of feeds, temperatures, limits
constexpr int fine_decimals = 5;     // of limits that are small: mm of deviation, ratios
constexpr int comment_decimals = 5;  // of layers and beads
constexpr std::array all_axes{axis_x, axis_y, axis_z, axis_e};

// By Plane: its word, its axes and the words for the centre along these.
struct WrittenPlane {
    std::string_view command;
    std::array<Axis, 2> axes;
    std::array<char, 2> centre;
};
constexpr std::array written_planes{WrittenPlane{"G17\n", {axis_x, axis_y}, {'I', 'J'}},
                                    WrittenPlane{"G18\n", {axis_z, axis_x}, {'K', 'I'}},
                                    WrittenPlane{"G19\n", {axis_y, axis_z}, {'J', 'K'}}};

std::string commented(std::string_view header) {
    std::string text;
    while (!header.empty()) {
        const auto end = std::min(header.find('\n'), header.size());
        text.append("; ").append(header.substr(0, end)).append("\n");
        header.remove_prefix(std::min(end + 1, header.size()));
    }
    return text;
}

}  // namespace

struct GcodeWriter::State {
    using Counts = PerAxis<std::int64_t>;

    std::ostream& out;
    const bool relative_e;
    std::string text;                  // of the command being written
    Counts place{};                    // in units of the last decimal, as a reader knows it
    std::optional<std::int64_t> feed;  // likewise, mm/min
    Plane plane = Plane::xy;           // last one chosen
    Role role = Role::travel;          // last one named
    Bead bead;                         // last one named

    State(std::ostream& stream, const WriteOptions& options)
        : out(stream), relative_e(options.relative_e), text(commented(options.header)) {
        text += "G21\nG90\n";
        text += relative_e ? "M83\n" : "M82\n";
        flush();
    }

    void flush() {
        out.write(text.data(), std::streamsize(text.size()));
        text.clear();
    }

    void word(char letter, double value, int places = value_decimals) {
        text += ' ';
        text += letter;
        append_fixed(text, fixed(value, places), places);
    }
    void optional_word(char letter, const std::optional<double>& value,
                       int places = value_decimals) {
        if (value) word(letter, *value, places);
    }
    // KEY=value, as Klipper takes it.
    void key_word(std::string_view key, const std::optional<double>& value) {
        if (!value) return;
        text.append(" ").append(key).append("=");
        append_fixed(text, fixed(*value, fine_decimals), fine_decimals);
    }
    void comment(std::string_view tag, double value) {
        text += tag;
        append_fixed(text, fixed(value, comment_decimals), comment_decimals);
        text += '\n';
    }
    void axis_word(Axis axis, std::int64_t value) {
        text += ' ';
        text += written_axes[axis];
        append_fixed(text, value, decimals[axis]);
    }
    void axis_words(const PerAxis<std::optional<double>>& values) {
        for (const Axis axis : all_axes) optional_word(written_axes[axis], values[axis]);
    }
    // The command with the words that `add` appends; nothing if it appends none.
    template <class AddWords>
    void line(std::string_view command, const AddWords& add) {
        const std::size_t start = text.size();
        text += command;
        add();
        if (text.size() == start + command.size())
            text.resize(start);
        else
            text += '\n';
    }

    void name(const Move& move) {
        if (move.role == Role::travel) return;
        if (move.role != role) text.append(";TYPE:").append(prusa_word(move.role)).append("\n");
        if (move.bead.width != bead.width) comment(";WIDTH:", move.bead.width);
        if (move.bead.height != bead.height) comment(";HEIGHT:", move.bead.height);
        role = move.role;
        bead = move.bead;
    }

    static Counts counted(const Position& place) {
        Counts counts;
        for (const Axis axis : all_axes) counts[axis] = fixed(place[axis], decimals[axis]);
        return counts;
    }

    void go(const Counts& to, double speed) {
        for (const Axis axis : all_axes)
            if (to[axis] != place[axis])
                axis_word(axis, axis == axis_e && relative_e ? to[axis] - place[axis] : to[axis]);
        place = to;
        const std::int64_t asked = fixed(speed * 60, value_decimals);
        if (asked > 0 && asked != feed) {
            feed = asked;
            text += " F";
            append_fixed(text, asked, value_decimals);
        }
        text += '\n';
    }

    void write(const Move& move) {
        const Counts to = counted(move.to);
        if (to == place) return;
        name(move);
        text += "G1";
        go(to, move.feed);
    }

    // The centre is told from the start, in whole units of the last decimal like places.
    void write(const Arc& arc) {
        const WrittenPlane& words = written_planes[std::size_t(arc.plane)];
        if (arc.plane != plane) text += words.command;
        plane = arc.plane;
        name(arc.end);
        text += arc.clockwise ? "G2" : "G3";
        for (const std::size_t i : {0U, 1U}) {
            const int places = decimals[words.axes[i]];
            text.append(" ").append(1, words.centre[i]);
            append_fixed(text, fixed(arc.centre[i], places) - place[words.axes[i]], places);
        }
        if (arc.more_turns > 0) text.append(" P").append(std::to_string(arc.more_turns));
        go(counted(arc.end.to), arc.end.feed);
    }

    void write(const SetPosition& position) {
        if (position.to == PerAxis<std::optional<double>>{}) return;
        text += "G92";
        for (const Axis axis : all_axes) {
            if (!position.to[axis]) continue;
            place[axis] = fixed(*position.to[axis], decimals[axis]);
            axis_word(axis, place[axis]);
        }
        text += '\n';
    }

    void write(const Home& home) {
        BEAD_EXPECTS(home.axes[0] || home.axes[1] || home.axes[2]);
        text += "G28";
        const bool all = home.axes == Home{}.axes;
        for (const Axis axis : {axis_x, axis_y, axis_z}) {
            if (!home.axes[axis]) continue;
            place[axis] = 0;
            if (!all) text.append(" ").append(1, written_axes[axis]);
        }
        text += '\n';
    }

    void write(const Dwell& dwell) {
        text += "G4";
        word('P', dwell.duration * 1000);
        text += '\n';
    }

    void write(const Drain&) { text += "M400\n"; }

    void write(const SetHeat& heat) {
        const bool bed = heat.heater == Heater::bed;
        text += heat.wait ? (bed ? "M190" : "M109") : (bed ? "M140" : "M104");
        word('S', heat.celsius);
        text += '\n';
    }

    void write(const SetFan& fan) {
        const long level = std::clamp(std::lround(fan.duty * 255), 0L, 255L);
        text += level > 0 ? "M106 S" + std::to_string(level) + "\n" : "M107\n";
    }

    void write(const SetLimits& limits) {
        line("M201", [&] { axis_words(limits.max_acceleration); });
        line("M203", [&] { axis_words(limits.max_feedrate); });
        line("M205", [&] {
            axis_words(limits.jerk);
            optional_word('J', limits.junction_deviation, fine_decimals);
        });
        line("M204", [&] {
            optional_word('P', limits.acceleration);
            optional_word('R', limits.retract_acceleration);
            optional_word('T', limits.travel_acceleration);
        });
        line("SET_VELOCITY_LIMIT", [&] {
            key_word("VELOCITY", limits.max_velocity);
            key_word("ACCEL", limits.max_acceleration_head);
            key_word("SQUARE_CORNER_VELOCITY", limits.square_corner_velocity);
            key_word("MINIMUM_CRUISE_RATIO", limits.minimum_cruise_ratio);
        });
    }

    // The height is named even if it is 0, so that a bead's own height that follows is not taken
    // for it.
    void write(const LayerStart& layer) {
        text += ";LAYER_CHANGE\n";
        comment(";Z:", layer.z);
        comment(";HEIGHT:", layer.height);
        bead.height = layer.height;
    }
};

GcodeWriter::GcodeWriter(std::ostream& out, const WriteOptions& options)
    : state_(std::make_unique<State>(out, options)) {}
GcodeWriter::GcodeWriter(GcodeWriter&&) noexcept = default;
GcodeWriter::~GcodeWriter() = default;

void GcodeWriter::write(const Command& command) {
    std::visit([&](const auto& what) { state_->write(what); }, command.what);
    state_->flush();
}

}  // namespace bead
