// What changes the machine's place, or what it is called.
#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "gcode/arc_centre.h"
#include "gcode/curve.h"
#include "gcode/interpreter.h"
#include "gcode/key_words.h"

namespace bead {
namespace {

constexpr std::array axes{axis_x, axis_y, axis_z, axis_e};
constexpr std::string_view axis_letters = "XYZE";
constexpr PerAxis<double> farthest_place{1e6, 1e6, 1e6, 1e9};  // mm; E is 1000 km of filament
constexpr int most_turns = 100;                                // of one arc, as in Marlin
constexpr double fastest = 1e4;  // mm/s: as fast as the axis' limit lets it
constexpr std::size_t most_saved = 1000;

// By Plane: its axes and the words for the centre along these.
struct PlaneWords {
    std::array<Axis, 2> axes;
    std::array<char, 2> centre;
};
constexpr std::array planes{PlaneWords{{axis_x, axis_y}, {'I', 'J'}},
                            PlaneWords{{axis_z, axis_x}, {'K', 'I'}},
                            PlaneWords{{axis_y, axis_z}, {'J', 'K'}}};

double number_or_0(const Words& words, char letter) {
    return words.has(letter) ? words.at(letter) : 0;
}

}  // namespace

void Interpreter::take_feed(const MoveWords& words) {
    if (words.has(MoveWords::feed) && words.number[MoveWords::feed] > 0)
        feed_ = words.number[MoveWords::feed] * unit_ / 60;
}

double Interpreter::place_at(double place, std::size_t axis) const {
    if (std::abs(place) > farthest_place[axis])
        fail(std::string("the move leads beyond ") + std::to_string(farthest_place[axis] / 1e6) +
             " km in " + axis_letters[axis] + "; correct or remove it");
    return place;
}

Position Interpreter::target(const MoveWords& words) const {
    Position to = frame_.place;
    for (const Axis axis : axes) {
        if (!words.has(axis)) continue;
        const double told = words.number[axis] * unit_;
        to[axis] = place_at(relative_[axis] ? to[axis] + told : told, axis);
    }
    return to;
}

Position Interpreter::as_commanded(const Position& place) const {
    Position to;
    for (const Axis axis : axes) to[axis] = place[axis] + frame_.shift[axis];
    return to;
}

void Interpreter::move(const MoveWords& words) {
    take_feed(words);
    if ((words.told & MoveWords::axes) != 0) go(target(words));
}

// The move that is about to be told, but for where it leads; the layer that it begins comes first.
const Move& Interpreter::begin(const Position& to, bool across) {
    const bool extrudes = across && to[axis_e] > frame_.place[axis_e];
    const auto layer = extrudes ? annotations_.layer_due(frame_.place[axis_z], to[axis_z])
                                : annotations_.layer_due();
    if (layer) sink_({*layer, report_.lines});
    auto& move = std::get<Move>(move_.what);
    move.to = as_commanded(to);
    move.feed = feed_;
    move.role = extrudes ? annotations_.role() : Role::travel;
    move.bead = extrudes ? annotations_.bead() : Bead{};
    frame_.place = to;
    moved_ = true;
    return move;
}

void Interpreter::go(const Position& to) {
    const Position& from = frame_.place;
    begin(to, to[axis_x] != from[axis_x] || to[axis_y] != from[axis_y]);
    move_.line = report_.lines;
    sink_(move_);
}

void Interpreter::arc(const Words& words, bool clockwise) {
    const MoveWords told = move_words(words);
    take_feed(told);
    const Position to = target(told);
    auto arc = arc_told(words, to, clockwise);
    if (!arc) return note_malformed();
    arc->end = begin(to, true);
    sink_({*arc, report_.lines});
}

// All but the end. Nothing where there is no circle: then firmware makes no move.
std::optional<Arc> Interpreter::arc_told(const Words& words, const Position& to,
                                         bool clockwise) const {
    const auto [p, q] = planes[std::size_t(plane_)].axes;
    const auto [p_word, q_word] = planes[std::size_t(plane_)].centre;
    const Position& from = frame_.place;
    Vec2 centre{number_or_0(words, p_word) * unit_, number_or_0(words, q_word) * unit_};
    if (in(klipper_dialect) && (g91_ || words.has('R'))) return {};
    if (in(marlin_dialect | reprap_dialect) && words.has('R'))
        centre = arc_centre({to[p] - from[p], to[q] - from[q]}, words.at('R') * unit_, clockwise)
                     .value_or(Vec2{});
    if (centre == Vec2{}) return {};
    if (length(centre) > farthest_place[axis_x])
        fail("the arc's radius is more than " + std::to_string(farthest_place[axis_x] / 1e6) +
             " km; correct or remove it");
    const double turns = in(marlin_dialect) ? number_or_0(words, 'P') : 0;
    if (turns < 0 || turns > most_turns) return {};
    return Arc{
        .end = {},
        .centre = {from[p] + frame_.shift[p] + centre.x, from[q] + frame_.shift[q] + centre.y},
        .clockwise = clockwise,
        .plane = plane_,
        .more_turns = int(turns)};
}

void Interpreter::curve(const Words& words) {
    const MoveWords told = move_words(words);
    take_feed(told);
    if (plane_ != Plane::xy) return note_malformed();
    const Position from = frame_.place, to = target(told);
    const auto control = [&](const Position& base, char x, char y) {
        return Vec2{place_at(base[axis_x] + number_or_0(words, x) * unit_, axis_x),
                    place_at(base[axis_y] + number_or_0(words, y) * unit_, axis_y)};
    };
    const Vec2 start{from[axis_x], from[axis_y]}, end{to[axis_x], to[axis_y]};
    for (const CurvePoint& point :
         curve_chords({start, control(from, 'I', 'J'), control(to, 'P', 'Q'), end})) {
        const auto along = [&](Axis axis) {
            return (1 - point.share) * from[axis] + point.share * to[axis];
        };
        go({point.at.x, point.at.y, along(axis_z), along(axis_e)});
    }
}

void Interpreter::home(const Words& words) {
    Home home{{words.names('X'), words.names('Y'), words.names('Z')}};
    if (std::ranges::none_of(home.axes, std::identity{})) home = Home{};
    for (const Axis axis : {axis_x, axis_y, axis_z})
        if (home.axes[axis]) frame_.place[axis] = frame_.shift[axis] = frame_.base[axis] = 0;
    if (home.axes[axis_z]) lifted_ = 0;
    tell(home);
    moved_ = true;
}

void Interpreter::set_position(const Words& words) {
    const MoveWords told = move_words(words);
    if (!words.none() && (told.told & MoveWords::axes) == 0) return ignore(command_);
    SetPosition position;
    for (const Axis axis : axes) {
        if (!told.has(axis) && !words.none()) continue;
        const double place = told.has(axis) ? place_at(told.number[axis] * unit_, axis) : 0;
        frame_.base[axis] += frame_.place[axis] - place;
        frame_.place[axis] = place;
        frame_.shift[axis] = 0;
        position.to[axis] = place;
    }
    tell(position);
}

// The firmware moves by itself: the file goes on counting as if it had not.
void Interpreter::shift(Axis axis, double by, double feed) {
    if (by == 0) return;
    frame_.shift[axis] = place_at(frame_.shift[axis] + by, axis);
    frame_.base[axis] += by;
    Move move;
    move.to = as_commanded(frame_.place);
    move.feed = feed;
    tell(move);
    moved_ = true;
}

void Interpreter::retract(const Words& words) {
    if (words.any_of(Words::bit('L') | Words::bit('P') | Words::bit('R') | Words::bit('S')))
        return ignore(command_, " (not a retraction)");
    if (retracted_) return;
    retracted_ = true;
    pulled_back_ = retraction_.length;
    shift(axis_e, -pulled_back_, retraction_.speed);
    if (lifted_ != 0) return;
    lifted_ = retraction_.lift;
    shift(axis_z, lifted_, fastest);
}

void Interpreter::recover() {
    if (!retracted_) return;
    retracted_ = false;
    shift(axis_z, -lifted_, fastest);
    lifted_ = 0;
    shift(axis_e, pulled_back_ + retraction_.extra, retraction_.recover_speed);
}

void Interpreter::save_state(std::string_view words) {
    const std::string name(value_of(words, "NAME").value_or("default"));
    if (saved_.size() >= most_saved && !saved_.contains(name))
        return ignore(command_, " (of too many names)");
    saved_[name] = {frame_, g91_, m83_, feed_};
}

// Places are called again what they were called then; the filament goes on where it is.
void Interpreter::restore_state(std::string_view words) {
    const auto found = saved_.find(value_of(words, "NAME").value_or("default"));
    if (found == saved_.end()) return note_malformed();
    const SavedState& state = found->second;
    const Frame now = frame_;
    for (const Axis axis : axes) {
        const double machine = now.place[axis] + now.base[axis];
        const double commanded = now.place[axis] + now.shift[axis];
        frame_.place[axis] =
            axis == axis_e ? state.frame.place[axis] : machine - state.frame.base[axis];
        frame_.base[axis] = machine - frame_.place[axis];
        frame_.shift[axis] = commanded - frame_.place[axis];
    }
    g91_ = state.g91;
    m83_ = state.m83;
    feed_ = state.feed;
    update_modes();
    if (number_of(words, "MOVE").value.value_or(0) == 0) return;
    const double feed = feed_;
    const auto told = number_of(words, "MOVE_SPEED").value;
    if (told && *told > 0) feed_ = *told;
    Position back = state.frame.place;
    back[axis_e] = frame_.place[axis_e];
    go(back);
    feed_ = feed;
}

}  // namespace bead
