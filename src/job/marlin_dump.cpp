#include "job/marlin_dump.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>

#include "core/error.h"
#include "gcode/number.h"
#include "job/limit_table.h"
#include "job/one_line.h"

namespace bead {
namespace {

struct DumpRow {
    std::string_view command;
    char letter;
    std::string_view limit;
    std::size_t axis = 0;
};

constexpr std::array dump_rows{
    DumpRow{"M92", 'X', "steps_per_mm", 0},
    DumpRow{"M92", 'Y', "steps_per_mm", 1},
    DumpRow{"M92", 'Z', "steps_per_mm", 2},
    DumpRow{"M92", 'E', "steps_per_mm", 3},
    DumpRow{"M203", 'X', "max_feedrate_mm_s", 0},
    DumpRow{"M203", 'Y', "max_feedrate_mm_s", 1},
    DumpRow{"M203", 'Z', "max_feedrate_mm_s", 2},
    DumpRow{"M203", 'E', "max_feedrate_mm_s", 3},
    DumpRow{"M201", 'X', "max_acceleration_mm_s2", 0},
    DumpRow{"M201", 'Y', "max_acceleration_mm_s2", 1},
    DumpRow{"M201", 'Z', "max_acceleration_mm_s2", 2},
    DumpRow{"M201", 'E', "max_acceleration_mm_s2", 3},
    DumpRow{"M204", 'S', "acceleration_mm_s2"},  // older firmware: printing and travelling
    DumpRow{"M204", 'S', "travel_acceleration_mm_s2"},
    DumpRow{"M204", 'P', "acceleration_mm_s2"},
    DumpRow{"M204", 'R', "retract_acceleration_mm_s2"},
    DumpRow{"M204", 'T', "travel_acceleration_mm_s2"},
    DumpRow{"M205", 'X', "jerk_mm_s", 0},
    DumpRow{"M205", 'Y', "jerk_mm_s", 1},
    DumpRow{"M205", 'Z', "jerk_mm_s", 2},
    DumpRow{"M205", 'E', "jerk_mm_s", 3},
    DumpRow{"M205", 'J', "junction_deviation_mm"},
};

struct DumpLine {
    std::string_view command;  // "M203"
    std::string_view words;    // "X500.00 Y500.00"
    std::string place;         // "dump.txt:5"
};

bool may_precede(char c) { return c == ' ' || c == '\t' || c == ':' || c == ';'; }

// The command on a line such as "Recv: echo:  M203 X500.00 ; fast"; nothing if there is none.
std::optional<DumpLine> command_on(std::string_view line) {
    for (std::size_t at = 0; at + 1 < line.size(); ++at) {
        if ((line[at] != 'M' && line[at] != 'G') || !is_digit(line[at + 1])) continue;
        if (at > 0 && !may_precede(line[at - 1])) continue;
        line.remove_prefix(at);
        line = line.substr(0, line.find(';'));
        std::size_t end = 1;
        while (end < line.size() && is_digit(line[end])) ++end;
        return DumpLine{line.substr(0, end), line.substr(end), ""};
    }
    return std::nullopt;
}

// What follows the letter: nothing if it is not there, an empty text if no number follows.
std::optional<std::string_view> word(std::string_view words, char letter) {
    const auto at = words.find(letter);
    if (at == std::string_view::npos) return std::nullopt;
    return words.substr(at + 1, words.find_first_of(" \t\r", at) - at - 1);
}

std::optional<double> dumped_number(std::string_view text) {
    const Number number = read_number(text.data(), text.data() + text.size(), false);
    if (text.empty() || number.end != text.data() + text.size()) return std::nullopt;
    return number.value;
}

void take(Statement& says, const DumpLine& line) {
    const auto tool = word(line.words, 'T');
    if (line.command != "M204" && line.command != "M205" && tool && *tool != "0") return;
    for (const DumpRow& row : dump_rows) {
        if (row.command != line.command) continue;
        const auto told = word(line.words, row.letter);
        if (!told) continue;
        const auto value = dumped_number(*told);
        if (value && is_allowed(named_limit(row.limit), *value))
            says.limits.push_back(
                {row.limit, row.axis, *value, fmt::format("{} ({})", line.place, line.command)});
        else
            says.warnings.push_back(fmt::format("{}: {} {}{} is no limit above 0; passed over",
                                                line.place, line.command, row.letter,
                                                one_line(*told)));
    }
}

const StatedLimit* find(const Statement& says, std::string_view name, std::size_t axis) {
    const auto found = std::ranges::find_if(says.limits, [&](const StatedLimit& limit) {
        return limit.name == name && limit.axis == axis;
    });
    return found == says.limits.end() ? nullptr : &*found;
}

// Old firmware has one jerk for X and Y.
void share_jerk(Statement& says) {
    const StatedLimit* const x = find(says, "jerk_mm_s", 0);
    if (x == nullptr || find(says, "jerk_mm_s", 1) != nullptr) return;
    StatedLimit y = *x;
    y.axis = 1;
    says.limits.push_back(y);
}

}  // namespace

PrinterFile read_marlin_dump(const DataFile& dump, const Printer& usual) {
    PrinterFile read{usual, {}};
    std::string_view text = dump.text;
    for (int number = 1; !text.empty(); ++number) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        std::optional<DumpLine> line = command_on(trimmed(text.substr(0, end)));
        text.remove_prefix(std::min(end + 1, text.size()));
        if (!line) continue;
        line->place = fmt::format("{}:{}", dump.place, number);
        if (line->command == "G20")
            throw Error(line->place + ": the dump is in inches; send G21, then M503 again");
        take(read.says, *line);
    }
    share_jerk(read.says);
    if (read.says.limits.empty())
        throw Error(dump.place +
                    ": has no M92, M201, M203, M204 or M205 with limits; is it what "
                    "the printer answers to M503?");
    if (const StatedLimit* const deviation = find(read.says, "junction_deviation_mm", 0))
        read.says.firmware = FirmwareChoice{Firmware::marlin_jd, deviation->source};
    read.printer.name = dump.place;
    for (const StatedLimit& limit : read.says.limits)
        named_limit(limit.name).put(read.printer.limits, limit.axis, limit.value);
    read.says.notes.push_back(fmt::format(
        "{}: says limits only; bed, nozzle and power are as of {}", dump.place, usual_printer));
    return read;
}

}  // namespace bead
