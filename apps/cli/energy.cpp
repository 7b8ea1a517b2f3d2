// beadwork energy: what a G-code file draws, by consumer, feature and layer, and over time.
#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <memory>

#include "command.h"
#include "core/error.h"
#include "energy_over_time.h"
#include "energy_report.h"
#include "job/tariff_text.h"

namespace bead::cli {
namespace {

struct EnergyCall {
    std::string file, mode = "physics";
    bool explain = false;
    std::string csv, step, picture, grid_co2, tariff, start;
    MachineOptions machine;
    OutputOptions output;
};

double number_of(const std::string& option, const std::string& text, double least,
                 const std::string& what) {
    double value = 0;
    const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (fault != std::errc() || end != text.data() + text.size() || !std::isfinite(value) ||
        value < least)
        throw Error(fmt::format("{}: {} is no {}", option, text, what), Fault::usage);
    return value;
}

void expect_together(const std::string& option, bool given, bool has, const std::string& needed) {
    if (given && !has)
        throw Error(fmt::format("{}: has a meaning only with {}; add it or leave {} out", option,
                                needed, option),
                    Fault::usage);
}

OverTimeOptions over_time(const EnergyCall& options) {
    expect_together("--step", !options.step.empty(),
                    !options.csv.empty() || !options.picture.empty(), "--csv or --picture");
    expect_together("--start", !options.start.empty(), !options.tariff.empty(), "--tariff");
    OverTimeOptions over;
    const auto mode = std::ranges::find(energy_mode_names, options.mode);
    over.mode = static_cast<EnergyMode>(mode - energy_mode_names.begin());
    over.csv = options.csv;
    over.picture = options.picture;
    if (!options.step.empty())
        over.step = number_of("--step", options.step, 0.001, "number of seconds, 0.001 or more");
    if (!options.tariff.empty()) over.tariff = tariff_of(options.tariff);
    if (!options.start.empty()) over.start = time_of_day(options.start);
    if (over.tariff && over.tariff->size() > 1 && options.start.empty())
        throw Error(
            "--tariff: prices depend on the time of day; say when the print begins with "
            "--start 22:15",
            Fault::usage);
    return over;
}

std::vector<ExplainedTerm> terms_of(EnergyMode mode, const JudgedFile& judged) {
    const Machine& machine = judged.choice.machine;
    if (mode == EnergyMode::published) return explained_published(judged.cost.features);
    if (mode == EnergyMode::corrected) return explained_standing(judged.cost.features);
    return explained(judged.cost.energy.terms, machine.printer, machine.material);
}

EnergyResult judged_energy(const EnergyCall& options, const Console& console) {
    const OverTimeOptions asked = over_time(options);
    EnergyResult result;
    result.mode = asked.mode;
    result.tariff = asked.tariff;
    result.start = asked.start;
    if (!options.grid_co2.empty())
        result.grid_co2 =
            number_of("--grid-co2", options.grid_co2, 0, "number of g per kWh, 0 or more");
    EnergyOverTime over(asked);
    const bool motion_only = asked.mode != EnergyMode::physics;
    const auto watch = [&](const MotionEvent& event) {
        result.features.add(event);
        if (over.is_asked_for()) over.add_motion(event);
    };
    result.judged = judge_file(options.file, options.machine, console,
                               motion_only ? Judging::motion : Judging::motion_and_energy,
                               motion_only ? MotionSink(watch) : MotionSink(), over.listener());
    over.finish(std::filesystem::path(options.file).filename().string());
    result.bill = over.bill();
    if (options.grid_co2.empty())
        result.grid_co2 = result.judged.choice.machine.printer.power.grid_co2;
    if (options.explain) result.terms = terms_of(asked.mode, result.judged);
    return result;
}

void energy(const EnergyCall& options) {
    const Console console = console_of(options.output);
    const EnergyResult result = judged_energy(options, console);
    print_energy(console, result, options.machine);
    if (options.output.json.empty()) return;

    Json json = result_head("energy", {options.file});
    json.update(energy_result_json(result));
    json["time_s"] = result.judged.cost.motion.duration;
    if (options.explain) json["terms"] = terms_json(result, options.machine);
    json["limits"] = limits_json(result.judged);
    json["firmware"] = name_of(result.judged.choice.firmware.firmware);
    json["firmware_source"] = result.judged.choice.firmware.source;
    write_result(options.output.json, json);
}

void declare_energy(CLI::App& command, EnergyCall& options) {
    command.add_option("FILE", options.file, "G-code of any slicer, also gzipped")->required();
    command
        .add_option("--mode", options.mode,
                    "physics: the whole machine (default); published, corrected: X and Y motors by "
                    "Somade (2023)")
        ->check(CLI::IsMember({"published", "corrected", "physics"}));
    command.add_flag("--explain", options.explain,
                     "every term with its formula, its parameters and where they are from");
    command.add_option("--csv", options.csv, "write the power curve")->type_name("OUT.csv");
    command.add_option("--picture", options.picture, "draw the power curve")->type_name("OUT.svg");
    command.add_option("--step", options.step, "of the power curve, s (default 1)")
        ->type_name("SECONDS");
    command.add_option("--grid-co2", options.grid_co2, "g per kWh; else the printer file's")
        ->type_name("GRAMS");
    command
        .add_option("--tariff", options.tariff,
                    "price per kWh: 0.30, 00:00-06:00=0.12,06:00-24:00=0.30 or a file")
        ->type_name("PRICE|FILE.toml");
    command.add_option("--start", options.start, "time of day when the print begins, 22:15")
        ->type_name("HH:MM");
}

}  // namespace

void add_energy(CLI::App& app) {
    const auto options = std::make_shared<EnergyCall>();
    CLI::App& command =
        *app.add_subcommand("energy", "what printing a G-code file draws, by consumer");
    command.footer(
        "Example: what will this cost me off the battery, and what at night?\n"
        "  beadwork energy part.gcode --printer prusa-mk3s --json part-energy.json\n"
        "  beadwork energy part.gcode --tariff 22:00-06:00=0.12,06:00-22:00=0.30 --start 21:30");
    declare_energy(command, *options);
    declare(command, options->machine);
    declare(command, options->output);
    command.callback([options] { energy(*options); });
}

}  // namespace bead::cli
