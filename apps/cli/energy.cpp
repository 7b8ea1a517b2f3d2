// beadwork energy: what a G-code file draws, by consumer.
#include <memory>

#include "command.h"
#include "energy/interval.h"
#include "energy_table.h"
#include "limits_report.h"

namespace bead::cli {
namespace {

struct Options {
    std::string file;
    MachineOptions machine;
    OutputOptions output;
};

void print_text(const Console& console, const Options& options, const JudgedFile& judged) {
    const EnergyReport& report = judged.cost.energy;
    const Interval interval = interval_95(report.energy, judged.choice.machine.printer.power);
    console.say("{}: {}\n", options.file, described(judged.file));
    console.say("power data of {}; firmware {} (from: {})\n\n", printer_label(options.machine),
                name_of(judged.choice.firmware.firmware), judged.choice.firmware.source);
    console.say("from the wall   {}  (95 % sure: {:.1f} to {:.1f} Wh), {:.0f} g of CO2\n",
                console.strong(fmt::format("{:.1f} Wh", total(report.energy) / 3600)),
                interval.low / 3600, interval.high / 3600, report.co2);
    console.say("heating up      {:.1f} Wh of it, in {}\n", report.heat_up / 3600,
                spoken_time(report.heat_up_duration));
    console.say(
        "printing        {}, {:.0f} W on average, at most {:.0f} W\n\n",
        spoken_time(report.duration),
        report.duration > 0 ? (total(report.energy) - report.heat_up) / report.duration : 0.0,
        report.peak_power);
    print_consumers(console, report.energy);
    console.say(
        "\nX and Y motors alone: {:.2f} kJ by Eq. 28 as published, {:.2f} kJ with standing power "
        "always charged\n",
        published_energy(judged.cost.features) / 1000, standing_form(judged.cost.features) / 1000);
    if (report.energy.bed + report.energy.hotend == 0)
        console.say("The file sets no temperature: heaters are not in these figures.\n");
    print_limits(console, judged);
    if (const std::string ignored = ignored_in(judged.file); !ignored.empty())
        console.say("without effect here: {}\n", ignored);
    for (const std::string& note : judged.choice.notes) console.say("note: {}\n", note);
}

void energy(const Options& options) {
    const Console console = console_of(options.output);
    const JudgedFile judged =
        judge_file(options.file, options.machine, console, Judging::motion_and_energy);
    print_text(console, options, judged);

    Json result = result_head("energy", {options.file});
    result["model"] = "physics";
    result.update(energy_json(judged.cost, judged.choice.machine.printer.power));
    result["time_s"] = judged.cost.motion.duration;
    result["limits"] = limits_json(judged);
    result["firmware"] = name_of(judged.choice.firmware.firmware);
    result["firmware_source"] = judged.choice.firmware.source;
    write_result(options.output.json, result);
}

}  // namespace

void add_energy(CLI::App& app) {
    const auto options = std::make_shared<Options>();
    CLI::App& command =
        *app.add_subcommand("energy", "what printing a G-code file draws, by consumer");
    command.footer(
        "Example: what will this cost me off the battery?\n"
        "  beadwork energy part.gcode --printer prusa-mk3s --json part-energy.json");
    command.add_option("FILE", options->file, "G-code of any slicer, also gzipped")->required();
    declare(command, options->machine);
    declare(command, options->output);
    command.callback([options] { energy(*options); });
}

}  // namespace bead::cli
