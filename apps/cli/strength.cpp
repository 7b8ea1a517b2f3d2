// beadwork strength: a simulated test of printed structures, slicers' patterns beside them.
#include <algorithm>
#include <filesystem>
#include <memory>

#include "command.h"
#include "core/error.h"
#include "core/parallel.h"
#include "geom/polygon.h"
#include "layers_of_file.h"
#include "options.h"
#include "strength_report.h"
#include "study/reinforce.h"
#include "study/slicer_layouts.h"

namespace bead::cli {
namespace {

struct StrengthCall {
    CaseOptions load_case;
    std::vector<std::string> files;
    int phases = 4;
    bool no_baselines = false;
    bool best = false;  // is all that is asked of the baselines
    StrengthOptions test;
    double filament = 1.75;
    int threads = 0;
    OutputOptions output;
};

struct Design {
    std::string name;
    std::vector<Toolpath> layers;
    bool is_baseline = false;
};

std::string name_of_place(const SlicerSetting& setting) {
    return setting.phases == 1 ? name_of(setting)
                               : fmt::format("{}, place {}", name_of(setting), setting.phase + 1);
}

std::vector<Design> designs_of(const StrengthCall& options, const LoadCase& load_case) {
    std::vector<Design> designs;
    for (const std::string& file : options.files)
        designs.push_back({std::filesystem::path(file).filename().string(),
                           layers_of_file(file, load_case, options.filament), false});
    if (options.no_baselines) return designs;
    for (const SlicerSetting& setting : slicer_settings(options.phases))
        if (const auto layout = slicer_layout(load_case, setting))
            designs.push_back({name_of_place(setting), {layer_of(*layout, load_case.print)}, true});
    if (designs.empty())
        throw Error(fmt::format("{}: no slicer pattern weighs {:.3g} of the solid part; ask for "
                                "more (fill)",
                                options.load_case.file, load_case.print.fill),
                    Fault::infeasible);
    return designs;
}

NamedStrength tested(const Design& design, const LoadCase& load_case, StrengthOptions how) {
    how.sideways = !design.is_baseline;
    return {design.name, strength_of(design.layers, load_case, how), design.is_baseline};
}

// Patterns whose first failure alone says that another is better are not tested for buckling.
std::vector<NamedStrength> tested_for_best(const std::vector<Design>& designs,
                                           const LoadCase& load_case, const StrengthCall& options) {
    std::vector<NamedStrength> results(designs.size());
    StrengthOptions quick = options.test;
    quick.buckling = false;
    parallel_for(designs.size(), options.threads, [&](std::size_t i) {
        results[i] = tested(designs[i], load_case, designs[i].is_baseline ? quick : options.test);
    });
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < designs.size(); ++i)
        if (designs[i].is_baseline) order.push_back(i);
    const auto per_weight = [&](std::size_t i) { return strength_to_weight(results[i].strength); };
    std::ranges::stable_sort(order, std::greater{}, per_weight);
    double best = 0;
    for (const std::size_t i : order) {
        if (per_weight(i) <= best) break;
        results[i] = tested(designs[i], load_case, options.test);
        best = std::max(best, per_weight(i));
    }
    return results;
}

std::vector<NamedStrength> tested(const std::vector<Design>& designs, const LoadCase& load_case,
                                  const StrengthCall& options) {
    if (options.best) return tested_for_best(designs, load_case, options);
    std::vector<NamedStrength> results(designs.size());
    parallel_for(designs.size(), options.threads,
                 [&](std::size_t i) { results[i] = tested(designs[i], load_case, options.test); });
    return results;
}

void warn_of_weights(const std::vector<NamedStrength>& results, const LoadCase& load_case,
                     const Console& console) {
    constexpr double same = 0.01;
    const double asked = load_case.print.fill * area(load_case.part) * load_case.thickness;
    for (const NamedStrength& result : results) {
        const double off = result.strength.volume / asked - 1;
        if (result.is_baseline || std::abs(off) <= same) continue;
        console.warn(
            fmt::format("{}: {:.0f} mm³, {:+.1f} % of what the case asks for; compare "
                        "strength per weight with care",
                        result.name, result.strength.volume, 100 * off));
    }
}

void strength(const StrengthCall& options) {
    const Console console = console_of(options.output);
    const LoadCase load_case = case_of(options.load_case);
    const std::vector<NamedStrength> results =
        tested(designs_of(options, load_case), load_case, options);
    warn_of_weights(results, load_case, console);
    print_strengths(console, results);
    warn_of_sideways(console, results);
    if (options.output.json.empty()) return;
    std::vector<std::string> inputs{options.load_case.file};
    inputs.insert(inputs.end(), options.files.begin(), options.files.end());
    Json json = result_head("strength", inputs);
    json["designs"] = Json::array();
    for (const NamedStrength& result : results) json["designs"].push_back(strength_json(result));
    write_result(options.output.json, json);
}

}  // namespace

void add_strength(CLI::App& app) {
    const auto options = std::make_shared<StrengthCall>();
    CLI::App& command = *app.add_subcommand(
        "strength", "a simulated test of printed structures, of the same part at the same weight");
    command.footer(
        "Example: is the reinforced beam stronger than what a slicer would print?\n"
        "  beadwork reinforce examples/cases/mbb.toml -o beam.gcode\n"
        "  beadwork strength examples/cases/mbb.toml beam.gcode");
    declare(command, options->load_case);
    command.add_option("FILES", options->files, "G-code of the part, of any slicer");
    command.add_flag("--no-baselines", options->no_baselines, "test the files only");
    command
        .add_option("--phases", options->phases, "places in which each slicer pattern is tested")
        ->check(CLI::Range(1, 16))
        ->capture_default_str();
    command.add_flag("--progressive", options->test.progressive,
                     "also what is borne after the first failure");
    command.add_flag("--anisotropic", options->test.anisotropic,
                     "also for beads weaker across than along");
    command.add_option("--pixel", options->test.pixel, "mm; 0: a sixth of the bead's width")
        ->check(CLI::Range(0.0, 10.0));
    command.add_option("--filament", options->filament, "mm, diameter, of the files")
        ->check(CLI::Range(0.1, 20.0))
        ->capture_default_str();
    command.add_option("--threads", options->threads, "0: all")->check(CLI::Range(0, 1024));
    declare(command, options->output);
    command.callback([options] { strength(*options); });
}

}  // namespace bead::cli
