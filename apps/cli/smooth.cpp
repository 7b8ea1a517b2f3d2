// beadwork smooth: the same print, shaking the machine less.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>
#include <set>

#include "command.h"
#include "core/error.h"
#include "core/output_file.h"
#include "job/vibration_table.h"
#include "machine_choice.h"
#include "smooth_file.h"
#include "smooth_report.h"
#include "vibration/drive.h"

namespace bead::cli {
namespace {

constexpr double largest_tolerance = 5;  // mm, of infill and travel

struct SmoothCall {
    std::string file, out, setpoints, picture;
    std::vector<double> modes;
    std::optional<double> outer, wall, infill, travel;
    bool arcs = false, tier2 = false, thin = false, all_layers = false;
    std::set<std::string> off;
    std::string law = "K0";
    std::optional<int> layer;
    int threads = 0;
    MachineOptions machine;
    OutputOptions output;
};

// The stages that can be left out, with the option for it.
struct Stage {
    const char* name;
    bool SmoothStages::*on;
    const char* about;
};
constexpr std::array stages{
    Stage{"clean", &SmoothStages::clean, "keep needless points"},
    Stage{"curves", &SmoothStages::curves, "do not find curves again in polygons"},
    Stage{"chains", &SmoothStages::chains, "do not wind nested loops into one stroke"},
    Stage{"order", &SmoothStages::order, "keep order and seams"},
    Stage{"seams", &SmoothStages::seams, "begin walls where the file does"},
    Stage{"blends", &SmoothStages::blends, "keep corners sharp"},
    Stage{"chords", &SmoothStages::chords, "do not choose the lengths of chords"},
};

[[noreturn]] void refuse(const std::string& option, const std::string& complaint) {
    throw Error(option + ": " + complaint, Fault::usage);
}

void check_tolerance(const std::string& option, double value, double most, const char* what) {
    if (!(value > 0))
        refuse(option, fmt::format("{} mm is no tolerance; it must be above 0", value));
    if (value > most)
        refuse(option, fmt::format("{} mm is wider than {} ({} mm); give less", value, what, most));
}

SmoothTolerances tolerances_of(const SmoothCall& options, double bead) {
    SmoothTolerances tolerances;
    const auto take = [](double& value, const std::optional<double>& asked) {
        if (asked) value = *asked;
    };
    take(tolerances.outer_wall, options.outer);
    take(tolerances.wall, options.wall);
    take(tolerances.infill, options.infill);
    take(tolerances.travel, options.travel);
    check_tolerance("--outer-tolerance", tolerances.outer_wall, bead, "a bead");
    check_tolerance("--tolerance", tolerances.wall, bead, "a bead");
    check_tolerance("--infill-tolerance", tolerances.infill, largest_tolerance, "allowed");
    check_tolerance("--travel-tolerance", tolerances.travel, largest_tolerance, "allowed");
    return tolerances;
}

std::array<double, 2> modes_of(const SmoothCall& options, const VibrationModel& model) {
    if (options.modes.empty())
        return {first_mode(model.axes[0]).frequency, first_mode(model.axes[1]).frequency};
    if (options.modes.size() != 2)
        refuse("--modes", "takes two numbers, the first modes of X and Y in Hz, as in 14,22");
    for (const double mode : options.modes)
        if (!(mode > 0) || mode > highest_mode)
            refuse("--modes",
                   fmt::format("{} Hz is no mode; they lie above 0 and up to {} Hz, half "
                               "the rate at which acceleration is looked at",
                               mode, highest_mode));
    return {options.modes[0], options.modes[1]};
}

TimeLaw law_of(const SmoothCall& options, const Limits& limits) {
    const auto row = std::ranges::find(named_laws, options.law, &NamedLaw::name);
    TimeLaw law = row->law;
    law.acceleration = limits.acceleration;
    law.square_corner_velocity = limits.square_corner_velocity;
    return law;
}

ShakenMachine machine_of(const Machine& machine, const SmoothCall& options) {
    ShakenMachine shaken{machine.printer.vibration, machine.material};
    for (std::size_t k = 0; k < 2 && !options.modes.empty(); ++k)
        shaken.model.axes[k] = with_mode(
            shaken.model.axes[k],
            {.frequency = options.modes[k], .damping = first_mode(shaken.model.axes[k]).damping});
    return shaken;
}

void refuse_unsuitable(const SmoothCall& options) {
    namespace fs = std::filesystem;
    std::error_code unknown;
    if (fs::is_directory(options.file))
        throw Error(options.file + ": is a folder; name a G-code file");
    if (fs::exists(options.out, unknown) && fs::equivalent(options.file, options.out, unknown))
        refuse("-o", options.out + " is the input itself; name another file");
}

SmoothFileOptions file_options(const SmoothCall& options, const MachineChoice& choice) {
    const Printer& printer = choice.machine.printer;
    SmoothFileOptions file;
    file.smooth.tolerances = tolerances_of(options, printer.nozzle);
    for (const Stage& stage : stages)
        if (options.off.contains(stage.name)) file.smooth.stages.*stage.on = false;
    file.smooth.stages.bead_plan = options.tier2;
    file.smooth.stages.thinning = options.thin;
    file.smooth.modes = modes_of(options, printer.vibration);
    file.smooth.acceleration = printer.limits.acceleration;
    file.smooth.step = velocity_step(choice.machine.motion.firmware, printer.limits);
    file.read = {.name = options.file, .firmware = choice.firmware.firmware};
    file.filament = printer.filament;
    file.threads = options.threads;
    if (options.arcs) file.arc_tolerance = 0.01;
    file.law = law_of(options, printer.limits);
    file.firmware = {printer.limits, choice.machine.motion};
    return file;
}

void smooth(const SmoothCall& options) {
    const Console console = console_of(options.output);
    refuse_unsuitable(options);
    const MachineChoice choice = machine_choice(options.machine, slicer_notes(options.file));
    for (const std::string& warning : choice.warnings) console.warn(warning);
    const SmoothFileOptions file = file_options(options, choice);
    const OpenedText text = open_text(options.file);
    SmoothReport report({.machine = machine_of(choice.machine, options),
                         .law = file.law,
                         .law_name = options.law,
                         .modes = file.smooth.modes,
                         .bytes = std::int64_t(std::filesystem::file_size(options.file)),
                         .threads = options.threads,
                         .all_layers = options.all_layers,
                         .picture = options.picture,
                         .pictured = options.layer,
                         .setpoints = options.setpoints});
    OutputFile out(options.out);
    const SmoothedFile smoothed =
        smooth_file(text.source, out.stream(), file,
                    [&](const std::vector<LayerPair>& pairs) { report.add(pairs); });
    if (smoothed.layers == 0)
        throw Error(options.file +
                    ": no move in it lays down filament, so there is nothing to smooth; is it the "
                    "sliced file?");
    report.finish(smoothed);
    out.keep();
    report.print(console, options.file);
    if (options.output.json.empty()) return;
    Json json = result_head("smooth", {options.file});
    json.update(report.json());
    write_result(options.output.json, json);
}

void declare_stages(CLI::App& command, SmoothCall& options) {
    for (const Stage& stage : stages)
        command.add_flag_callback(
            std::string("--no-") + stage.name,
            [&options, &stage] { options.off.insert(stage.name); }, stage.about);
    command.add_flag(
        "--tier2,--bead-plan", options.tier2,
        "fewer, wider wall beads of the same volume (a different slicing, not smoothing)");
    command.add_flag("--thin", options.thin,
                     "leave out infill loops, the others wider, where the hollows stay as small");
}

void declare_smooth(CLI::App& command, SmoothCall& options) {
    command.add_option("FILE", options.file, "G-code of any slicer, also gzipped")->required();
    command.add_option("-o,--output", options.out, "where to write")
        ->type_name("OUT.gcode")
        ->required();
    command.add_option("--outer-tolerance", options.outer,
                       "mm that outer walls may leave their corners by (default 0.05)");
    command.add_option("--tolerance", options.wall, "likewise of other walls (default 0.1)");
    command.add_option("--infill-tolerance", options.infill, "likewise of infill (default 1)");
    command.add_option(
        "--travel-tolerance", options.travel,
        "mm that travel may turn off its straight way where it meets a bead at right "
        "angles: the radius of its turns (default 4)");
    command.add_option("--modes", options.modes, "first modes of X and Y, Hz; else the printer's")
        ->delimiter(',')
        ->type_name("14,22");
    declare_stages(command, options);
    std::vector<std::string> laws;
    laws.reserve(named_laws.size());
    for (const NamedLaw& row : named_laws) laws.emplace_back(row.name);
    command
        .add_option("--law", options.law,
                    "time law under which both are judged (default K0, as firmware moves)")
        ->check(CLI::IsMember(laws));
    command.add_flag("--all-layers", options.all_layers,
                     "judge shaking and coverage of every layer, not of a sample");
    command.add_flag("--arcs", options.arcs, "write arcs as G2 and G3");
    command.add_option("--setpoints", options.setpoints, "write where the head is, ms by ms")
        ->type_name("OUT.csv");
    command.add_option("--picture", options.picture, "draw a layer before and after")
        ->type_name("OUT.svg");
    command.add_option("--layer", options.layer,
                       "the layer to draw, from 1 (default: a middle one)");
    command.add_option("--threads", options.threads, "default: all")->check(CLI::NonNegativeNumber);
}

}  // namespace

void add_smooth(CLI::App& app) {
    const auto options = std::make_shared<SmoothCall>();
    CLI::App& command = *app.add_subcommand("smooth", "the same print, shaking the machine less");
    command.footer(
        "Example: any slicer's file for a large machine that rings at 14 and 22 Hz\n"
        "  beadwork smooth part.gcode -o part-smooth.gcode --modes 14,22 --picture layer.svg");
    declare_smooth(command, *options);
    declare(command, options->machine);
    declare(command, options->output);
    command.callback([options] { smooth(*options); });
}

}  // namespace bead::cli
