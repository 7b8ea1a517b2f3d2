#include "gcode_file.h"

#include <algorithm>
#include <exception>
#include <utility>

#include "core/parallel.h"

namespace bead::cli {
namespace {

void warn_about_words(JudgedFile& judged) {
    const GcodeReport& file = judged.file;
    if (file.malformed > 0)
        judged.warnings.push_back(fmt::format(
            "{}:{}: {} line{} with a word that is no number; the word was skipped", judged.name,
            file.first_malformed, file.malformed, file.malformed == 1 ? "" : "s"));
}

// Hears a file's commands on their way to the judge.
class Hearing {
  public:
    Hearing(JudgedFile& judged, Judge& judge) : judged_(judged), judge_(judge) {}

    void hear(const Command& command) {
        if (const SetLimits* const told = std::get_if<SetLimits>(&command.what)) {
            if (std::ranges::any_of(told->jerk, [](const auto& jerk) { return jerk == 0; }))
                note_no_jerk(command.line);
            const Limits before = judge_.limits();
            judge_.add(command);
            judged_.trail.note(*told, command.line, before, judge_.limits());
        } else {
            judge_.add(command);
        }
        judged_.asked.add(command);
    }

  private:
    void note_no_jerk(std::int64_t line) {
        if (std::exchange(warned_, true)) return;
        judged_.warnings.push_back(
            fmt::format("{}:{}: sets a jerk of 0, with which no machine moves; passed over, here "
                        "and wherever it comes again",
                        judged_.name, line));
    }

    JudgedFile& judged_;
    Judge& judge_;
    bool warned_ = false;
};

JudgedFile judged_file(const std::string& file, const MachineOptions& options,
                       const MotionSink& watch, const PowerListener& listener, Judging judging) {
    const SlicerNotes notes = slicer_notes(file);
    JudgedFile judged{file, machine_choice(options, notes)};
    judged.slicer_estimate = notes.estimate;
    judged.warnings = judged.choice.warnings;
    Judge judge(judged.choice.machine, watch, judging);
    if (listener.hear) judge.listen(listener);
    Hearing hearing(judged, judge);
    judged.file =
        read_gcode(std::filesystem::path(file), {.firmware = judged.choice.firmware.firmware},
                   [&](const Command& command) { hearing.hear(command); });
    judged.cost = judge.finish();
    judged.last = judge.limits();
    warn_about_words(judged);
    return judged;
}

void say_warnings(const JudgedFile& judged, const Console& console) {
    for (const std::string& warning : judged.warnings) console.warn(warning);
}

}  // namespace

JudgedFile judge_file(const std::string& file, const MachineOptions& options,
                      const Console& console, Judging judging, const MotionSink& watch,
                      const PowerListener& listener) {
    JudgedFile judged = judged_file(file, options, watch, listener, judging);
    say_warnings(judged, console);
    return judged;
}

std::vector<JudgedFile> judge_files(const std::vector<std::string>& files,
                                    const MachineOptions& options, int threads,
                                    const Console& console, Judging judging) {
    struct Place {
        std::optional<JudgedFile> judged;
        std::exception_ptr error;
    };
    std::vector<Place> places(files.size());
    parallel_for(files.size(), threads, [&](std::size_t i) {
        try {
            places[i].judged = judged_file(files[i], options, {}, {}, judging);
        } catch (...) {
            places[i].error = std::current_exception();
        }
    });
    std::vector<JudgedFile> all;
    for (Place& place : places) {
        if (place.error) std::rethrow_exception(place.error);
        say_warnings(*place.judged, console);
        all.push_back(std::move(*place.judged));
    }
    return all;
}

std::string described(const GcodeReport& file) {
    std::string text = fmt::format("{} lines", file.lines);
    if (!file.slicer.empty()) text += " by " + file.slicer;
    return text;
}

std::string ignored_in(const GcodeReport& file) {
    std::string ignored;
    for (const auto& [word, count] : file.ignored)
        ignored += fmt::format("{}{} × {}", ignored.empty() ? "" : ", ", count, word);
    return ignored;
}

}  // namespace bead::cli
