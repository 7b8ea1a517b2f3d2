#include <algorithm>
#include <limits>

#include "core/expects.h"
#include "core/parallel.h"
#include "plan/fill_lines.h"

namespace bead {
namespace {

constexpr std::size_t most_samples = 200;
constexpr int most_rounds = 4;
constexpr double tolerance = 0.001;  // of the volume, beyond which the flow is corrected

bool has_sparse(const LayerParts& layer) {
    return std::ranges::any_of(layer.islands, [](const Island& island) {
        return std::ranges::any_of(island.fills,
                                   [](const FillArea& area) { return area.role == Role::infill; });
    });
}

double sparse_angle(const FillChoice& choice) { return choice.angle + choice.sparse_turn; }

// A layer and the angle of its lines.
struct Sample {
    const LayerParts* layer = nullptr;
    double angle = 0;
};

// At most so many, from all of the part.
std::vector<Sample> spread(const std::vector<Sample>& all) {
    const std::size_t count = std::min(all.size(), most_samples);
    std::vector<Sample> samples;
    for (std::size_t i = 0; i < count; ++i)
        samples.push_back(all[(2 * i + 1) * all.size() / (2 * count)]);
    return samples;
}

// mm³ of sparse infill in the layer at this spacing, and what it should be.
struct Amount {
    double deposited = 0, asked = 0;
};

Amount amount_in(const Sample& sample, const NamedPattern& pattern, double spacing,
                 const PlanOptions& options) {
    const LayerParts& layer = *sample.layer;
    const FillChoice choice{pattern, sample.angle};
    Amount amount;
    for (const Island& island : layer.islands)
        for (const FillArea& area : island.fills) {
            if (area.role != Role::infill) continue;
            const FillLines fill = sparse_lines(area, layer, choice, spacing, 1);
            for (const Polyline& line : fill.lines)
                amount.deposited += length(line) * section(fill.bead);
            amount.asked += options.density * bead::area(area.material) * layer.height;
        }
    return amount;
}

// What the pattern deposits for every mm³ asked for.
double yield_of(std::span<const Sample> samples, const NamedPattern& pattern, double spacing,
                const PlanOptions& options) {
    std::vector<Amount> amounts(samples.size());
    parallel_for(samples.size(), options.threads, [&](std::size_t i) {
        amounts[i] = amount_in(samples[i], pattern, spacing, options);
    });
    Amount sum;
    for (const Amount& amount : amounts) {
        sum.deposited += amount.deposited;
        sum.asked += amount.asked;
    }
    return sum.asked > 0 ? sum.deposited / sum.asked : 1;
}

struct Matched {
    double spacing = 0, flow = 1;
};

// What a pattern deposits goes nearly with 1 / spacing: taking its yield for a factor converges
// fast.
Matched matched(std::span<const Sample> samples, const NamedPattern& pattern, double nominal,
                const PlanOptions& options) {
    constexpr double thinnest = 0.7, thickest = 1.4;
    Matched best{nominal, 1};
    double spacing = nominal, least = std::numeric_limits<double>::infinity();
    const double out_of_reach = std::log(thickest);
    for (int round = 0;
         least > (round < most_rounds ? tolerance : out_of_reach) && round < 4 * most_rounds;
         ++round) {
        const double yield = yield_of(samples, pattern, spacing, options);
        if (yield <= 0) break;
        if (std::abs(std::log(yield)) < least) {
            least = std::abs(std::log(yield));
            best = {spacing, std::clamp(1 / yield, thinnest, thickest)};
        }
        // Few lines in a narrow place come and go together: then by smaller and smaller steps.
        const double step = round < most_rounds ? 1.0 : 1.0 / (round - most_rounds + 2);
        spacing *= std::pow(std::clamp(yield, 0.5, 2.0), step);
    }
    if (least < tolerance) best.flow = 1;
    return best;
}

// Puts in what suits the pattern on these layers; nothing if there are none.
void match(FillSpacing& lines, const NamedPattern& pattern, const std::vector<Sample>& layers,
           const PlanOptions& options) {
    if (layers.empty()) return;
    const std::vector<Sample> samples = spread(layers);
    const double nominal = spacing(samples.back().layer->bead) / options.density;
    const Matched found = matched(samples, pattern, nominal, options);
    lines.by_pattern[index_of(pattern)] = found.spacing;
    lines.flow[index_of(pattern)] = found.flow;
}

}  // namespace

FillSpacing matched_spacing(std::span<const LayerParts> parts, const PlanOptions& options,
                            std::span<const NamedPattern> wanted) {
    FillSpacing lines;
    PlanOptions with = options;
    for (const NamedPattern& pattern : wanted) {
        with.pattern = pattern;
        std::vector<Sample> sparse;
        for (const LayerParts& layer : parts)
            if (has_sparse(layer))
                sparse.push_back({&layer, sparse_angle(usual_choice(with, layer.index))});
        match(lines, pattern, sparse, options);
    }
    return lines;
}

FillSpacing matched_spacing(std::span<const LayerParts> parts, std::span<const FillChoice> choices,
                            const PlanOptions& options) {
    BEAD_EXPECTS(parts.size() == choices.size());
    FillSpacing lines;
    for (const NamedPattern& pattern : patterns) {
        std::vector<Sample> sparse;
        for (std::size_t i = 0; i < parts.size(); ++i)
            if (choices[i].pattern.name == pattern.name && has_sparse(parts[i]))
                sparse.push_back({&parts[i], sparse_angle(choices[i])});
        match(lines, pattern, sparse, options);
    }
    return lines;
}

}  // namespace bead
