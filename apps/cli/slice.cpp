// beadwork slice: a part to G-code, as told, without search.
#include <ctime>
#include <memory>

#include "command.h"
#include "core/error.h"
#include "json_result.h"
#include "part.h"

namespace bead::cli {
namespace {

struct SliceCall {
    std::string out;
    ProcessOptions process;
    MachineOptions machine;
    OutputOptions output;
};

Json volume_json(const Volumes& v) {
    return {{"wall", v.wall},       {"skin", v.skin},   {"infill", v.infill},
            {"support", v.support}, {"skirt", v.skirt}, {"other", v.other}};
}

void slice_part(const SliceCall& options) {
    const Console console = console_of(options.output);
    const Machine machine = machine_of(options.machine);
    const Settings settings = settings_of(options.process, console);
    const std::vector<LayerParts> parts =
        parts_from(options.process, settings, machine.printer, console);
    Print print{on_bed(parts, settings.rotate, machine.printer),
                uniform_choices(parts.size(), settings.plan),
                {},
                settings.plan,
                program_options(settings, machine)};
    print.lines = matched_spacing(print.parts, print.choices, print.plan);
    if (!fits_bed(print.parts, machine.printer))
        throw Error(options.process.model + ": does not fit the bed of " + machine.printer.name +
                        "; turn it (--rotate) or choose another printer",
                    Fault::infeasible);
    Volumes deposited;
    const Assessment cost =
        write_print(options.out, print, machine, settings.relative_e, options.process.model,
                    [&](std::size_t, const Toolpath& layer) {
                        deposited = deposited + deposited_volumes(layer);
                    });
    const Volumes asked = asked_volumes(parts, settings.plan);
    const double cpu = static_cast<double>(std::clock()) / CLOCKS_PER_SEC;

    console.say("{}: {} layers, {}, {:.2f} m of filament ({:.1f} g), {:.1f} Wh from the wall\n",
                options.out, parts.size(), spoken_time(cost.motion.duration),
                cost.motion.extruded / 1000, grams(cost.motion.extruded, machine),
                total(cost.energy.energy) / 3600);
    Json result = result_head("slice", {options.process.model});
    result["output"] = options.out;
    result["layers"] = parts.size();
    result["time_s"] = cost.motion.duration;
    result["filament_mm"] = cost.motion.extruded;
    result["filament_g"] = grams(cost.motion.extruded, machine);
    result["machine_energy_j"] = total(cost.energy.energy);
    result["volume_mm3"] = volume_json(deposited);
    result["asked_volume_mm3"] = volume_json(asked);
    result["cpu_s"] = cpu;
    write_result(options.output.json, result);
}

}  // namespace

void add_slice(CLI::App& app) {
    const auto options = std::make_shared<SliceCall>();
    CLI::App& command = *app.add_subcommand("slice", "a part to G-code, as told, without search");
    command.footer(
        "Example: 0.1 mm layers, 15 % infill in concentric rings, part turned by 30 degrees\n"
        "  beadwork slice bracket.stl -o bracket.gcode --layer-height 0.1 --density 15% --pattern "
        "concentric --rotate 30");
    declare(command, options->process);
    command.add_option("-o,--output", options->out, "G-code to write")
        ->type_name("OUT.gcode")
        ->required();
    declare(command, options->machine);
    declare(command, options->output);
    command.callback([options] { slice_part(*options); });
}

}  // namespace bead::cli
