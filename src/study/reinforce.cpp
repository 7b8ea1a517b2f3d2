#include "study/reinforce.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/parallel.h"
#include "geom/polygon.h"
#include "strength/sideways_strength.h"
#include "study/fixed_lines.h"
#include "study/slicer_layouts.h"
#include "study/stress_lines.h"

namespace bead {
namespace {

// Of the area, held back for braces and patches: soft materials buckle before they break, stiff
// ones need patches only.
constexpr double soft_reserve = 0.11, stiff_reserve = 0.06;
constexpr double stiff_from = 100;     // Young's modulus over strength
constexpr double thinnest_web = 0.06;  // of the area, lines that there must be room for
constexpr double pixels_per_bead = 3;
constexpr double coarse_pixels = 2;  // per bead, to see which slicer patterns are worth a test

double reserve(const SolidMaterial& material) {
    return material.young / material.tensile < stiff_from ? soft_reserve : stiff_reserve;
}

Layout fixed_lines(const LoadCase& load_case) {
    Layout fixed = wall_lines(load_case.part, load_case.print.bead_width, load_case.print.walls);
    for (LayoutLine& line : pad_lines(load_case, load_case.print.walls))
        fixed.push_back(std::move(line));
    return fixed;
}

Strength scored(const LoadCase& load_case, const Layout& layout) {
    const Toolpath layer = layer_of(layout, load_case.print);
    return strength_of({&layer, 1}, load_case, {.sideways = false});
}

Candidate grown(const LoadCase& load_case, const Layout& fixed, const Densities& best,
                std::uint32_t seed, const ReinforceOptions& options) {
    const double whole = asked_area(load_case);
    Layout lines = stress_lines(load_case, fixed, best,
                                {.area = whole * (1 - reserve(load_case.material)),
                                 .least = solid_pitch * load_case.print.bead_width,
                                 .seed = seed});
    StrengthenOptions how;
    how.area = whole;
    how.pixel = options.pixel > 0 ? options.pixel : load_case.print.bead_width / pixels_per_bead;
    how.shortest_brace = options.shortest_brace;
    Strengthened strong = strengthened(load_case, std::move(lines), how);
    Candidate candidate{fmt::format("stress lines, seed {}", seed),
                        std::move(strong.layout),
                        {},
                        std::move(strong.steps)};
    candidate.strength = scored(load_case, candidate.layout);
    return candidate;
}

// What the pattern bears before it breaks, per weight, seen coarsely.
double promise(const LoadCase& load_case, const Layout& layout) {
    const Toolpath layer = layer_of(layout, load_case.print);
    StrengthOptions coarse;
    coarse.pixel = load_case.print.bead_width / coarse_pixels;
    coarse.buckling = false;
    return strength_to_weight(strength_of({&layer, 1}, load_case, coarse));
}

// Patterns that might be better than `bar` (N/g) when tested finely.
std::vector<Candidate> challengers(const LoadCase& load_case, double bar, int threads) {
    constexpr double unsure = 0.8;
    const std::vector<SlicerSetting> settings = slicer_settings(1);
    std::vector<std::optional<Candidate>> found(settings.size());
    parallel_for(settings.size(), threads, [&](std::size_t i) {
        std::optional<Layout> layout = slicer_layout(load_case, settings[i]);
        if (!layout || promise(load_case, *layout) < unsure * bar) return;
        const Strength strength = scored(load_case, *layout);
        found[i] = Candidate{name_of(settings[i]), std::move(*layout), strength, {}, true};
    });
    std::vector<Candidate> candidates;
    for (std::optional<Candidate>& candidate : found)
        if (candidate) candidates.push_back(std::move(*candidate));
    return candidates;
}

void sort_best_first(std::vector<Candidate>& candidates) {
    std::ranges::stable_sort(candidates, std::greater{}, [](const Candidate& candidate) {
        return strength_to_weight(candidate.strength);
    });
}

}  // namespace

double asked_area(const LoadCase& load_case) { return load_case.print.fill * area(load_case.part); }

double least_area(const LoadCase& load_case) {
    const double fixed = deposited_area(fixed_lines(load_case), load_case.print.bead_width);
    return fixed + thinnest_web * area(load_case.part);
}

double strength_to_weight(const Strength& strength) {
    return strength.mass > 0 ? strength.bears() / strength.mass : 0;
}

std::optional<Reinforced> reinforced(const LoadCase& load_case, const ReinforceOptions& options) {
    const Layout fixed = fixed_lines(load_case);
    const double whole = asked_area(load_case);
    if (whole < least_area(load_case)) return std::nullopt;
    tell(options.progress, 0, "densities");
    const Densities best = densities(load_case, fixed,
                                     {.area = whole * (1 - reserve(load_case.material)) -
                                              deposited_area(fixed, load_case.print.bead_width),
                                      .compression = allowed_compression(load_case.material)});
    Reinforced result;
    if (best.work > 0) {
        const double force = total_force(load_variants(load_case).front().loads);
        result.stiffness_bound = force * force / best.work;
    }
    tell(options.progress, 0.1, "lines, braces and patches");
    std::vector<Candidate> grown_lines(static_cast<std::size_t>(options.seeds));
    parallel_for(grown_lines.size(), options.threads, [&](std::size_t i) {
        grown_lines[i] = grown(load_case, fixed, best,
                               options.first_seed + static_cast<std::uint32_t>(i), options);
    });
    result.candidates = std::move(grown_lines);
    sort_best_first(result.candidates);
    tell(options.progress, 0.9, "slicer patterns");
    if (options.slicer_patterns)
        for (Candidate& challenger :
             challengers(load_case, strength_to_weight(result.best().strength), options.threads))
            result.candidates.push_back(std::move(challenger));
    sort_best_first(result.candidates);
    Candidate& best_one = result.candidates.front();
    const Toolpath layer = layer_of(best_one.layout, load_case.print);
    if (is_thin(load_case) && !best_one.strength.sideways_load)
        best_one.strength.sideways_load = sideways_load({&layer, 1}, load_case);
    tell(options.progress, 1, "done");
    return result;
}

}  // namespace bead
