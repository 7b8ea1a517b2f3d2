#include "infill/cut.h"

#include <algorithm>
#include <utility>

#include "infill/edge_bands.h"

namespace bead {
namespace {

constexpr double touch = 1e-9;      // mm, cuts this near to an end of an edge or piece count
constexpr double judgeable = 1e-7;  // mm, shorter bits say nothing about inside or outside

struct PieceCut {
    double along = 0;  // 0 … 1 of the piece
    EdgePlace place;
};

void append_cut(std::vector<PieceCut>& cuts, Vec2 a, Vec2 b, const Edge& edge) {
    const Vec2 piece = b - a, side = edge.b - edge.a;
    const double turn = cross(piece, side);
    if (turn == 0) return;  // what follows the edge is cut by the edges before and after
    const double along = cross(edge.a - a, side) / turn;
    const double on_edge = cross(edge.a - a, piece) / turn;
    const double slack = touch / length(piece), edge_slack = touch / length(side);
    if (along < -slack || along > 1 + slack) return;
    if (on_edge < -edge_slack || on_edge > 1 + edge_slack) return;
    cuts.push_back({std::clamp(along, 0.0, 1.0),
                    {edge.loop, edge.at + std::clamp(on_edge, 0.0, 1.0) * length(side)}});
}

// Where the edges cut the piece from a to b, in its direction.
void find_cuts(std::vector<PieceCut>& cuts, Vec2 a, Vec2 b, const EdgeBands& edges) {
    cuts.clear();
    const Vec2 slack{touch, touch};
    edges.for_each_near(Vec2{std::min(a.x, b.x), std::min(a.y, b.y)} - slack,
                        Vec2{std::max(a.x, b.x), std::max(a.y, b.y)} + slack,
                        [&](const Edge& edge) { append_cut(cuts, a, b, edge); });
    std::sort(cuts.begin(), cuts.end(),
              [](const PieceCut& p, const PieceCut& q) { return p.along < q.along; });
}

// Follows one curve and collects what lies inside.
class Cutter {
  public:
    explicit Cutter(const EdgeBands& edges) : edges_(edges) {}

    void follow(const Polyline& curve) {
        last_ = {};
        inside_ = false;
        unsure_ = true;
        std::vector<PieceCut> cuts;
        for (std::size_t i = 1; i < curve.size(); ++i) {
            const Vec2 a = curve[i - 1], b = curve[i];
            find_cuts(cuts, a, b, edges_);
            Vec2 from = a;
            for (const PieceCut& cut : cuts) {
                const Vec2 to = lerp(a, b, cut.along);
                pass(from, to);
                last_ = cut.place;
                unsure_ = true;
                from = to;
            }
            pass(from, b);
        }
        if (inside_) finish(unsure_ ? last_ : EdgePlace{});
    }

    std::vector<CutLine> lines;

  private:
    // A bit of the curve that no edge cuts.
    void pass(Vec2 from, Vec2 to) {
        if (unsure_) {
            if (distance(from, to) < judgeable) return;
            unsure_ = false;
            const bool now_inside = edges_.contains(lerp(from, to, 0.5));
            if (inside_ && !now_inside) finish(last_);
            if (!inside_ && now_inside) line_ = {{from}, last_, {}};
            inside_ = now_inside;
        }
        if (inside_) line_.points.push_back(to);
    }

    void finish(EdgePlace place) {
        line_.end = place;
        if (length(line_.points) >= shortest_line) lines.push_back(std::move(line_));
        line_ = {};
    }

    const EdgeBands& edges_;
    CutLine line_;
    EdgePlace last_;
    bool inside_ = false, unsure_ = true;
};

}  // namespace

std::vector<CutLine> cut_to(const std::vector<Polyline>& curves,
                            const std::vector<MeasuredLoop>& loops) {
    const EdgeBands edges(loops);
    Cutter cutter(edges);
    for (const Polyline& curve : curves) cutter.follow(curve);
    return std::move(cutter.lines);
}

std::vector<Polyline> cut_and_linked(const std::vector<Polyline>& curves, const Region& region,
                                     double longest_link) {
    const std::vector<MeasuredLoop> loops = measured_loops(region);
    return linked(cut_to(curves, loops), loops, longest_link);
}

}  // namespace bead
