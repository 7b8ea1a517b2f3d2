// beadwork optimize: the print of a part that costs least.
#include <algorithm>
#include <memory>

#include "command.h"
#include "core/error.h"
#include "optimize_picture.h"
#include "optimize_report.h"
#include "part.h"

namespace bead::cli {
namespace {

struct OptimizeCall {
    std::string out, baseline_out, picture, patterns;
    std::string goal = "machine-energy";
    double angle_step_deg = 15;
    ProcessOptions process;
    MachineOptions machine;
    OutputOptions output;
};

Goal goal_of(const std::string& name) {
    if (name == "time") return Goal::time;
    return name == "xy-energy" ? Goal::xy_energy : Goal::machine_energy;
}

std::vector<NamedPattern> patterns_of(const std::string& list) {
    std::vector<NamedPattern> chosen;
    std::string rest = list + ",";
    for (std::size_t comma = rest.find(','); !rest.empty(); comma = rest.find(',')) {
        const std::string name = rest.substr(0, comma);
        rest.erase(0, comma + 1);
        const auto row = std::ranges::find(patterns, name, &NamedPattern::name);
        if (row == patterns.end())
            throw Error(
                "--patterns: there is no pattern '" + name + "' (beadwork patterns lists them)",
                Fault::usage);
        chosen.push_back(*row);
    }
    return chosen;
}

OptimizeOptions search_options(const OptimizeCall& options, const Settings& settings,
                               const Console& console) {
    OptimizeOptions search;
    search.goal = goal_of(options.goal);
    if (!options.patterns.empty()) search.patterns = patterns_of(options.patterns);
    search.angle_step = options.angle_step_deg * pi / 180;
    search.baseline_rotation = settings.rotate;
    if (options.process.by_option.contains("rotate_deg") || settings.rotate != 0)
        search.rotation = settings.rotate;
    search.threads = options.process.threads;
    search.progress = progress_on(console);
    return search;
}

void optimize_part(const OptimizeCall& options) {
    const Console console = console_of(options.output);
    const Machine machine = machine_of(options.machine);
    const Settings settings = settings_of(options.process, console);
    const OptimizeOptions search = search_options(options, settings, console);
    const std::vector<LayerParts> parts =
        parts_from(options.process, settings, machine.printer, console);
    const Optimum best =
        optimize(parts, settings.plan, program_options(settings, machine), machine, search);

    if (!options.baseline_out.empty())
        write_print(options.baseline_out, best.baseline.print, machine, settings.relative_e,
                    options.process.model + ", as told");
    if (!options.picture.empty()) write_picture(options.picture, best);
    write_print(options.out, best.chosen.print, machine, settings.relative_e,
                options.process.model + ", least " + options.goal);
    print_optimum(console, best, machine, options.process.model, printer_label(options.machine));
    Json result = result_head("optimize", {options.process.model});
    result["output"] = options.out;
    result["minimize"] = options.goal;
    result.update(optimum_json(best, machine));
    write_result(options.output.json, result);
}

}  // namespace

void add_optimize(CLI::App& app) {
    const auto options = std::make_shared<OptimizeCall>();
    CLI::App& command =
        *app.add_subcommand("optimize", "the main job: the print of a part that costs least");
    command.footer(
        "Turns the part, and chooses for each layer the pattern of its infill and the angle of "
        "its\n"
        "lines, so that the whole print costs least; walls, solid layers, density and speeds stay "
        "as\n"
        "told. Prints what that saves beside the same print without the search.\n\n"
        "Example:\n"
        "  beadwork optimize bracket.stl -o bracket.gcode --picture bracket.svg --json "
        "bracket.json");
    declare(command, options->process);
    command.add_option("-o,--output", options->out, "G-code to write")
        ->type_name("OUT.gcode")
        ->required();
    command.add_option("--minimize", options->goal, "what is to be least")
        ->check(CLI::IsMember({"machine-energy", "xy-energy", "time"}))
        ->capture_default_str();
    command
        .add_option(
            "--patterns", options->patterns,
            "to choose from, comma-separated; the first five of beadwork patterns if not given")
        ->type_name("LIST");
    command
        .add_option("--angle-step", options->angle_step_deg,
                    "between angles that are tried, degrees")
        ->check(CLI::Range(1.0, 90.0))
        ->capture_default_str();
    command.add_option("--picture", options->picture, "draw a layer before and after")
        ->type_name("OUT.svg");
    command
        .add_option("--baseline", options->baseline_out, "write the print without the search too")
        ->type_name("OUT.gcode");
    declare(command, options->machine);
    declare(command, options->output);
    command.callback([options] { optimize_part(*options); });
}

}  // namespace bead::cli
