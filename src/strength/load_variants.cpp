#include "strength/load_variants.h"

#include <algorithm>

#include "fem/stretch.h"

namespace bead {
namespace {

Load put(const Region& part, Load load, double turn, double move) {
    load.force = rotated(load.force, unit(turn * load.turn));
    if (move * load.move != 0) load.on = moved(part, load.on, move * load.move);
    load.turn = load.move = 0;
    return load;
}

std::vector<double> steps(bool has_range) {
    return has_range ? std::vector<double>{0, -1, 1} : std::vector<double>{0};
}

}  // namespace

std::vector<Variant> load_variants(const LoadCase& load_case) {
    std::vector<Variant> variants;
    for (std::size_t s = 0; s < load_case.situations.size(); ++s) {
        const std::vector<Load>& loads = load_case.situations[s].loads;
        const bool turns = std::ranges::any_of(loads, [](const Load& l) { return l.turn > 0; });
        const bool moves = std::ranges::any_of(loads, [](const Load& l) { return l.move > 0; });
        for (const double move : steps(moves))
            for (const double turn : steps(turns)) {
                Variant variant{s, turn, move, {}};
                for (const Load& load : loads)
                    variant.loads.push_back(put(load_case.part, load, turn, move));
                variants.push_back(std::move(variant));
            }
    }
    return variants;
}

double total_force(const std::vector<Load>& loads) {
    double sum = 0;
    for (const Load& load : loads) sum += length(load.force);
    return sum;
}

}  // namespace bead
