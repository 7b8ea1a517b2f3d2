#include "strength_report.h"

#include <algorithm>

#include "core/error.h"
#include "geom/polygon.h"
#include "job/solid_material_file.h"
#include "study/green_part.h"
#include "study/reinforce.h"

namespace bead::cli {

void print_strengths(const Console& console, std::vector<NamedStrength> designs) {
    std::ranges::stable_sort(designs, std::greater{}, [](const NamedStrength& design) {
        return strength_to_weight(design.strength);
    });
    console.say("{:<30} {:>8} {:>9} {:>9} {:>9} {:>10} {:>9}\n", "design", "g", "N/mm", "breaks N",
                "buckles N", "sideways N", "N/g");
    for (const auto& [name, s, is_baseline, place] : designs) {
        if (!s.holds) {
            console.say("{:<30} {:>8.2f} holds nothing: loads and supports do not hang together\n",
                        name, s.mass);
            continue;
        }
        console.say("{:<30} {:>8.3f} {:>9.1f} {:>9.1f} {:>9.1f} {:>10} {:>9.2f}\n", name, s.mass,
                    s.stiffness, s.failure_load, s.buckling_load,
                    s.sideways_load ? fmt::format("{:.1f}", *s.sideways_load) : "-",
                    strength_to_weight(s));
    }
}

void warn_of_sideways(const Console& console, const std::vector<NamedStrength>& designs) {
    for (const auto& [name, s, is_baseline, place] : designs)
        if (s.sideways_load && !s.counts_sideways && *s.sideways_load < s.bears())
            console.warn(
                fmt::format("{}: buckles out of its plane at {:.1f} N unless it is guided; say "
                            "guided = true or false in the case",
                            name, *s.sideways_load));
}

Json strength_json(const NamedStrength& design) {
    const Strength& s = design.strength;
    Json json{{"name", design.name},
              {"baseline", design.is_baseline},
              {"holds", s.holds},
              {"mass_g", s.mass},
              {"volume_mm3", s.volume},
              {"covered_mm2", s.covered},
              {"stiffness_n_mm", s.stiffness},
              {"failure_load_n", s.failure_load},
              {"weakest_mm", {s.weakest.x, s.weakest.y}},
              {"buckling_factor", s.buckling_factor},
              {"buckling_load_n", s.buckling_load},
              {"bears_n", s.bears()},
              {"strength_to_weight", strength_to_weight(s)}};
    if (s.sideways_load) json["sideways_buckling_load_n"] = *s.sideways_load;
    if (design.place)
        json["place"] = {{"turn_deg", design.place->turn * 180 / pi},
                         {"mirrored", design.place->mirrored},
                         {"origin_mm", {design.place->origin.x, design.place->origin.y}}};
    json["counts_sideways"] = s.counts_sideways;
    if (s.peak_load) json["peak_load_n"] = *s.peak_load;
    if (s.anisotropic_load) json["anisotropic_failure_load_n"] = *s.anisotropic_load;
    return json;
}

void declare(CLI::App& command, CaseOptions& options) {
    command.add_option("CASE", options.file, "CASE.toml: a part, its supports and loads")
        ->required();
    command
        .add_option("--fill", options.fill,
                    "deposited volume over solid volume, instead of the case's")
        ->check(CLI::Range(0.01, 1.0));
    command
        .add_option("--solid", options.solid,
                    "compute with this material's strength, and print at its temperatures, instead "
                    "of the case's: abs, pla, petg, 17-4ph, 316l or FILE.toml")
        ->type_name("NAME|FILE.toml");
    command
        .add_option("--range", options.range,
                    "degrees and mm by which every load may turn and move; the worst counts")
        ->type_name("DEG MM")
        ->expected(2)
        ->check(CLI::Range(0.0, 1000.0));
}

// Tests are made on pixels of a sixth of a bead, or of what is asked for.
void expect_testable(const LoadCase& load_case, const std::string& file, double pixel) {
    constexpr double most = 1e7, bytes_per_pixel = 1500;
    const double pixels = area(load_case.part) / (pixel * pixel);
    if (pixels <= most) return;
    throw Error(fmt::format("{}: beads of {:g} mm are too fine for a part of {:.4g} mm²: {:.3g} "
                            "million pixels, some {:.0f} GB; give print.bead_width_mm wider",
                            file, load_case.print.bead_width, area(load_case.part), pixels / 1e6,
                            pixels * bytes_per_pixel * 1e-9),
                Fault::infeasible);
}

LoadCase case_of(const CaseOptions& options) {
    LoadCase load_case = read_plane_case(options.file);
    if (options.fill > 0) load_case.print.fill = options.fill;
    if (!options.solid.empty()) {
        load_case.material = load_solid_material(options.solid);
        load_case.print.heat = load_print_heat(options.solid);
    }
    if (options.range.size() == 2)
        for (Situation& situation : load_case.situations)
            for (Load& load : situation.loads) {
                load.turn = options.range[0] * pi / 180;
                load.move = options.range[1];
            }
    load_case.print = as_sintered(load_case.print, load_case.material);
    check_printable(load_case, options.file);
    constexpr double pixels_per_bead = 6;
    if (options.pixel > load_case.print.bead_width / 2)
        throw Error(fmt::format("--pixel {:g}: wider than half a bead, {:g} mm; give less",
                                options.pixel, load_case.print.bead_width / 2),
                    Fault::usage);
    expect_testable(
        load_case, options.file,
        options.pixel > 0 ? options.pixel : load_case.print.bead_width / pixels_per_bead);
    return load_case;
}

}  // namespace bead::cli
