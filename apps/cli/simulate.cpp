// beadwork simulate: time and motion of anybody's G-code.
#include <fmt/format.h>

#include <memory>

#include "command.h"
#include "core/output_file.h"
#include "gcode_file.h"
#include "json_result.h"

namespace bead::cli {
namespace {

struct Options {
    std::string file, blocks;
    MachineOptions machine;
    OutputOptions output;
};

void print_axes(const Console& console, const MotionTotals& motion) {
    console.say("\n{:>6} {:>12} {:>11} {:>11} {:>11} {:>12}\n", "axis", "speeding up", "coasting",
                "slowing", "standing", "way");
    constexpr std::array names{"X", "Y", "Z", "E"};
    for (std::size_t i = 0; i < names.size(); ++i) {
        const AxisTimes& axis = motion.axes[i];
        console.say("{:>6} {:>10.1f} s {:>9.1f} s {:>9.1f} s {:>9.1f} s {:>9.0f} mm\n", names[i],
                    axis.accelerate, axis.coast, axis.decelerate, axis.hold, axis.distance);
    }
}

void print_roles(const Console& console, const MotionTotals& motion) {
    console.say("\n");
    for (std::size_t i = 0; i < role_names.size(); ++i)
        if (motion.by_role[i] > 0)
            console.say("{:>14} {:>10.1f} s {:>5.1f} %\n", role_names[i], motion.by_role[i],
                        100 * motion.by_role[i] / motion.duration);
}

void print_text(const Console& console, const Options& options, const JudgedFile& judged) {
    const MotionTotals& m = judged.cost.motion;
    console.say("{}: {}\n", options.file, described(judged.file));
    console.say("limits from {}; firmware {} ({}), look-ahead {}\n\n", judged.limits_source,
                options.machine.firmware, options.machine.quirks, options.machine.lookahead);
    console.say("printing time   {}  ({:.1f} s)\n", console.strong(spoken_time(m.duration)),
                m.duration);
    if (judged.slicer_estimate)
        console.say("slicer's own    {}  (ours is {:+.1f} %)\n",
                    spoken_time(*judged.slicer_estimate),
                    100 * (m.duration / *judged.slicer_estimate - 1));
    console.say("way of the head {:.1f} m, of it {:.1f} m travel in {} moves; {} retractions\n",
                m.length / 1000, m.travel / 1000, m.travel_moves, m.retractions);
    console.say("filament        {:.2f} m\n", m.extruded / 1000);
    console.say(
        "moves           {}, of which {:.0f} % never reach their speed; fastest {:.0f} mm/s\n",
        m.moves,
        m.moves > 0 ? 100.0 * static_cast<double>(m.short_of_speed) / static_cast<double>(m.moves)
                    : 0.0,
        m.fastest);
    print_axes(console, m);
    print_roles(console, m);
}

void write_block(std::ostream& out, const Block& b) {
    fmt::memory_buffer row;
    fmt::format_to(std::back_inserter(row),
                   "{},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g},{:.7g},{:.7g},{:.7g}\n", b.line, b.length,
                   b.v_nominal, b.v_entry, b.v_peak, b.v_exit, b.t_accel, b.t_cruise, b.t_decel);
    out.write(row.data(), static_cast<std::streamsize>(row.size()));
}

JudgedFile judge(const Options& options, const Console& console) {
    if (options.blocks.empty()) return judge_file(options.file, options.machine, console);
    OutputFile blocks(options.blocks);
    blocks.stream() << "line,length_mm,v_nominal,v_entry,v_peak,v_exit,t_accel,t_cruise,t_decel\n";
    JudgedFile judged =
        judge_file(options.file, options.machine, console, [&](const MotionEvent& event) {
            if (const Block* block = std::get_if<Block>(&event))
                write_block(blocks.stream(), *block);
        });
    blocks.keep();
    return judged;
}

void simulate(const Options& options) {
    const Console console = console_of(options.output);
    const JudgedFile judged = judge(options, console);
    print_text(console, options, judged);

    Json result = result_head("simulate", {options.file});
    result.update(motion_json(judged.cost));
    result["lines"] = judged.file.lines;
    if (judged.slicer_estimate) result["slicer_estimate_s"] = *judged.slicer_estimate;
    result["limits"] = limits_json(judged.machine.printer.limits, judged.limits_source);
    result["firmware"] = options.machine.firmware;
    result["quirks"] = options.machine.quirks;
    result["lookahead"] = options.machine.lookahead;
    result["ignored"] = judged.file.ignored;
    write_result(options.output.json, result);
}

}  // namespace

void add_simulate(CLI::App& app) {
    const auto options = std::make_shared<Options>();
    CLI::App& command = *app.add_subcommand("simulate", "time and motion of a G-code file");
    command.footer(
        "Example: how long will it take, and which blocks does the planner make of it?\n"
        "  beadwork simulate part.gcode --printer ender3 --blocks blocks.csv");
    command.add_option("FILE", options->file, "G-code of any slicer, also gzipped")->required();
    command.add_option("--blocks", options->blocks, "write every planned block, one row each")
        ->type_name("OUT.csv");
    declare(command, options->machine);
    declare(command, options->output);
    command.callback([options] { simulate(*options); });
}

}  // namespace bead::cli
