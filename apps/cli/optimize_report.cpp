#include "optimize_report.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "energy_table.h"
#include "part.h"

namespace bead::cli {
namespace {

double degrees(double rad) { return std::round(rad * 180 / pi * 1e9) / 1e9; }
double percent_less(double before, double after) {
    return before > 0 ? 100 * (1 - after / before) : 0;
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

Json cost_json(const Assessment& cost, const Machine& machine) {
    Json json = {{"time_s", cost.motion.duration},
                 {"filament_mm", cost.motion.extruded},
                 {"filament_g", grams(cost.motion.extruded, machine)}};
    json.update(energy_json(cost, machine.printer.power));
    return json;
}

}  // namespace

void print_optimum(const Console& console, const Optimum& best, const Machine& machine,
                   const std::string& model, const std::string& printer) {
    const Assessment &a = best.baseline.cost, &b = best.chosen.cost;
    const double before = total(a.energy.energy), after = total(b.energy.energy);
    const PlanOptions& plan = best.baseline.print.plan;
    console.say("{}: {} layers on {}\n", model, best.chosen.print.parts.size(), printer);
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

Json optimum_json(const Optimum& best, const Machine& machine) {
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

    Json result;
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

}  // namespace bead::cli
