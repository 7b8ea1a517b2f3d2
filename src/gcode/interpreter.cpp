#include "gcode/interpreter.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "core/error.h"
#include "gcode/key_words.h"

namespace bead {
namespace {

constexpr double mm_per_inch = 25.4;
constexpr double seconds_per_minute = 60;
constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
constexpr std::size_t most_names = 200;  // of ignored commands; the rest is counted together
constexpr std::size_t longest_name = 40;
constexpr int any_number = -2;

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

// What a command does and where it is obeyed. `bare`: its letters need no numbers.
struct Interpreter::Rule {
    char letter;
    int number;
    void (*act)(Interpreter&, const Words&);
    unsigned obeyed = every_dialect;
    bool bare = false;
};

const Interpreter::Rule* Interpreter::rule_of(const Line& line) {
    using I = Interpreter;
    using W = const Words;
    constexpr unsigned not_klipper = every_dialect & ~unsigned{klipper_dialect};
    constexpr unsigned with_planes = marlin_dialect | klipper_dialect | reprap_dialect;
    static constexpr std::array rules{
        Rule{'G', 1, [](I& i, W& w) { i.move(move_words(w)); }},
        Rule{'G', 0, [](I& i, W& w) { i.move(move_words(w)); }},
        Rule{'G', 2, [](I& i, W& w) { i.arc(w, true); }},
        Rule{'G', 3, [](I& i, W& w) { i.arc(w, false); }},
        Rule{'G', 92, [](I& i, W& w) { i.set_position(w); }},
        Rule{'G', 10, [](I& i, W& w) { i.retract(w); }},
        Rule{'G', 11, [](I& i, W&) { i.recover(); }},
        Rule{'M', 106, [](I& i, W& w) { i.set_fan(w); }},
        Rule{'M', 107, [](I& i, W&) { i.tell(SetFan{0}); }},
        Rule{'M', 73, [](I&, W&) {}},  // the printer's display, in every other line of some files
        Rule{'M', 204, [](I& i, W& w) { i.tell_limits(accelerations(w, i.dialect_)); }},
        Rule{'M', 205, [](I& i, W& w) { i.tell_limits(corner_limits(w, i.dialect_)); },
             not_klipper},
        Rule{'M', 201, [](I& i, W& w) { i.set_max_accelerations(w); }, not_klipper},
        Rule{'M', 203, [](I& i, W& w) { i.set_feedrates(w); }, not_klipper},
        Rule{'M', 566, [](I& i, W& w) { i.set_jerk(w); }, not_klipper},
        Rule{'M', 104, [](I& i, W& w) { i.set_heat(w, Heater::hotend, false); }},
        Rule{'M', 109, [](I& i, W& w) { i.set_heat(w, Heater::hotend, true); }},
        Rule{'M', 140, [](I& i, W& w) { i.set_heat(w, Heater::bed, false); }},
        Rule{'M', 190, [](I& i, W& w) { i.set_heat(w, Heater::bed, true); }},
        Rule{'G', 4, [](I& i, W& w) { i.dwell(w); }},
        Rule{'G', 5, [](I& i, W& w) { i.curve(w); }, marlin_dialect},
        Rule{'G', 17, [](I& i, W&) { i.plane_ = Plane::xy; }},
        Rule{'G', 18, [](I& i, W&) { i.plane_ = Plane::zx; }, with_planes},
        Rule{'G', 19, [](I& i, W&) { i.plane_ = Plane::yz; }, with_planes},
        Rule{'M', 400, [](I& i, W&) { i.tell(Drain{}); }},
        Rule{'G', 28, [](I& i, W& w) { i.home(w); }, every_dialect, true},
        Rule{'G', 20, [](I& i, W&) { i.unit_ = mm_per_inch; }, not_klipper},
        Rule{'G', 21, [](I& i, W&) { i.unit_ = 1; }},
        Rule{'G', 90, [](I& i, W&) { i.set_relative(false); }},
        Rule{'G', 91, [](I& i, W&) { i.set_relative(true); }},
        Rule{'M', 82, [](I& i, W&) { i.set_extruder_relative(false); }},
        Rule{'M', 83, [](I& i, W&) { i.set_extruder_relative(true); }},
        Rule{'M', 207, [](I& i, W& w) { i.retraction_ = with_m207(i.retraction_, w, i.dialect_); },
             not_klipper},
        Rule{'M', 208, [](I& i, W& w) { i.retraction_ = with_m208(i.retraction_, w); },
             not_klipper},
        Rule{'T', any_number, [](I& i, W&) { i.ignore(i.command_, " (tool change)"); }},
        Rule{'M', 0, [](I& i, W&) { i.pause(); }},
        Rule{'M', 1, [](I& i, W&) { i.pause(); }},
        Rule{'M', 226, [](I& i, W&) { i.pause(); }},
        Rule{'M', 600, [](I& i, W&) { i.pause(); }},
        Rule{'M', 601, [](I& i, W&) { i.pause(); }},
    };
    const auto row = std::ranges::find_if(rules, [&](const Rule& rule) {
        return rule.letter == line.letter &&
               (rule.number == line.number || rule.number == any_number);
    });
    return row == rules.end() ? nullptr : &*row;
}

void Interpreter::read_lines(std::string_view text) {
    const char* at = text.data();
    const char* const end = at + text.size();
    while (at != end) {
        if (const PlainMove plain = read_plain_move(at); plain.end != nullptr) {
            ++report_.lines;
            move(plain.words);
            at = plain.end;
        } else {
            const auto* const stop =
                static_cast<const char*>(std::memchr(at, '\n', std::size_t(end - at)));
            read({at, std::size_t(stop - at)});
            at = stop + 1;
        }
    }
}

void Interpreter::read(std::string_view text) {
    if (text.ends_with('\r')) text.remove_suffix(1);
    if (++report_.lines == 1 && text.starts_with(byte_order_mark))
        text.remove_prefix(byte_order_mark.size());
    line_ = text;
    const Line line = split_line(text);
    command_ = line.name;
    if (line.kind == LineKind::comment) {
        annotations_.note(line.rest);
        if (annotations_.for_reprap() && !moved_) become_reprap();
    }
    if (line.kind == LineKind::junk) note_malformed();
    if (line.kind != LineKind::command) return;
    const Rule* const rule = rule_of(line);
    if (line.letter == 0)
        run_macro(line);
    else if (rule == nullptr)
        ignore(line.name);
    else
        obey(*rule, Words(line.rest));
}

GcodeReport Interpreter::finish() {
    if (!moved_)
        throw Error(name_ + ": nothing moves in its " + std::to_string(report_.lines) +
                    " lines (no G0, G1, G2, G3 or G28); is this a G-code file, and complete?");
    report_.slicer = annotations_.slicer();
    report_.dialect = name_of(dialect_);
    return std::move(report_);
}

void Interpreter::obey(const Rule& rule, const Words& words) {
    if (!in(rule.obeyed))
        return ignore(command_, std::string(" (not obeyed by ").append(name_of(dialect_)) + ")");
    if (words.too_large() != 0)
        fail(std::string("the number after ") + words.too_large() +
             " is out of range; correct or remove it");
    if (words.has_junk() || (words.has_bare() && !rule.bare) || !words.fit_checksum(line_))
        note_malformed();
    for (const char letter : {'G', 'M'})
        if (words.has(letter))
            ignore(letter + std::to_string(std::int64_t(words.at(letter))),
                   " (second on its line)");
    rule.act(*this, words);
}

void Interpreter::run_macro(const Line& line) {
    struct MacroRule {
        std::string_view name;
        void (*act)(Interpreter&, std::string_view words);
    };
    using I = Interpreter;
    using W = std::string_view;
    static constexpr std::array rules{
        MacroRule{"SET_VELOCITY_LIMIT",
                  [](I& i, W w) { i.tell_limits(velocity_limits(w, i.head_acceleration_)); }},
        MacroRule{"SET_RETRACTION", [](I& i, W w) { i.set_klipper_retraction(w); }},
        MacroRule{"SAVE_GCODE_STATE", [](I& i, W w) { i.save_state(w); }},
        MacroRule{"RESTORE_GCODE_STATE", [](I& i, W w) { i.restore_state(w); }},
    };
    const auto row = std::ranges::find(rules, capitals(line.name), &MacroRule::name);
    if (row == rules.end()) return ignore(line.name, " (macro)");
    if (!in(klipper_dialect))
        return ignore(line.name, std::string(" (not obeyed by ").append(name_of(dialect_)) + ")");
    row->act(*this, line.rest);
}

// The text turns out to be for RepRapFirmware, unless it is read as Klipper reads it: what was
// taken for mm/s was mm/min.
void Interpreter::become_reprap() {
    if (in(klipper_dialect | reprap_dialect)) return;
    dialect_ = reprap_dialect;
    update_modes();
    if (feedrates_told_ == AxisLimits{}) return;
    SetLimits corrected;
    for (std::size_t axis = 0; axis < feedrates_told_.size(); ++axis)
        if (feedrates_told_[axis])
            corrected.max_feedrate[axis] = *feedrates_told_[axis] / seconds_per_minute;
    tell(corrected);
}

void Interpreter::set_relative(bool on) {
    g91_ = on;
    if (extruder_mode(dialect_) == ExtruderMode::last_said) m83_ = on;
    update_modes();
}

void Interpreter::set_extruder_relative(bool on) {
    m83_ = on;
    update_modes();
}

void Interpreter::update_modes() {
    const bool extruder = m83_ || (g91_ && extruder_mode(dialect_) == ExtruderMode::either);
    relative_ = {g91_, g91_, g91_, extruder};
}

// How long it lasts is up to somebody; the machine comes to a stop first.
void Interpreter::pause() {
    ignore(command_, " (pause)");
    tell(Drain{});
}

void Interpreter::dwell(const Words& words) {
    const bool in_s = words.has('S') && !in(klipper_dialect);
    const double seconds = in_s ? words.at('S') : words.has('P') ? words.at('P') / 1000 : 0;
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

void Interpreter::set_max_accelerations(const Words& words) {
    const auto told = axis_limits(words, false, 1);
    if (!told) return ignore(command_);
    SetLimits set;
    set.max_acceleration = *told;
    tell(set);
}

void Interpreter::set_feedrates(const Words& words) {
    const auto told = axis_limits(words, false, in(reprap_dialect) ? seconds_per_minute : 1);
    if (!told) return ignore(command_);
    for (std::size_t axis = 0; axis < told->size(); ++axis)
        if ((*told)[axis]) feedrates_told_[axis] = (*told)[axis];
    SetLimits set;
    set.max_feedrate = *told;
    tell(set);
}

// M566, which only RepRapFirmware has: in mm/min.
void Interpreter::set_jerk(const Words& words) {
    become_reprap();
    const auto told = axis_limits(words, true, seconds_per_minute);
    if (!told) return ignore(command_);
    SetLimits set;
    set.jerk = *told;
    tell(set);
}

void Interpreter::set_klipper_retraction(std::string_view words) {
    retraction_ = with_klipper_words(retraction_, words);
    retracted_ = false;
}

void Interpreter::tell_limits(const std::optional<SetLimits>& limits) {
    if (!limits) return ignore(command_);
    if (limits->max_acceleration_head) head_acceleration_ = limits->max_acceleration_head;
    tell(*limits);
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
