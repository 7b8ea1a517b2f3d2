// Sierpiński's curve (W. Sierpiński 1912) in the order of K. Knopp: crosses within crosses, no
// straight piece longer than a cell. A right-angled triangle is entered at one end of its longest
// side and left at the other; it is halved from that side's middle to the right angle, each half is
// entered and left likewise, and the smallest triangles are joined by their centres. As in
// hilbert.cpp one large curve lies fixed about the centre, of which only the triangles near the
// region are visited.
//
// From triangle to triangle the curve crosses a leg ℓ (two times of three, over 2ℓ/3) or a longest
// side (√2 ℓ/3), and each has an area of ℓ²/2: (4 + √2) / 9 · 2/ℓ of line per area.
#include <algorithm>

#include "core/expects.h"
#include "infill/cut.h"

namespace bead {
namespace {

constexpr int levels = 48;  // every second halves the legs
constexpr double size = 1 << (levels / 2);
// A place of the curve where no seam of large triangles is near: a third and a fifth of a leg.
constexpr Vec2 place{5592405, 3355443};
const double leg_per_spacing = (4 + std::numbers::sqrt2) / 9 * 2;

// Legs are counted from the place, along the curve's own axes.
class CrossCurve {
  public:
    explicit CrossCurve(const Box2& box) : box_(box) {}

    void visit(Vec2 entry, Vec2 right_angle, Vec2 exit, int level) {
        Box2 box;
        for (const Vec2 p : {entry, right_angle, exit}) box.include(p);
        if (box.low.x > box_.high.x || box.high.x < box_.low.x || box.low.y > box_.high.y ||
            box.high.y < box_.low.y)
            return;
        if (level == 0) return add((entry + right_angle + exit) / 3);
        const Vec2 middle = lerp(entry, exit, 0.5);
        visit(entry, middle, right_angle, level - 1);
        visit(right_angle, middle, exit, level - 1);
    }

    std::vector<Polyline> lines;

  private:
    void add(Vec2 centre) {
        const bool goes_on = !lines.empty() && distance(lines.back().back(), centre) < 0.7;
        if (!goes_on) lines.emplace_back();
        Polyline& line = lines.back();
        const std::size_t n = line.size();
        if (n >= 2 && std::abs(cross(line[n - 1] - line[n - 2], centre - line[n - 1])) < 1e-6)
            line.pop_back();
        line.push_back(centre);
    }

    Box2 box_;
};

}  // namespace

std::vector<Polyline> cross_curve(const Region& region, const FillOptions& options) {
    BEAD_EXPECTS(options.spacing > 0);
    if (region.empty()) return {};
    const double leg = leg_per_spacing * options.spacing;
    const Vec2 turn = leg * unit(options.angle), back = (1 / leg) * unit(-options.angle);
    Box2 box;  // of the region, in legs, with one leg around
    for (const Polygon& polygon : region)
        for (const Vec2 p : polygon.outer) box.include(rotated(p - options.centre, back));
    box.low = box.low - Vec2{1, 1};
    box.high = box.high + Vec2{1, 1};
    constexpr double reach = 3e6;  // legs
    BEAD_EXPECTS(std::max({-box.low.x, -box.low.y, box.high.x, box.high.y}) < reach);

    CrossCurve curve(box);
    curve.visit(Vec2{size, 0} - place, Vec2{0, 0} - place, Vec2{0, size} - place, levels);
    for (Polyline& part : curve.lines)
        for (Vec2& p : part) p = options.centre + rotated(p, turn);
    return cut_and_linked(curve.lines, region, options.link);
}

}  // namespace bead
