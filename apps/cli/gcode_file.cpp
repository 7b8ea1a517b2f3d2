#include "gcode_file.h"

#include "gcode/slicer_limits.h"
#include "motion/limit_changes.h"

namespace bead::cli {
namespace {

void warn_about(const GcodeReport& file, const std::string& name, const Console& console) {
    if (file.malformed > 0)
        console.warn(fmt::format(
            "{}:{}: {} line{} with a word that is no number; the word was skipped", name,
            file.first_malformed, file.malformed, file.malformed == 1 ? "" : "s"));
}

}  // namespace

JudgedFile judge_file(const std::string& file, const MachineOptions& options,
                      const Console& console, const MotionSink& watch) {
    JudgedFile judged{machine_of(options), printer_label(options)};
    judged.slicer_estimate = slicer_estimate(file);
    if (const auto noted = slicer_limits(file); noted && options.printer.empty()) {
        Limits& limits = judged.machine.printer.limits;
        limits = changed(limits, *noted);
        judged.limits_source = "the slicer's notes in " + file;
    }
    Judge judge(judged.machine, watch);
    bool sets_limits = false;
    judged.file = read_gcode(std::filesystem::path(file), {.firmware = firmware_of(options)},
                             [&](const Command& command) {
                                 sets_limits =
                                     sets_limits || std::holds_alternative<SetLimits>(command.what);
                                 judge.add(command);
                             });
    judged.cost = judge.finish();
    if (sets_limits) judged.limits_source += ", changed by M201-M205 in the file";
    warn_about(judged.file, file, console);
    return judged;
}

std::string described(const GcodeReport& file) {
    std::string text = fmt::format("{} lines", file.lines);
    if (!file.slicer.empty()) text += " by " + file.slicer;
    std::string ignored;
    for (const auto& [word, count] : file.ignored)
        ignored += fmt::format("{}{} × {}", ignored.empty() ? "" : ", ", count, word);
    if (!ignored.empty()) text += "; without effect here: " + ignored;
    return text;
}

}  // namespace bead::cli
