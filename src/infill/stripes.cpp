#include "infill/stripes.h"

#include "infill/level_lines.h"
#include "infill/phase.h"

namespace bead {

std::vector<Polyline> stripes(const Region& region, const LineField& field,
                              const StripeOptions& options) {
    const StripeGrid grid = stripe_grid(region, field, options.grid);
    std::vector<Polyline> lines =
        level_lines(grid, best_phase(grid, options.seed, options.iterations));
    std::erase_if(lines, [&](const Polyline& line) { return length(line) < options.shortest; });
    return lines;
}

}  // namespace bead
