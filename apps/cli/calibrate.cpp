// beadwork calibrate: the energy model's coefficients from measured prints.
#include <memory>

#include "calibration_report.h"
#include "command.h"
#include "core/error.h"
#include "core/output_file.h"
#include "job/calibrated_file.h"
#include "numeric/outlying.h"

namespace bead::cli {
namespace {

struct CalibrateCall {
    MeasuredOptions measured;
    std::string model, fit, out;
    double acceleration = 1000;
    long seed = 1;
    int draws = 2000;
    OutputOptions output;
};

void check(const CalibrateCall& options) {
    const MeasuredOptions& from = options.measured;
    if (from.file.empty() == from.power_log.empty())
        throw Error("calibrate needs either a table or history of measured prints, or --power-log",
                    Fault::usage);
    if (from.power_log.empty() != from.gcode.empty())
        throw Error(
            "--power-log LOG.csv and --gcode FILE belong together: what was drawn and what "
            "was printed",
            Fault::usage);
}

// In the order in which they are shown; the first is shown in full unless another is asked for.
std::vector<EnergyModel> models_for(const MeasuredPrints& measured) {
    using enum EnergyModel;
    const Observation& first = measured.prints.front();
    std::vector<EnergyModel> models;
    if (!measured.of_machine) {
        models = {published, pooled, physical};
        if (first.duration) models.push_back(EnergyModel::time);
    } else if (measured.parts_of_one) {
        models = {running};
    } else {
        models = {machine, running};
        if (first.modelled) models.push_back(scaled);
    }
    return models;
}

std::string shown_place(const MeasuredPrints& measured) { return measured.inputs.front(); }

// The fit to be shown in full.
std::size_t chosen_fit(const CalibrateCall& options, const Calibration& found,
                       const std::vector<EnergyModel>& models, const MeasuredPrints& measured) {
    if (options.model == "best")
        if (const auto best = best_at_new_prints(found)) return *best;
    const std::string model = options.model.empty() || options.model == "best"
                                  ? std::string(name_of(models.front()))
                                  : options.model;
    const std::string fit = !options.fit.empty()  ? options.fit
                            : measured.of_machine ? "non-negative"
                                                  : "ordinary";
    for (std::size_t i = 0; i < found.fits.size(); ++i)
        if (name_of(found.fits[i].model) == model && name_of(found.fits[i].method) == fit) return i;
    for (const Unfitted& no : found.unfitted) {
        if (name_of(no.model) != model) continue;
        const bool recorded = lacking(no.model, measured.prints.front()).empty();
        throw Error(
            fmt::format("{}: {} cannot be fitted: {}{}", shown_place(measured), model, no.reason,
                        found.fits.empty()
                            ? ""
                            : fmt::format("; --model {} can", name_of(found.fits.back().model))),
            recorded ? Fault::not_converged : Fault::input);
    }
    throw Error(fmt::format("--model {}: is not for the energy of {}", model,
                            measured.of_machine ? "whole machines" : "X and Y motors"),
                Fault::usage);
}

std::vector<std::string> warnings_about(const MeasuredPrints& measured,
                                        const std::vector<EnergyModel>& models,
                                        const CalibrateCall& options) {
    std::vector<std::string> warnings;
    EnergyModel plainest = models.front();
    for (const EnergyModel model : models)
        if (columns_of(model).size() <= columns_of(plainest).size() &&
            lacking(model, measured.prints.front()).empty())
            plainest = model;
    Rows rows;
    std::vector<double> energies;
    for (const Observation& seen : measured.prints) {
        if (!lacking(plainest, seen).empty()) return warnings;
        rows.push_back(row_of(plainest, seen, {options.acceleration}));
        energies.push_back(seen.energy);
    }
    for (const OutlyingRow& row : outlying(rows, energies))
        warnings.push_back(fmt::format(
            "{}: its energy is {:.3g} times what the other prints suggest ({:.0f} standard "
            "deviations off): is its unit right? It was kept",
            measured.prints[row.row].name, row.ratio, row.sigmas));
    return warnings;
}

void warn_of_scope(const MeasuredPrints& measured, std::vector<std::string>& warnings) {
    constexpr double too_much = 30;  // W, for the motors of X and Y
    const Observation& first = measured.prints.front();
    if (measured.of_machine || !first.duration || first.energy < too_much * *first.duration) return;
    warnings.push_back(fmt::format(
        "{}: {:.0f} W on average is more than X and Y motors draw; if it is the whole machine's, "
        "say --scope machine",
        first.name, first.energy / *first.duration));
}

void write_model(const CalibrateCall& options, const FittedModel& fit,
                 const MeasuredPrints& measured) {
    if (options.out.empty()) return;
    OutputFile file(options.out);
    write_calibrated(
        file.stream(), calibrated(fit, {options.acceleration}),
        fmt::format("beadwork calibrate: {} least squares on {} prints of {}", name_of(fit.method),
                    measured.prints.size(), shown_place(measured)));
    file.keep();
}

void calibrate(const CalibrateCall& options) {
    check(options);
    const Console console = console_of(options.output);
    const MeasuredPrints measured = measured_prints(options.measured, console);
    const std::vector<EnergyModel> models = models_for(measured);
    const Calibration found =
        bead::calibrate(measured.prints, models,
                        {.model = {options.acceleration},
                         .bootstrap = {options.draws, std::uint64_t(options.seed)}});
    const std::size_t chosen = chosen_fit(options, found, models, measured);
    std::vector<std::string> warnings = warnings_about(measured, models, options);
    warn_of_scope(measured, warnings);

    console.say("{}: {} {}, {} group{}; taken as {}\n", shown_place(measured),
                measured.prints.size(), measured.parts_of_one ? "stretches of one print" : "prints",
                found.groups, found.groups == 1 ? "" : "s", measured.kind);
    console.say("energy of {}\n",
                measured.of_machine ? "the whole machine" : "the X and Y motors alone");
    for (const std::string& note : measured.notes) console.say("{}\n", note);
    print_calibration(console, found, chosen, measured.prints);
    for (const std::string& warning : warnings) console.warn(warning);

    write_model(options, found.fits[chosen], measured);
    Json result = result_head("calibrate", measured.inputs);
    result.update(calibration_json(found, chosen, measured));
    result["acceleration_mm_s2"] = options.acceleration;
    result["seed"] = options.seed;
    result["warnings"] = warnings;
    write_result(options.output.json, result);
}

void declare(CLI::App& command, CalibrateCall& options) {
    MeasuredOptions& from = options.measured;
    command.add_option("OBSERVATIONS", from.file,
                       "table of measured prints (.csv), or Moonraker's job history (.json)");
    command.add_option("--power-log", from.power_log, "two columns, time and watts")
        ->type_name("LOG.csv");
    command.add_option("--gcode", from.gcode, "what was printed while the log ran")
        ->type_name("FILE");
    command.add_option("--gcode-folder", from.gcode_folder, "where the history's files are")
        ->type_name("DIR");
    command.add_option("--sensor", from.sensor, "the reading of a history that is the energy");
    command.add_option("--scope", from.scope, "what was measured: motors (X and Y) or machine")
        ->check(CLI::IsMember({"motors", "machine"}))
        ->default_str("motors for tables of features or files, else machine");
    std::vector<std::string> models(energy_model_names.begin(), energy_model_names.end());
    models.emplace_back("best");
    command.add_option("--model", options.model, "to show in full and to write; best: by itself")
        ->check(CLI::IsMember(models));
    command.add_option("--fit", options.fit, "least squares: ordinary, weighted or non-negative")
        ->check(CLI::IsMember(
            std::vector<std::string>(fit_method_names.begin(), fit_method_names.end())));
    command
        .add_option("--acceleration", options.acceleration,
                    "mm/s², of the prints; the physical model reckons with it")
        ->check(CLI::Range(1.0, 1e6))
        ->capture_default_str();
    command.add_option("--seed", options.seed, "of the bootstrap")
        ->check(CLI::NonNegativeNumber)
        ->capture_default_str();
    command.add_option("--bootstrap", options.draws, "number of draws")
        ->check(CLI::Range(100, 1'000'000))
        ->capture_default_str();
    command.add_option("-o,--output", options.out, "write the coefficients")->type_name("OUT.toml");
    bead::cli::declare(command, from.machine);
    bead::cli::declare(command, options.output);
}

}  // namespace

void add_calibrate(CLI::App& app) {
    const auto options = std::make_shared<CalibrateCall>();
    CLI::App& command =
        *app.add_subcommand("calibrate", "the energy model's coefficients from measured prints");
    command.footer(
        "Examples:\n"
        "  beadwork calibrate prints.csv --model best -o mine.toml\n"
        "  beadwork calibrate history.json --gcode-folder ~/printer_data/gcodes\n"
        "  beadwork calibrate --power-log plug.csv --gcode part.gcode --printer ender3");
    declare(command, *options);
    command.callback([options] { calibrate(*options); });
}

}  // namespace bead::cli
