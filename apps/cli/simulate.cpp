// beadwork simulate: time and motion of anybody's G-code.
#include <fmt/format.h>

#include <memory>

#include "command.h"
#include "core/error.h"
#include "core/output_file.h"
#include "simulate_report.h"

namespace bead::cli {
namespace {

struct SimulateCall {
    std::vector<std::string> files;
    std::string blocks, csv;
    int threads = 0;
    MachineOptions machine;
    OutputOptions output;
};

void write_block(std::ostream& out, const Block& b) {
    fmt::memory_buffer row;
    fmt::format_to(std::back_inserter(row),
                   "{},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g},{:.7g},{:.7g},{:.7g}\n", b.line, b.length,
                   b.v_nominal, b.v_entry, b.v_peak, b.v_exit, b.t_accel, b.t_cruise, b.t_decel);
    out.write(row.data(), static_cast<std::streamsize>(row.size()));
}

JudgedFile judge_with_blocks(const SimulateCall& options, const Console& console) {
    if (options.files.size() > 1)
        throw Error("--blocks: writes the blocks of one file; name one file at a time",
                    Fault::usage);
    OutputFile blocks(options.blocks);
    blocks.stream() << "line,length_mm,v_nominal,v_entry,v_peak,v_exit,t_accel,t_cruise,t_decel\n";
    JudgedFile judged = judge_file(options.files[0], options.machine, console, Judging::motion,
                                   [&](const MotionEvent& event) {
                                       if (const Block* block = std::get_if<Block>(&event))
                                           write_block(blocks.stream(), *block);
                                   });
    blocks.keep();
    return judged;
}

std::vector<JudgedFile> judge(const SimulateCall& options, const Console& console) {
    if (!options.blocks.empty()) return {judge_with_blocks(options, console)};
    return judge_files(options.files, options.machine, options.threads, console, Judging::motion);
}

void write_csv(const std::string& place, const std::vector<JudgedFile>& all) {
    if (place.empty()) return;
    OutputFile file(place);
    const bool with_name = all.size() > 1;
    write_layers_head(file.stream(), with_name);
    for (const JudgedFile& judged : all) write_layers(file.stream(), judged, with_name);
    file.keep();
}

Json json_of(const SimulateCall& options, const std::vector<JudgedFile>& all) {
    Json result = result_head("simulate", options.files);
    if (all.size() == 1) {
        result.update(simulation_json(all[0], options.machine));
        return result;
    }
    result["files"] = Json::array();
    for (const JudgedFile& judged : all) {
        Json one{{"file", judged.name}};
        one.update(simulation_json(judged, options.machine));
        result["files"].push_back(std::move(one));
    }
    return result;
}

void simulate(const SimulateCall& options) {
    const Console console = console_of(options.output);
    const std::vector<JudgedFile> all = judge(options, console);
    for (const JudgedFile& judged : all) {
        if (&judged != &all.front()) console.say("\n\n");
        print_simulation(console, judged, options.machine);
    }
    write_csv(options.csv, all);
    if (!options.output.json.empty()) write_result(options.output.json, json_of(options, all));
}

}  // namespace

void add_simulate(CLI::App& app) {
    const auto options = std::make_shared<SimulateCall>();
    CLI::App& command = *app.add_subcommand("simulate", "time and motion of G-code files");
    command.footer(
        "Example: how long will it take on my Klipper machine, and where does the time go?\n"
        "  beadwork simulate part.gcode --printer printer.cfg --csv layers.csv");
    command.add_option("FILE", options->files, "G-code of any slicer, also gzipped; or several")
        ->required();
    command.add_option("--csv", options->csv, "write a row per layer and feature")
        ->type_name("OUT.csv");
    command.add_option("--blocks", options->blocks, "write every planned block, one row each")
        ->type_name("OUT.csv");
    command.add_option("--threads", options->threads, "0: as many as there are cores")
        ->check(CLI::Range(0, 1024));
    declare(command, options->machine);
    declare(command, options->output);
    command.callback([options] { simulate(*options); });
}

}  // namespace bead::cli
