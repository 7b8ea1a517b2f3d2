// beadwork optimize: the print of a part that costs least.
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>

#include "command.h"
#include "core/error.h"
#include "core/output_file.h"
#include "energy/interval.h"
#include "energy_table.h"
#include "json_result.h"
#include "part.h"
#include "scene/layer_picture.h"
#include "study/optimize.h"

namespace bead::cli {
namespace {

struct Options {
    std::string out, baseline_out, picture, patterns;
    std::string goal = "machine-energy";
    double angle_step_deg = 15;
    ProcessOptions process;
    MachineOptions machine;
    OutputOptions output;
};

double degrees(double rad) { return std::round(rad * 180 / pi * 1e9) / 1e9; }
double percent_less(double before, double after) {
    return before > 0 ? 100 * (1 - after / before) : 0;
}

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

OptimizeOptions search_options(const Options& options, const Settings& settings,
                               const Console& console) {
    OptimizeOptions search;
    search.goal = goal_of(options.goal);
    if (!options.patterns.empty()) search.patterns = patterns_of(options.patterns);
    search.angle_step = options.angle_step_deg * pi / 180;
    search.baseline_rotation = settings.rotate;
    if (options.process.by_option.contains("rotate_deg")) search.rotation = settings.rotate;
    search.threads = options.process.threads;
    search.progress = progress_on(console);
    return search;
}

// "94 layers rectilinear (0° 59, 90° 22, 75° 7 …)", the most common pattern first.
std::vector<std::string> tally(const std::vector<FillChoice>& choices) {
    struct Count {
        std::string pattern;
        long layers = 0;
        std::map<long, long> by_angle;
    };
    std::vector<Count> counts;
    for (const FillChoice& choice : choices) {
        auto count = std::ranges::find(counts, choice.pattern.name, &Count::pattern);
        if (count == counts.end())
            count = counts.insert(count, {std::string(choice.pattern.name), 0, {}});
        ++count->layers;
        ++count->by_angle[std::lround(degrees(choice.angle))];
    }
    std::ranges::stable_sort(counts, std::greater{}, &Count::layers);
    std::vector<std::string> lines;
    for (const Count& count : counts) {
        std::vector<std::pair<long, long>> angles(count.by_angle.begin(), count.by_angle.end());
        std::ranges::stable_sort(angles, std::greater{}, &std::pair<long, long>::second);
        std::string text = fmt::format("{} layers {} (", count.layers, count.pattern);
        for (std::size_t i = 0; i < std::min<std::size_t>(angles.size(), 4); ++i)
            text += fmt::format("{}{}° {}x", i > 0 ? ", " : "", angles[i].first, angles[i].second);
        lines.push_back(text + (angles.size() > 4 ? ", …)" : ")"));
    }
    return lines;
}

double sparse_area(const LayerParts& layer) {
    double sum = 0;
    for (const Island& island : layer.islands)
        for (const FillArea& fill : island.fills)
            if (fill.role == Role::infill) sum += area(fill.material);
    return sum;
}

// Of the layers with much infill, the one that saves most nearly what the whole print saves:
// neither the best nor the worst of them stands for the rest.
std::size_t telling_layer(const Optimum& best) {
    const std::vector<LayerParts>& parts = best.chosen.print.parts;
    double most = 0;
    for (const LayerParts& layer : parts) most = std::max(most, sparse_area(layer));
    const auto change = [](double before, double after) { return after / before - 1; };
    const double whole =
        change(best.baseline.cost.motion.duration, best.chosen.cost.motion.duration);
    std::size_t telling = parts.size() / 2;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < parts.size(); ++i) {
        if (sparse_area(parts[i]) < most / 2) continue;
        const double off = change(best.baseline.cost.energy.by_layer.at(i).duration,
                                  best.chosen.cost.energy.by_layer.at(i).duration) -
                           whole;
        if (std::abs(off) >= least) continue;
        least = std::abs(off);
        telling = i;
    }
    return telling;
}

Toolpath toolpath_of(const Print& print, std::size_t layer) {
    return plan_layer(print.parts[layer], print.choices[layer], print.lines, print.plan,
                      {print.parts[layer].centre});
}

Panel panel(const std::string& title, const JudgedPrint& judged, std::size_t layer) {
    const LayerEnergy& energy = judged.cost.energy.by_layer.at(layer);
    return {title, toolpath_of(judged.print, layer),
            fmt::format("this layer: {}, {:.2f} Wh", spoken_time(energy.duration),
                        energy.total / 3600)};
}

void write_picture(const std::string& file, const Optimum& best) {
    const std::size_t layer = telling_layer(best);
    const std::array panels{panel("before", best.baseline, layer),
                            panel("after", best.chosen, layer)};
    OutputFile out(file);
    out.stream() << layer_picture(
        panels, fmt::format("Layer {} of {}, z = {:.2f} mm", layer + 1,
                            best.chosen.print.parts.size(), best.chosen.print.parts[layer].z));
    out.keep();
}

std::string verdict(const Assessment& before, const Assessment& after) {
    const double saved = total(before.energy.energy) - total(after.energy.energy);
    const double sooner = before.motion.duration - after.motion.duration;
    if (saved == 0 && sooner == 0) return "nothing cheaper was found; the baseline was kept";
    const double percent = percent_less(total(before.energy.energy), total(after.energy.energy));
    return fmt::format("{}: {:.1f} Wh ({:.1f} %); the print takes {} {}",
                       saved >= 0 ? "saved" : "costs more", std::abs(saved) / 3600,
                       std::abs(percent), spoken_time(std::abs(sooner)),
                       sooner >= 0 ? "less" : "longer");
}

void print_text(const Console& console, const Options& options, const Machine& machine,
                const Optimum& best) {
    const Assessment &a = best.baseline.cost, &b = best.chosen.cost;
    const double before = total(a.energy.energy), after = total(b.energy.energy);
    const PlanOptions& plan = best.baseline.print.plan;
    console.say("{}: {} layers on {}\n", options.process.model, best.chosen.print.parts.size(),
                printer_label(options.machine));
    console.say("searched {} combinations of turn, pattern and angle; simulated {} layers\n\n",
                best.candidates, best.evaluated);
    console.say("  {:<22} {:>16} {:>16} {:>10}\n", "", "baseline", "chosen", "change");
    console.say("  {:<22} {:>16} {:>16} {:>+8.1f} %\n", "printing time",
                spoken_time(a.motion.duration), spoken_time(b.motion.duration),
                -percent_less(a.motion.duration, b.motion.duration));
    console.say("  {:<22} {:>13.2f} Wh {:>13.2f} Wh {:>+8.1f} %\n", "energy from the wall",
                before / 3600, after / 3600, -percent_less(before, after));
    print_comparison(console, a.energy.energy, b.energy.energy);
    console.say("  {:<22} {:>13.2f} kJ {:>13.2f} kJ {:>+8.1f} %\n", "X and Y motors (*)",
                standing_form(a.features) / 1000, standing_form(b.features) / 1000,
                -percent_less(standing_form(a.features), standing_form(b.features)));
    console.say("  {:<22} {:>14.1f} g {:>14.1f} g {:>+8.1f} %\n", "filament",
                grams(a.motion.extruded, machine), grams(b.motion.extruded, machine),
                -percent_less(a.motion.extruded, b.motion.extruded));
    console.say("  (*) thesis coefficients, with standing power charged all the time\n\n");
    console.say(
        "baseline: {} at {:.0f} degrees, alternating by 90; part turned by {:.0f} degrees\n",
        plan.pattern.name, degrees(plan.angle), degrees(best.baseline.rotation));
    console.say("chosen:   part turned by {:.1f} degrees; layers by pattern and angle:\n",
                degrees(best.chosen.rotation));
    for (const std::string& line : tally(best.chosen.print.choices))
        console.say("          {}\n", line);
    const Assessment& simple = best.simple.cost;
    console.say("without any search, only with lines along X and Y: {:.2f} Wh ({:+.1f} %), {}\n",
                total(simple.energy.energy) / 3600,
                -percent_less(before, total(simple.energy.energy)),
                spoken_time(simple.motion.duration));
    console.say("\n{}\n", console.good(verdict(a, b)));
}

Json cost_json(const Assessment& cost, const Machine& machine) {
    Json json = {{"time_s", cost.motion.duration},
                 {"filament_mm", cost.motion.extruded},
                 {"filament_g", grams(cost.motion.extruded, machine)}};
    json.update(energy_json(cost, machine.printer.power));
    return json;
}

Json json_of(const Options& options, const Machine& machine, const Optimum& best) {
    const Assessment &a = best.baseline.cost, &b = best.chosen.cost;
    Json chosen = {{"rotation_deg", degrees(best.chosen.rotation)}};
    chosen.update(cost_json(b, machine));
    Json layers = Json::array();
    for (std::size_t i = 0; i < best.chosen.print.parts.size(); ++i)
        layers.push_back({{"z_mm", best.chosen.print.parts[i].z},
                          {"pattern", best.chosen.print.choices[i].pattern.name},
                          {"angle_deg", degrees(best.chosen.print.choices[i].angle)}});
    chosen["layers"] = layers;
    Json baseline = {{"rotation_deg", degrees(best.baseline.rotation)},
                     {"pattern", best.baseline.print.plan.pattern.name},
                     {"angle_deg", degrees(best.baseline.print.plan.angle)}};
    baseline.update(cost_json(a, machine));

    Json simple = cost_json(best.simple.cost, machine);
    simple.erase("by_layer");

    Json result = result_head("optimize", {options.process.model});
    result["output"] = options.out;
    result["minimize"] = options.goal;
    result["baseline"] = baseline;
    result["lines_along_axes"] = simple;
    result["chosen"] = chosen;
    result["candidates"] = best.candidates;
    result["evaluated"] = best.evaluated;
    result["saving_percent"] = {
        {"machine_energy", percent_less(total(a.energy.energy), total(b.energy.energy))},
        {"xy_energy", percent_less(standing_form(a.features), standing_form(b.features))},
        {"time", percent_less(a.motion.duration, b.motion.duration)},
        {"filament", percent_less(a.motion.extruded, b.motion.extruded)}};
    return result;
}

void optimize_part(const Options& options) {
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
    print_text(console, options, machine, best);
    write_result(options.output.json, json_of(options, machine, best));
}

}  // namespace

void add_optimize(CLI::App& app) {
    const auto options = std::make_shared<Options>();
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
        .add_option("--patterns", options->patterns,
                    "to choose from, comma-separated; all if not given")
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
