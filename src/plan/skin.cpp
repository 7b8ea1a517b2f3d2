#include "plan/skin.h"

#include "core/expects.h"
#include "core/parallel.h"
#include "geom/clip.h"

namespace bead {
namespace {

Region common(const Region& a, const Region& b) { return a == b ? a : common_part(a, b); }

}  // namespace

Region without_slivers(const Region& region, double narrowest) {
    return region.empty() ? region : opened(region, narrowest / 2);
}

Region common_part(const Region& a, const Region& b) {
    if (a.empty() || b.empty()) return {};
    return intersection(a, b);
}

Region without(const Region& from, const Region& cut) {
    if (from.empty() || cut.empty()) return from;
    return difference(from, cut);
}

std::vector<Region> running_intersections(std::vector<Region> regions, int count, int threads) {
    BEAD_EXPECTS(count > 0);
    // The common part of 2 w - k neighbours or fewer follows from that of two runs of w.
    for (int run = 1; run < count;) {
        const int step = std::min(run, count - run);
        std::vector<Region> longer(regions.size());
        parallel_for(regions.size(), threads, [&](std::size_t i) {
            const std::size_t other = i + static_cast<std::size_t>(step);
            if (other < regions.size()) longer[i] = common(regions[i], regions[other]);
        });
        regions = std::move(longer);
        run += step;
    }
    return regions;
}

Split split(const Region& material, const Region& covered, const Region& above, double narrowest) {
    constexpr double no_area = 1e-6;  // mm², what rounding may leave
    Split result;
    if (area(covered) > area(material) - no_area) {
        result.sparse = material;
        return result;
    }
    const Region wide = without_slivers(covered, 2 * narrowest);
    const Region solid = without_slivers(without(material, wide), narrowest);
    result.sparse = without(material, solid);
    result.top = without_slivers(without(solid, above), narrowest);
    result.skin = without_slivers(without(solid, result.top), narrowest);
    return result;
}

}  // namespace bead
