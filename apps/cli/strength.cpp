// beadwork strength: a simulated test of printed structures, slicers' patterns beside them.
#include <algorithm>
#include <atomic>
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
    bool best = false;  // of the baselines is all that is asked for
    StrengthOptions test;
    PrintedFileOptions printed;
    int threads = 0;
    OutputOptions output;
};

struct Design {
    std::string name;
    std::vector<Toolpath> layers;
    bool is_baseline = false;
    std::optional<BedPlace> place{};  // of a file
};

std::string name_of_place(const SlicerSetting& setting) {
    return setting.phases == 1 ? name_of(setting)
                               : fmt::format("{}, place {}", name_of(setting), setting.phase + 1);
}

std::vector<Design> designs_of_files(const StrengthCall& options, const LoadCase& load_case,
                                     const Console& console) {
    std::vector<PrintedFile> printed(options.files.size());
    parallel_for(printed.size(), options.threads, [&](std::size_t i) {
        printed[i] = printed_file(options.files[i], load_case, options.printed);
    });
    std::vector<Design> designs;
    for (std::size_t i = 0; i < printed.size(); ++i) {
        for (const std::string& warning : printed[i].warnings) console.warn(warning);
        designs.push_back({std::filesystem::path(options.files[i]).filename().string(),
                           std::move(printed[i].layers), false, printed[i].place});
    }
    return designs;
}

std::vector<Design> baselines_of(const LoadCase& load_case, int phases, int threads) {
    const std::vector<SlicerSetting> settings = slicer_settings(phases);
    std::vector<std::optional<Layout>> layouts(settings.size());
    parallel_for(settings.size(), threads,
                 [&](std::size_t i) { layouts[i] = slicer_layout(load_case, settings[i]); });
    std::vector<Design> designs;
    for (std::size_t i = 0; i < settings.size(); ++i)
        if (layouts[i])
            designs.push_back(
                {name_of_place(settings[i]), {layer_of(*layouts[i], load_case.print)}, true, {}});
    return designs;
}

std::vector<Design> designs_of(const StrengthCall& options, const LoadCase& load_case,
                               const Console& console) {
    std::vector<Design> designs = designs_of_files(options, load_case, console);
    if (options.no_baselines && designs.empty())
        throw Error("nothing to test: give G-code files or leave --no-baselines out", Fault::usage);
    if (options.no_baselines) return designs;
    for (Design& design : baselines_of(load_case, options.phases, options.threads))
        designs.push_back(std::move(design));
    if (designs.empty())
        throw Error(fmt::format("{}: no slicer pattern weighs {:.3g} of the solid part; ask for "
                                "more (fill)",
                                options.load_case.file, load_case.print.fill),
                    Fault::infeasible);
    return designs;
}

// Counts what is done, whichever thread does it.
class Count {
  public:
    Count(Progress progress, std::size_t all) : progress_(std::move(progress)), all_(all) {}
    void one_more(std::string_view what) { tell(progress_, double(++done_) / double(all_), what); }
    void finish() { tell(progress_, 1, "done"); }

  private:
    Progress progress_;
    std::size_t all_;
    std::atomic<std::size_t> done_ = 0;
};

NamedStrength tested(const Design& design, const LoadCase& load_case, StrengthOptions how) {
    how.sideways = !design.is_baseline;
    return {design.name, strength_of(design.layers, load_case, how), design.is_baseline,
            design.place};
}

// Patterns whose first failure alone says that another is better are not tested for buckling, and
// left out: files and the best of the patterns remain.
std::vector<NamedStrength> tested_for_best(const std::vector<Design>& designs,
                                           const LoadCase& load_case, const StrengthCall& options,
                                           Count& count) {
    std::vector<NamedStrength> results(designs.size());
    StrengthOptions quick = options.test;
    quick.buckling = false;
    parallel_for(designs.size(), options.threads, [&](std::size_t i) {
        results[i] = tested(designs[i], load_case, designs[i].is_baseline ? quick : options.test);
        count.one_more("first failure");
    });
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < designs.size(); ++i)
        if (designs[i].is_baseline) order.push_back(i);
    const auto per_weight = [&](std::size_t i) { return strength_to_weight(results[i].strength); };
    std::ranges::stable_sort(order, std::greater{}, per_weight);
    double best = -1;
    std::vector<NamedStrength> kept;
    for (std::size_t i = 0; i < designs.size(); ++i)
        if (!designs[i].is_baseline) kept.push_back(results[i]);
    NamedStrength best_one;
    for (const std::size_t i : order) {
        if (per_weight(i) <= best) break;
        results[i] = tested(designs[i], load_case, options.test);
        if (per_weight(i) <= best) continue;
        best = per_weight(i);
        best_one = results[i];
    }
    if (best >= 0) kept.push_back(std::move(best_one));
    return kept;
}

std::vector<NamedStrength> tested(const std::vector<Design>& designs, const LoadCase& load_case,
                                  const StrengthCall& options, const Progress& progress) {
    Count count(progress, designs.size() + 1);
    std::vector<NamedStrength> results(designs.size());
    if (options.best)
        results = tested_for_best(designs, load_case, options, count);
    else
        parallel_for(designs.size(), options.threads, [&](std::size_t i) {
            results[i] = tested(designs[i], load_case, options.test);
            count.one_more("failure and buckling");
        });
    count.finish();
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
    if (const auto lost = unprinted_words(load_case))
        console.warn(options.load_case.file + ": " + *lost);
    const std::vector<NamedStrength> results =
        tested(designs_of(options, load_case, console), load_case, options, progress_on(console));
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
        "  beadwork strength examples/cases/mbb.toml beam.gcode --best");
    declare(command, options->load_case);
    command.add_option("FILES", options->files, "G-code of the part, of any slicer");
    command.add_flag("--no-baselines", options->no_baselines, "test the files only");
    command.add_flag("--best", options->best,
                     "of slicers' patterns only the strongest per weight, in less time");
    command
        .add_option("--phases", options->phases, "places in which each slicer pattern is tested")
        ->check(CLI::Range(1, 16))
        ->capture_default_str();
    command.add_flag("--progressive", options->test.progressive,
                     "also what is borne after the first failure");
    command.add_flag("--anisotropic", options->test.anisotropic,
                     "also for beads weaker across than along");
    command.add_option("--pixel", options->load_case.pixel, "mm; 0: a sixth of the bead's width")
        ->check(CLI::Range(0.0, 10.0));
    declare(command, options->printed);
    command.add_option("--threads", options->threads, "0: all")->check(CLI::Range(0, 1024));
    declare(command, options->output);
    command.callback([options] {
        options->test.pixel = options->load_case.pixel;
        strength(*options);
    });
}

}  // namespace bead::cli
