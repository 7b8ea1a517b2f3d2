#include "infill/straight_lines.h"

#include <algorithm>

#include "core/expects.h"
#include "infill/fill.h"

namespace bead {
namespace {

struct Cut {
    long line = 0;
    double along = 0;  // mm, in the direction of the line
    EdgePlace place;
};

struct Lines {
    Vec2 centre, direction;
    double spacing = 1, shift = 0;
    [[nodiscard]] double height(Vec2 p) const {
        return cross(direction, p - centre) / spacing - shift;
    }
    [[nodiscard]] Vec2 point(long line, double along) const {
        const double off = (static_cast<double>(line) + shift) * spacing;
        return centre + along * direction + off * left_of(direction);
    }
};

void append_cuts(std::vector<Cut>& cuts, const MeasuredLoop& loop, int index, const Lines& lines) {
    Vec2 a = loop.points.back();
    double a_height = lines.height(a);
    for (std::size_t i = 0; i < loop.points.size(); ++i) {
        const Vec2 b = loop.points[i];
        const double b_height = lines.height(b);
        const auto a_below = static_cast<long>(std::floor(a_height));
        const auto b_below = static_cast<long>(std::floor(b_height));
        const double at = loop.at[i > 0 ? i - 1 : loop.points.size() - 1], span = distance(a, b);
        for (long k = std::min(a_below, b_below) + 1; k <= std::max(a_below, b_below); ++k) {
            const double t =
                std::clamp((static_cast<double>(k) - a_height) / (b_height - a_height), 0.0, 1.0);
            cuts.push_back(
                {k, dot(lerp(a, b, t) - lines.centre, lines.direction), {index, at + t * span}});
        }
        a = b;
        a_height = b_height;
    }
}

}  // namespace

std::vector<CutLine> straight_lines(const std::vector<MeasuredLoop>& loops,
                                    const LineFamily& family) {
    BEAD_EXPECTS(family.spacing > 0);
    const Lines lines{family.centre, unit(family.angle), family.spacing, family.shift};
    std::vector<Cut> cuts;
    for (std::size_t i = 0; i < loops.size(); ++i)
        append_cuts(cuts, loops[i], static_cast<int>(i), lines);
    std::sort(cuts.begin(), cuts.end(), [](const Cut& a, const Cut& b) {
        return a.line != b.line ? a.line < b.line : a.along < b.along;
    });
    std::vector<CutLine> inside;
    inside.reserve(cuts.size() / 2);
    for (std::size_t i = 0; i + 1 < cuts.size(); i += 2) {
        const Cut &from = cuts[i], &to = cuts[i + 1];
        if (to.along - from.along < shortest_line) continue;
        inside.push_back({{lines.point(from.line, from.along), lines.point(to.line, to.along)},
                          from.place,
                          to.place});
    }
    return inside;
}

std::vector<Polyline> crossing_lines(const Region& region, const FillOptions& options, int count,
                                     double shift) {
    const std::vector<MeasuredLoop> loops = measured_loops(region);
    std::vector<CutLine> all;
    for (int i = 0; i < count; ++i) {
        const std::vector<CutLine> family = straight_lines(
            loops,
            {options.centre, options.angle + i * pi / count, count * options.spacing, shift});
        all.insert(all.end(), family.begin(), family.end());
    }
    return linked(all, loops, options.link);
}

}  // namespace bead
