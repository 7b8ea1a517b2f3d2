// Hilbert's curve (D. Hilbert 1891) with cells of one spacing: each cell has one spacing of line in
// it. One curve of 2^24 × 2^24 cells lies fixed about the centre; only quarters that touch the
// region's box are visited. The centre is a third of the way across the curve, which is a third or
// two thirds of the way across every quarter around it, however small: no seam of the curve is
// near.
#include "core/expects.h"
#include "infill/cut.h"

namespace bead {
namespace {

constexpr int halvings = 24;
constexpr double third = 5592405;  // (2^24 - 1) / 3, in cells from the curve's corner

// Cells are counted from the centre, along the curve's own axes.
class HilbertCurve {
  public:
    explicit HilbertCurve(const Box2& box) : box_(box) {}

    // The square on `first` and `second` that starts at `corner`, entered there and left at
    // corner + first.
    void visit(Vec2 corner, Vec2 first, Vec2 second, int level) {
        const Vec2 far = corner + first + second;
        if (std::max(corner.x, far.x) < box_.low.x || std::min(corner.x, far.x) > box_.high.x ||
            std::max(corner.y, far.y) < box_.low.y || std::min(corner.y, far.y) > box_.high.y)
            return;
        if (level == 0) return add(0.5 * (corner + far));
        const Vec2 a = 0.5 * first, b = 0.5 * second;
        visit(corner, b, a, level - 1);
        visit(corner + b, a, b, level - 1);
        visit(corner + a + b, a, b, level - 1);
        visit(corner + first + b, -b, -a, level - 1);
    }

    std::vector<Polyline> lines;

  private:
    void add(Vec2 cell) {
        const bool goes_on = !lines.empty() && distance(lines.back().back(), cell) < 1.5;
        if (!goes_on) lines.emplace_back();
        Polyline& line = lines.back();
        const std::size_t n = line.size();
        if (n >= 2 && cross(line[n - 1] - line[n - 2], cell - line[n - 1]) == 0) line.pop_back();
        line.push_back(cell);
    }

    Box2 box_;
};

}  // namespace

std::vector<Polyline> hilbert(const Region& region, const FillOptions& options) {
    BEAD_EXPECTS(options.spacing > 0);
    if (region.empty()) return {};
    const Vec2 turn = options.spacing * unit(options.angle);
    const Vec2 back = (1 / options.spacing) * unit(-options.angle);
    Box2 box;  // of the region, in cells, with one cell around
    for (const Polygon& polygon : region)
        for (const Vec2 p : polygon.outer) box.include(rotated(p - options.centre, back));
    box.low = box.low - Vec2{1, 1};
    box.high = box.high + Vec2{1, 1};
    BEAD_EXPECTS(box.low.x > -third && box.low.y > -third && box.high.x < third &&
                 box.high.y < third);

    HilbertCurve curve(box);
    constexpr double size = 1 << halvings;
    curve.visit({-third, -third}, {size, 0}, {0, size}, halvings);
    for (Polyline& line : curve.lines)
        for (Vec2& p : line) p = options.centre + rotated(p, turn);
    return cut_and_linked(curve.lines, region, options.link);
}

}  // namespace bead
