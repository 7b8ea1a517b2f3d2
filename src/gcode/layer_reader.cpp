#include "gcode/layer_reader.h"

#include <array>
#include <cmath>
#include <cstring>
#include <utility>

#include "core/error.h"
#include "gcode/interpreter.h"
#include "gcode/line_reader.h"
#include "gcode/line_use.h"

namespace bead {
namespace {

constexpr double arc_sagitta = 0.005;   // mm, between an arc and its chords
constexpr double largest_radius = 1e5;  // mm
constexpr double off_circle = 0.1;      // mm, and a hundredth of the radius
constexpr std::size_t most_chords = 5000;

// From the centre, anticlockwise, 0 … 2π; a whole circle if start and end are the same place.
double sweep(Vec2 from, Vec2 to, bool clockwise) {
    const double turn = std::atan2(cross(from, to), dot(from, to)) * (clockwise ? -1 : 1);
    return turn > 1e-9 ? turn : turn + 2 * pi;
}

}  // namespace

std::string_view text_of(const FileLayer& layer, std::size_t line) {
    const std::uint32_t begin = line == 0 ? 0 : layer.lines[line - 1].text_end;
    return std::string_view(layer.text).substr(begin, layer.lines[line].text_end - begin);
}

struct LayerReader::State {
    std::string name;
    TextSource source;
    CommandSink sink;
    Interpreter interpreter;
    LineReader reader;
    std::string_view piece;  // whole lines not yet read
    FileLayer layer;
    bool begun = false;      // something is in `layer`
    bool announced = false;  // `layer` begins with a comment that says so
    // of the line being read
    std::optional<LayerStart> start;
    FileLine line;
    std::vector<FileMove> moves;
    Position place{};
    double fan = 0;

    State(TextSource text, const ReadOptions& options)
        : name(options.name),
          source(std::move(text)),
          sink([this](const Command& command) { hear(command); }),
          interpreter(options, sink),
          reader(source, options.name, {}) {
        layer.before = interpreter.state();
    }

    void hear(const Command& command) {
        if (const Move* const move = std::get_if<Move>(&command.what)) return add(*move);
        if (const Arc* const arc = std::get_if<Arc>(&command.what)) return add(*arc);
        if (const auto* const told = std::get_if<LayerStart>(&command.what)) start = *told;
        if (const auto* const set = std::get_if<SetFan>(&command.what))
            line.value = fan = set->duty;
        if (const auto* const set = std::get_if<SetLimits>(&command.what))
            line.value = set->acceleration.value_or(set->max_acceleration_head.value_or(0));
    }
    void add(const Move& move) { moves.push_back({{}, 0, move.feed, move.role, move.bead}); }

    void add(const Arc& arc) {
        line.odd_arc = arc.plane != Plane::xy || arc.more_turns > 0;
        add(arc.end);
        if (line.odd_arc) return;
        const Vec2 start_at{place[axis_x], place[axis_y]};
        const Vec2 centre{arc.centre[0], arc.centre[1]};
        check_arc(distance(centre, start_at),
                  distance(centre, {arc.end.to[axis_x], arc.end.to[axis_y]}));
        add_chords(arc, start_at - centre);
    }
    void check_arc(double radius, double end_radius) const {
        if (radius > largest_radius)
            fail("an arc of a radius beyond 100 m; was it meant to be a line?");
        if (std::abs(end_radius - radius) > off_circle + radius / 100)
            fail("an arc whose end is not on its circle; correct the centre or the end");
    }
    // All but the last, whose end is where the line leads.
    void add_chords(const Arc& arc, Vec2 from) {
        const FileMove last = moves.back();
        const Vec2 centre{arc.centre[0], arc.centre[1]};
        const Vec2 to = Vec2{arc.end.to[axis_x], arc.end.to[axis_y]} - centre;
        const double radius = length(from), end_radius = length(to);
        const double angle = sweep(from, to, arc.clockwise);
        const double step =
            2 * std::acos(1 - std::min(1.0, arc_sagitta / std::max(radius, arc_sagitta)));
        const auto count = std::min(most_chords, std::size_t(std::ceil(angle / step)));
        for (std::size_t i = 1; i < count; ++i) {
            const double part = double(i) / double(count);
            const double r = std::lerp(radius, end_radius, part);
            const Vec2 at =
                centre + r / radius * rotated(from, unit(part * (arc.clockwise ? -angle : angle)));
            FileMove chord = last;
            // Z and E, which the arc takes evenly along, are set when the line is done.
            chord.to = {at.x, at.y, part, part};
            moves.insert(moves.end() - 1, chord);
        }
    }

