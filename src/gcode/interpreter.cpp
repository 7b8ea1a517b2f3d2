#include "gcode/interpreter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "core/error.h"

namespace bead {
namespace {

constexpr std::string_view axis_letters = "XYZE";
constexpr std::uint32_t axis_bits =
    Words::bit('X') | Words::bit('Y') | Words::bit('Z') | Words::bit('E');
constexpr double mm_per_inch = 25.4;
constexpr PerAxis<double> farthest{1e6, 1e6, 1e6, 1e9};  // mm; E is 1000 km of filament
constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
constexpr std::size_t most_names = 200;  // of ignored commands; the rest is counted together
constexpr std::size_t longest_name = 40;

std::string capitals(std::string_view text) {
    std::string all(text.substr(0, longest_name));
    for (char& c : all)
        if (c >= 'a' && c <= 'z') c = char(c - 'a' + 'A');
    return all;
}

std::optional<double> first_of(const Words& words, std::string_view letters) {
    for (const char letter : letters)
        if (words.has(letter)) return words.at(letter);
    return {};
}

}  // namespace

// What a command does. `bare`: its letters need no numbers.
struct Interpreter::Rule {
    char letter;
    int number;
    void (*act)(Interpreter&, const Words&);
    bool bare = false;
};

const Interpreter::Rule* Interpreter::rule_of(const Line& line) {
    using I = Interpreter;
    using W = const Words;
    static constexpr std::array rules{
        Rule{'G', 1, [](I& i, W& w) { i.move(w); }},
        Rule{'G', 0, [](I& i, W& w) { i.move(w); }},
        Rule{'G', 2, [](I& i, W& w) { i.ignore("G2", " (as a straight line)"), i.move(w); }},
        Rule{'G', 3, [](I& i, W& w) { i.ignore("G3", " (as a straight line)"), i.move(w); }},
        Rule{'G', 92, [](I& i, W& w) { i.set_position(w); }},
        Rule{'M', 106, [](I& i, W& w) { i.set_fan(w); }},
        Rule{'M', 107, [](I& i, W&) { i.tell(SetFan{0}); }},
        Rule{'M', 204, [](I& i, W& w) { i.set_accelerations(w); }},
        Rule{'M', 205, [](I& i, W& w) { i.set_limits(w, &SetLimits::jerk); }},
        Rule{'M', 201, [](I& i, W& w) { i.set_limits(w, &SetLimits::max_acceleration); }},
        Rule{'M', 203, [](I& i, W& w) { i.set_limits(w, &SetLimits::max_feedrate); }},
        Rule{'M', 104, [](I& i, W& w) { i.set_heat(w, Heater::hotend, false); }},
        Rule{'M', 109, [](I& i, W& w) { i.set_heat(w, Heater::hotend, true); }},
        Rule{'M', 140, [](I& i, W& w) { i.set_heat(w, Heater::bed, false); }},
        Rule{'M', 190, [](I& i, W& w) { i.set_heat(w, Heater::bed, true); }},
        Rule{'G', 4, [](I& i, W& w) { i.dwell(w); }},
        Rule{'M', 400, [](I& i, W&) { i.tell(Drain{}); }},
        Rule{'G', 28, [](I& i, W& w) { i.home(w); }, true},
        Rule{'G', 20, [](I& i, W&) { i.unit_ = mm_per_inch; }},
        Rule{'G', 21, [](I& i, W&) { i.unit_ = 1; }},
        Rule{'G', 90, [](I& i, W&) { i.set_relative(false); }},
        Rule{'G', 91, [](I& i, W&) { i.set_relative(true); }},
        Rule{'M', 82, [](I& i, W&) { i.relative_[axis_e] = false; }},
        Rule{'M', 83, [](I& i, W&) { i.relative_[axis_e] = true; }},
    };
    const auto row = std::ranges::find_if(rules, [&](const Rule& rule) {
        return rule.letter == line.letter && rule.number == line.number;
    });
    return row == rules.end() ? nullptr : &*row;
}

void Interpreter::read(std::string_view text) {
    if (++report_.lines == 1 && text.starts_with(byte_order_mark))
        text.remove_prefix(byte_order_mark.size());
    const Line line = split_line(text);
    if (line.kind == LineKind::comment) annotations_.note(line.rest);
    if (line.kind == LineKind::junk) note_malformed();
    if (line.kind != LineKind::command) return;
    command_ = line.name;
    if (const Rule* const rule = rule_of(line))
        obey(*rule, Words(line.rest));
    else
        ignore(line.name);
}

GcodeReport Interpreter::finish() {
    if (!moved_)
        throw Error(name_ + ": nothing moves in its " + std::to_string(report_.lines) +
                    " lines (no G0, G1, G2, G3 or G28); is this a G-code file, and complete?");
    report_.slicer = annotations_.slicer();
    return std::move(report_);
}

void Interpreter::obey(const Rule& rule, const Words& words) {
    if (words.too_large() != 0)
        fail(std::string("the number after ") + words.too_large() +
             " is out of range; correct or remove it");
    if (words.has_junk() || (words.has_bare() && !rule.bare)) note_malformed();
    for (const char letter : {'G', 'M'})
        if (words.has(letter))
            ignore(letter + std::to_string(std::int64_t(words.at(letter))),
                   " (second on its line)");
    rule.act(*this, words);
}

double Interpreter::place_told(const Words& words, Axis axis, bool relative) const {
    const double told = words.at(axis_letters[axis]) * unit_;
    const double place = relative ? place_[axis] + told : told;
    if (std::abs(place) > farthest[axis])
        fail(std::string("the move leads beyond ") + std::to_string(farthest[axis] / 1e6) +
             " km in " + axis_letters[axis] + "; correct or remove it");
    return place;
}

void Interpreter::move(const Words& words) {
    if (words.has('F') && words.at('F') > 0) feed_ = words.at('F') * unit_ / 60;
    if (!words.any_of(axis_bits)) return;
    const Position from = place_;
    for (const Axis axis : {axis_x, axis_y, axis_z, axis_e})
        if (words.has(axis_letters[axis])) place_[axis] = place_told(words, axis, relative_[axis]);
    const bool across = place_[axis_x] != from[axis_x] || place_[axis_y] != from[axis_y];
    tell_move(from[axis_z], across && place_[axis_e] > from[axis_e]);
}

void Interpreter::tell_move(double from_z, bool extrudes) {
    const auto layer =
        extrudes ? annotations_.layer_due(from_z, place_[axis_z]) : annotations_.layer_due();
    if (layer) sink_({*layer, report_.lines});
    auto& move = std::get<Move>(move_.what);
    move.to = place_;
    move.feed = feed_;
    move.role = extrudes ? annotations_.role() : Role::travel;
    move.bead = extrudes ? annotations_.bead() : Bead{};
    move_.line = report_.lines;
    sink_(move_);
    moved_ = true;
}

void Interpreter::home(const Words& words) {
    Home home{{words.names('X'), words.names('Y'), words.names('Z')}};
    if (std::ranges::none_of(home.axes, std::identity{})) home = Home{};
    for (const Axis axis : {axis_x, axis_y, axis_z})
        if (home.axes[axis]) place_[axis] = 0;
    tell(home);
    moved_ = true;
}

void Interpreter::set_position(const Words& words) {
    SetPosition position;
    for (const Axis axis : {axis_x, axis_y, axis_z, axis_e}) {
        if (words.has(axis_letters[axis])) position.to[axis] = place_told(words, axis, false);
        if (words.none()) position.to[axis] = 0;
        place_[axis] = position.to[axis].value_or(place_[axis]);
    }
    if (words.none() || words.any_of(axis_bits))
        tell(position);
    else
        ignore(command_);
}

void Interpreter::dwell(const Words& words) {
    const double seconds = words.has('S')   ? words.at('S')
                           : words.has('P') ? words.at('P') / 1000
                                            : 0;
    tell(Dwell{std::max(0.0, seconds)});
}

void Interpreter::set_heat(const Words& words, Heater heater, bool wait) {
    if (const auto celsius = first_of(words, wait ? "SR" : "S"))
        tell(SetHeat{heater, *celsius, wait});
    else
        ignore(command_);
}

// Fan 0 cools the part; others cool the machine.
void Interpreter::set_fan(const Words& words) {
    if (words.has('P') && words.at('P') != 0) return ignore(command_, " (of another fan)");
    const double told = words.has('S') ? words.at('S') : 255;
    tell(SetFan{std::clamp(told / 255, 0.0, 1.0)});
}

void Interpreter::set_limits(const Words& words,
                             PerAxis<std::optional<double>> SetLimits::*limits) {
    SetLimits set;
    bool any = false;
    const bool zero_allowed = limits == &SetLimits::jerk;
    for (const Axis axis : {axis_x, axis_y, axis_z, axis_e}) {
        const char letter = axis_letters[axis];
        if (!words.has(letter)) continue;
        if (words.at(letter) < 0 || (words.at(letter) == 0 && !zero_allowed)) continue;
        (set.*limits)[axis] = words.at(letter);
        any = true;
    }
    if (any)
        tell(set);
    else
        ignore(command_);
}

// S is the older word for printing and travel together; P, R and T say more and so win.
void Interpreter::set_accelerations(const Words& words) {
    const auto told = [&](std::string_view choices) {
        const auto value = first_of(words, choices);
        return value && *value > 0 ? value : std::nullopt;
    };
    SetLimits set;
    set.acceleration = told("PS");
    set.retract_acceleration = told("R");
    set.travel_acceleration = told("TS");
    if (set.acceleration || set.retract_acceleration || set.travel_acceleration)
        tell(set);
    else
        ignore(command_);
}

template <class What>
void Interpreter::tell(const What& what) {
    if (const auto layer = annotations_.layer_due()) sink_({*layer, report_.lines});
    sink_({what, report_.lines});
}

void Interpreter::note_malformed() {
    if (report_.malformed++ == 0) report_.first_malformed = report_.lines;
}

void Interpreter::ignore(std::string_view name, std::string_view how) {
    const std::string key = capitals(name).append(how);
    const bool room = report_.ignored.size() < most_names || report_.ignored.contains(key);
    ++report_.ignored[room ? key : "(others)"];
}

void Interpreter::fail(const std::string& complaint) const {
    throw Error(name_ + ":" + std::to_string(report_.lines) + ": " + complaint);
}

}  // namespace bead
