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

constexpr std::string_view axis_letters = "XYZE";
constexpr PerAxis<int> decimals{3, 3, 3, 5};
constexpr int value_decimals = 3;    // of feeds, temperatures, limits
constexpr int comment_decimals = 5;  // of layers and beads
constexpr std::array axes{axis_x, axis_y, axis_z, axis_e};

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
    std::ostream& out;
    const bool relative_e;
    std::string text;                  // of the command being written
    PerAxis<std::int64_t> place{};     // in units of the last decimal, as a reader knows it
    std::optional<std::int64_t> feed;  // likewise, mm/min
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

    void word(char letter, double value) {
        text += ' ';
        text += letter;
        append_fixed(text, fixed(value, value_decimals), value_decimals);
    }
    void comment(std::string_view tag, double value) {
        text += tag;
        append_fixed(text, fixed(value, comment_decimals), comment_decimals);
        text += '\n';
    }
    void axis_word(Axis axis, std::int64_t value) {
        text += ' ';
        text += axis_letters[axis];
        append_fixed(text, value, decimals[axis]);
    }
    void axis_words(std::string_view command, const PerAxis<std::optional<double>>& values) {
        if (std::ranges::none_of(values, [](const auto& value) { return value.has_value(); }))
            return;
        text += command;
        for (const Axis axis : axes)
            if (values[axis]) word(axis_letters[axis], *values[axis]);
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

    void write(const Move& move) {
        PerAxis<std::int64_t> to;
        for (const Axis axis : axes) to[axis] = fixed(move.to[axis], decimals[axis]);
        if (to == place) return;
        name(move);
        text += "G1";
        for (const Axis axis : axes)
            if (to[axis] != place[axis])
                axis_word(axis, axis == axis_e && relative_e ? to[axis] - place[axis] : to[axis]);
        place = to;
        const std::int64_t asked = fixed(move.feed * 60, value_decimals);
        if (asked > 0 && asked != feed) {
            feed = asked;
            text += " F";
            append_fixed(text, asked, value_decimals);
        }
        text += '\n';
    }

    void write(const Arc& arc) { write(arc.end); }

    void write(const SetPosition& position) {
        if (position.to == PerAxis<std::optional<double>>{}) return;
        text += "G92";
        for (const Axis axis : axes) {
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
            if (!all) text.append(" ").append(1, axis_letters[axis]);
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
        axis_words("M201", limits.max_acceleration);
        axis_words("M203", limits.max_feedrate);
        axis_words("M205", limits.jerk);
        if (!limits.acceleration && !limits.retract_acceleration && !limits.travel_acceleration)
            return;
        text += "M204";
        if (limits.acceleration) word('P', *limits.acceleration);
        if (limits.retract_acceleration) word('R', *limits.retract_acceleration);
        if (limits.travel_acceleration) word('T', *limits.travel_acceleration);
        text += '\n';
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