    [[noreturn]] void fail(const std::string& complaint) const {
        throw Error(name + ":" + std::to_string(interpreter.lines()) + ": " + complaint);
    }

    // What the file counts after the line; arcs' chords lie between.
    void place_moves(const FileState& after) {
        const Position from = place, to = after.place;
        double e = from[axis_e];
        for (std::size_t i = 0; i + 1 < moves.size(); ++i)
            for (const Axis axis : {axis_z, axis_e})
                moves[i].to[axis] = std::lerp(from[axis], to[axis], moves[i].to[axis]);
        if (!moves.empty()) moves.back().to = to;
        for (FileMove& move : moves) {
            move.filament = move.to[axis_e] - e;
            e = move.to[axis_e];
        }
        place = to;
    }

    bool fetch() {
        if (piece.empty()) piece = reader.next(interpreter.lines());
        return !piece.empty();
    }

    // Reads one line into `line`, `moves` and `start`.
    std::string_view read_line(FileState& before) {
        const auto* const stop =
            static_cast<const char*>(std::memchr(piece.data(), '\n', piece.size()));
        const std::string_view text = piece.substr(0, std::size_t(stop - piece.data()) + 1);
        piece.remove_prefix(text.size());
        before = interpreter.state();
        line = {};
        moves.clear();
        start.reset();
        const std::int64_t malformed = interpreter.malformed();
        interpreter.read_lines(text);
        const FileState after = interpreter.state();
        line.use =
            interpreter.malformed() > malformed ? LineUse::other : use_of(text, before, after);
        if (line.use == LineUse::recoil || line.use == LineUse::other) {
            place = after.place;
            keep_last_move();
        } else {
            place_moves(after);
        }
        return text;
    }
    // Of what the firmware does by itself only the end is known.
    void keep_last_move() {
        if (moves.empty()) return;
        moves.resize(1);
        moves.front().to = place;
    }

    void append(std::string_view text) {
        layer.text += text;
        layer.moves.insert(layer.moves.end(), moves.begin(), moves.end());
        line.text_end = std::uint32_t(layer.text.size());
        line.moves_end = std::uint32_t(layer.moves.size());
        layer.lines.push_back(line);
        if (start) layer.layer = start;
        layer.after = interpreter.state();
        begun = true;
    }

    FileLayer cut(const FileState& at, double fan_before) {
        FileLayer done = std::exchange(layer, {});
        layer.before = at;
        layer.fan = fan_before;
        layer.first_line = done.first_line + std::int64_t(done.lines.size());
        begun = false;
        return done;
    }

    std::optional<FileLayer> next() {
        while (fetch()) {
            FileState before;
            const double fan_before = fan;
            const bool pending = interpreter.annotations().announces_layer();
            const std::string_view text = read_line(before);
            const bool announces = !pending && interpreter.annotations().announces_layer();
            const bool begins = announces || (start && !announced);
            std::optional<FileLayer> done;
            if (begins && begun) done = cut(before, fan_before);
            if (begins) announced = announces;
            append(text);
            if (done) return done;
        }
        if (!begun) return {};
        return cut(interpreter.state(), fan);
    }
};

LayerReader::LayerReader(TextSource source, const ReadOptions& options)
    : state_(std::make_unique<State>(std::move(source), options)) {}
LayerReader::~LayerReader() = default;

std::optional<FileLayer> LayerReader::next() { return state_->next(); }
std::int64_t LayerReader::bytes() const { return state_->reader.bytes(); }
GcodeReport LayerReader::finish() {
    GcodeReport report = state_->interpreter.finish();
    report.bytes = bytes();
    return report;
}

}  // namespace bead
