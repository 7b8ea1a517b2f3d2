// A power meter's log laid beside the file that was printed.
#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "energy/course.h"
#include "gcode_file.h"
#include "job/power_log.h"
#include "measured_prints.h"

namespace bead::cli {
namespace {

constexpr double usual_clock = 0.02;  // off by more is worth a warning
constexpr int parts = 10;             // of the print, as groups

struct Logged {
    const PowerTrace& trace;
    const FoundPrint& print;
    const Course& course;

    // The log's time, where the simulation says `seconds` since the start.
    [[nodiscard]] double log_time(double seconds) const {
        return print.from + seconds * print.scale;
    }
};

// The stretches from heating up to the end that nothing is missing from.
struct Stretches {
    std::vector<Observation> whole;
    std::size_t broken = 0;
};

Stretches stretches_of(const Logged& logged, const std::string& name) {
    const double begin = logged.log_time(logged.course.heating()), end = logged.print.to;
    const double shortest = std::max(60.0, 5 * logged.trace.usual_interval);
    const auto count = std::size_t(std::clamp((end - begin) / shortest, 1.0, 200.0));
    Stretches result;
    for (std::size_t i = 0; i < count; ++i) {
        const double from = std::lerp(begin, end, double(i) / double(count));
        const double to = std::lerp(begin, end, double(i + 1) / double(count));
        const Metered drawn = metered(logged.trace, from, to);
        if (!drawn.gaps.empty() || drawn.energy <= 0) {
            ++result.broken;
            continue;
        }
        const auto simulated = [&](double time) {
            return logged.course.at((time - logged.print.from) / logged.print.scale);
        };
        Observation seen{.name = fmt::format("{} at {:.0f} s", name, from - logged.print.from),
                         .group = fmt::format("part {} of {}", i * parts / count + 1, parts),
                         .energy = drawn.energy};
        seen.duration = to - from;
        seen.filament = std::max(0.0, simulated(to).filament - simulated(from).filament);
        result.whole.push_back(std::move(seen));
    }
    return result;
}

void describe(MeasuredPrints& result, const Logged& logged, const Metered& all,
              const Console& console) {
    const FoundPrint& print = logged.print;
    const double length = print.to - print.from, unknown = length - all.recorded;
    const auto note = [&](std::string line) { result.notes.push_back(std::move(line)); };
    note(
        fmt::format("print found from {:.0f} to {:.0f} s of the log, above {:.1f} W (standby "
                    "{:.1f} W); {} in the log, {} simulated",
                    print.from - logged.trace.samples.front().time,
                    print.to - logged.trace.samples.front().time, print.threshold, print.standby,
                    spoken_time(length), spoken_time(logged.course.duration())));
    note(fmt::format("drawn while recorded {:.1f} Wh, {:.1f} % of the print's time",
                     all.energy / 3600, 100 * all.recorded / length));
    if (std::abs(print.scale - 1) > usual_clock)
        console.warn(fmt::format(
            "the print takes {:.4f} times as long in the log as simulated: clock drift, another "
            "file or speed, or heating up that takes other than simulated; times were stretched",
            print.scale));
    if (!all.gaps.empty())
        console.warn(fmt::format(
            "{} gap{} in the log, {} in all: what was drawn in {:.1f} % of the print is unknown "
            "and not estimated",
            all.gaps.size(), all.gaps.size() == 1 ? "" : "s", spoken_time(unknown),
            100 * unknown / length));
    if (print.others > 0)
        console.warn(
            fmt::format("{} other stretch{} of the log look like prints; the one nearest "
                        "in length to the file was taken",
                        print.others, print.others == 1 ? "" : "es"));
    if (print.cut_begin || print.cut_end)
        console.warn(fmt::format("the log {} above standby, so the print's {} is a guess",
                                 print.cut_begin ? "begins" : "ends",
                                 print.cut_begin ? "start" : "end"));
}

Json gaps_json(const Metered& all, double zero) {
    Json gaps = Json::array();
    for (const Gap& gap : all.gaps)
        gaps.push_back({{"from_s", gap.from - zero}, {"to_s", gap.to - zero}});
    return gaps;
}

}  // namespace

MeasuredPrints logged_print(const MeasuredOptions& options, const Console& console) {
    const PowerLog log = read_power_log(options.power_log);
    const Machine machine = machine_of(options.machine);
    Course course(machine.printer, machine.material);
    const Assessment cost =
        judge_file(options.gcode, options.machine, console, Judging::motion_and_energy,
                   [&](const MotionEvent& event) { course.add(event); })
            .cost;
    const FoundPrint print = [&] {
        try {
            return find_print(log.trace, course.duration());
        } catch (const Error& error) {
            throw Error(options.power_log + ": " + error.what(), error.fault());
        }
    }();
    const Logged logged{log.trace, print, course};
    const Metered all = metered(log.trace, print.from, print.to);
    Stretches stretches = stretches_of(logged, options.power_log);

    MeasuredPrints result;
    result.of_machine = result.parts_of_one = true;
    result.kind = fmt::format("a power log of {} samples, one every {:.3g} s",
                              log.trace.samples.size(), log.trace.usual_interval);
    result.inputs = {options.power_log, options.gcode};
    describe(result, logged, all, console);
    if (log.missing > 0)
        console.warn(fmt::format("{}: {} row{} without power left out", options.power_log,
                                 log.missing, log.missing == 1 ? "" : "s"));
    if (stretches.whole.empty())
        throw Error(options.power_log +
                        ": no stretch of the print after heating up is recorded "
                        "without a gap; log every few seconds",
                    Fault::not_converged);
    result.prints = std::move(stretches.whole);

    const double heated = logged.log_time(course.heating());
    const Metered heating = metered(log.trace, print.from, heated);
    const double zero = log.trace.samples.front().time;
    result.notes.push_back(fmt::format("heating up (first {}): {:.1f} Wh",
                                       spoken_time(heated - print.from), heating.energy / 3600));
    result.details = {{"from_s", print.from - zero},
                      {"to_s", print.to - zero},
                      {"standby_w", print.standby},
                      {"threshold_w", print.threshold},
                      {"simulated_s", course.duration()},
                      {"clock_scale", print.scale},
                      {"recorded_energy_j", all.energy},
                      {"recorded_percent", 100 * all.recorded / (print.to - print.from)},
                      {"unknown_percent", 100 - 100 * all.recorded / (print.to - print.from)},
                      {"gaps", gaps_json(all, zero)},
                      {"rows_without_power", log.missing},
                      {"heat_up_s", heated - print.from},
                      {"heat_up_j", heating.energy},
                      {"modelled_j", total(cost.energy.energy)},
                      {"stretches", result.prints.size()},
                      {"stretches_with_gaps", stretches.broken}};
    return result;
}

}  // namespace bead::cli
