// beadwork replay: a published experiment made again, side by side with its tables.
#include <array>
#include <memory>

#include "command.h"
#include "core/output_file.h"
#include "job/material_file.h"
#include "job/printer_file.h"
#include "options.h"
#include "replay_pictures.h"

namespace bead::cli {
namespace {

struct ReplayCall {
    std::string experiment;
    bool all = false;
    std::string csv, scatter, angles;
    int threads = 0;
    OutputOptions output;
};

// mm/s; coasting breaks even near 29.
constexpr std::array scanned_speeds{20.0, 29.0, 40.0, 80.0, 180.0};

template <class Write>
void write(const std::string& place, const Write& write_to) {
    if (place.empty()) return;
    OutputFile file(place);
    write_to(file.stream());
    file.keep();
}

void replay(const ReplayCall& options) {
    const Console console = console_of(options.output);
    const Machine machine{load_printer("prusa-mk3s"), load_material("pla"), {}};
    const Replay replay{
        options.all,
        replayed(published_runs(), options.threads, progress_on(console)),
        bracket_rows(options.threads),
        speed_scan(scanned_speeds, machine, options.threads),
    };
    print_replay(console, replay);
    write(options.csv, [&](std::ostream& out) { write_rows(out, replay); });
    write(options.scatter, [&](std::ostream& out) { out << scatter_picture(replay); });
    write(options.angles, [&](std::ostream& out) {
        const std::vector<ModelEnergies> points = angle_scan(machine, options.threads);
        if (options.angles.ends_with(".csv"))
            write_angles(out, points);
        else
            out << angle_picture(points);
    });
    if (options.output.json.empty()) return;
    Json result = result_head("replay", {options.experiment});
    result.update(replay_json(replay));
    write_result(options.output.json, result);
}

}  // namespace

void add_replay(CLI::App& app) {
    const auto options = std::make_shared<ReplayCall>();
    CLI::App& command =
        *app.add_subcommand("replay", "a published experiment made again, side by side");
    command.footer(
        "Example: does the program agree with the thesis that it builds on, and where not?\n"
        "  beadwork replay somade2023 --csv runs.csv --angles angles.svg");
    command.add_option("EXPERIMENT", options->experiment, "somade2023")
        ->required()
        ->check(CLI::IsMember({"somade2023"}));
    command.add_flag("--all", options->all, "count published rows that cannot be right, too");
    command.add_option("--csv", options->csv, "write a row per print")->type_name("OUT.csv");
    command.add_option("--scatter", options->scatter, "draw our energies against the published")
        ->type_name("OUT.svg");
    command
        .add_option("--angles", options->angles,
                    "draw or write energy by the infill's angle, 0° to 90°")
        ->type_name("OUT.svg|OUT.csv");
    command.add_option("--threads", options->threads, "0: as many as there are cores")
        ->check(CLI::Range(0, 1024));
    declare(command, options->output);
    command.callback([options] { replay(*options); });
}

}  // namespace bead::cli
