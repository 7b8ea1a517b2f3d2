#include "infill/trimmed_ends.h"

#include <algorithm>
#include <map>

#include "geom/line_index.h"
#include "geom/resample.h"

namespace bead {
namespace {

constexpr double step = 0.2;    // mm, at which contacts are looked for
constexpr double bucket = 1.0;  // mm

LineIndex others(const std::vector<FamilyLine>& lines, std::span<const Polyline> fixed,
                 int family) {
    std::vector<Polyline> all(fixed.begin(), fixed.end());
    for (const FamilyLine& line : lines)
        if (line.family != family) all.push_back(line.points);
    return {all, bucket};
}

Polyline between_contacts(const Polyline& line, const LineIndex& others, double contact) {
    const Polyline even = resampled(line, step);
    const auto touches = [&](Vec2 p) { return others.nearest(p, contact).has_value(); };
    const auto first = std::find_if(even.begin(), even.end(), touches);
    const auto last = std::find_if(even.rbegin(), even.rend(), touches).base();
    if (last - first < 2) return {};
    Polyline kept;
    for (auto p = first; p < last; p += 2) kept.push_back(*p);
    if (kept.back() != *(last - 1)) kept.push_back(*(last - 1));
    return kept;
}

}  // namespace

std::vector<FamilyLine> trimmed_ends(std::vector<FamilyLine> lines, std::span<const Polyline> fixed,
                                     const TrimOptions& options) {
    for (int pass = 0; pass < options.passes; ++pass) {
        std::map<int, LineIndex> index;
        for (const FamilyLine& line : lines)
            if (!index.contains(line.family))
                index.emplace(line.family, others(lines, fixed, line.family));
        std::vector<FamilyLine> kept;
        for (const FamilyLine& line : lines) {
            if (length(line.points) < options.shortest) continue;
            Polyline cut = between_contacts(line.points, index.at(line.family), options.contact);
            if (length(cut) >= options.shortest) kept.push_back({line.family, std::move(cut)});
        }
        lines = std::move(kept);
    }
    return lines;
}

}  // namespace bead
