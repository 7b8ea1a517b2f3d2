#include "time_rewrite.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "gcode/time_edits.h"
#include "gcode/time_text.h"
#include "job/limit_table.h"
#include "motion/line_times.h"

namespace bead::cli {
namespace {

std::vector<std::int64_t> lines_of(const std::vector<TimeMark>& marks) {
    std::vector<std::int64_t> lines;
    lines.reserve(marks.size());
    for (const TimeMark& mark : marks) lines.push_back(mark.line);
    return lines;
}

// Slicers do not show what a successful script says, so the file tells it too. Lines are counted
// as they will be: all that comes or goes is the signature, and that is in the head.
std::vector<std::string> warnings_of(const TimeRewrite& result, const TimeMarks& found) {
    std::vector<std::string> warnings = result.choice.warnings;
    const std::string source = result.choice.limits.source(named_limit("acceleration_mm_s2"));
    if (source.starts_with("default printer"))
        warnings.push_back("the limits are those of the " + source + "; name yours with --printer");
    if (const GcodeReport& file = result.file; file.malformed > 0) {
        const auto old = std::ranges::count(found.marks, TimeWord::signature, &TimeMark::word);
        warnings.push_back(fmt::format("{} line{} with words that are no numbers, first at line {}",
                                       file.malformed, file.malformed == 1 ? "" : "s",
                                       file.first_malformed - old + std::ssize(warnings) + 2));
    }
    return warnings;
}

std::string one_line(std::string text) {
    std::ranges::replace_if(
        text, [](char c) { return c == '\n' || c == '\r'; }, ' ');
    return text;
}

std::vector<std::string> signature_of(const TimeRewrite& result) {
    std::vector<std::string> lines{fmt::format("{}{}: time {} by {} planner", signature_start,
                                               BEAD_VERSION, time_text(result.told),
                                               name_of(result.choice.firmware.firmware))};
    for (const std::string& warning : result.warnings)
        lines.push_back(one_line(std::string(remark_start) + warning));
    return lines;
}

PrintTimes simulate(TimeRewrite& result, const std::string& file, const TimeMarks& found) {
    LineTimes line_times(lines_of(found.marks));
    Judge judge(result.choice.machine, [&](const MotionEvent& event) { line_times.add(event); });
    result.file =
        read_gcode(std::filesystem::path(file), {.firmware = result.choice.firmware.firmware},
                   [&](const Command& command) {
                       line_times.add(command);
                       judge.add(command);
                   });
    return {judge.finish().motion.duration, line_times.finish()};
}

}  // namespace

TimeRewrite time_rewrite(const std::string& file, const MachineOptions& options) {
    const SlicerNotes notes = slicer_notes(file);
    std::ifstream bytes(file, std::ios::binary);
    const TimeMarks found = time_marks(stream_source(bytes));
    TimeRewrite result{machine_choice(options, notes)};
    result.slicer_estimate = notes.estimate;
    const PrintTimes times = simulate(result, file, found);
    result.simulated = times.total;
    result.told = told_total(found, times);
    result.warnings = warnings_of(result, found);
    result.edits = time_edits(found, times, signature_of(result));
    return result;
}

}  // namespace bead::cli
