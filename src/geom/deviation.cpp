#include "geom/deviation.h"

#include <algorithm>
#include <limits>

#include "core/expects.h"

namespace bead {
namespace {

double box_distance(const Box2& box, Vec2 p) {
    return length(Vec2{std::max({box.low.x - p.x, 0.0, p.x - box.high.x}),
                       std::max({box.low.y - p.y, 0.0, p.y - box.high.y})});
}

// The line in pieces of a few segments, each in its box: what cannot be nearer is passed over.
// Begins with the piece that was nearest last time, for the next point is usually near it too.
class NearestPiece {
  public:
    explicit NearestPiece(const Polyline& line) : line_(line) {
        boxes_.resize(std::max<std::size_t>(1, (line.size() + per_piece - 2) / per_piece));
        for (std::size_t piece = 0; piece < boxes_.size(); ++piece)
            for (std::size_t i = piece * per_piece; i <= last(piece); ++i)
                boxes_[piece].include(line[i]);
    }

    double distance_to(Vec2 p) {
        double least = within(nearest_, p);
        for (std::size_t piece = 0; piece < boxes_.size(); ++piece) {
            if (box_distance(boxes_[piece], p) >= least) continue;
            const double here = within(piece, p);
            if (here >= least) continue;
            least = here;
            nearest_ = piece;
        }
        return least;
    }

  private:
    static constexpr std::size_t per_piece = 16;
    [[nodiscard]] std::size_t last(std::size_t piece) const {
        return std::min((piece + 1) * per_piece, line_.size() - 1);
    }
    [[nodiscard]] double within(std::size_t piece, Vec2 p) const {
        double least = distance(line_[piece * per_piece], p);
        for (std::size_t i = piece * per_piece; i < last(piece); ++i)
            least = std::min(least, segment_distance(line_[i], line_[i + 1], p));
        return least;
    }

    const Polyline& line_;
    std::vector<Box2> boxes_;
    std::size_t nearest_ = 0;
};

}  // namespace

double segment_distance(Vec2 a, Vec2 b, Vec2 point) {
    return std::sqrt(squared_segment_distance(a, b, point));
}

double line_distance(const Polyline& line, Vec2 point) {
    BEAD_EXPECTS(!line.empty());
    return NearestPiece(line).distance_to(point);
}

double deviation(const Polyline& line, const Polyline& reference, double step) {
    BEAD_EXPECTS(!line.empty() && !reference.empty() && step > 0);
    NearestPiece near(reference);
    double farthest = near.distance_to(line.front());
    for (std::size_t i = 1; i < line.size(); ++i) {
        const int parts =
            std::max(1, static_cast<int>(std::ceil(distance(line[i - 1], line[i]) / step)));
        for (int k = 1; k <= parts; ++k) {
            const Vec2 p = lerp(line[i - 1], line[i], static_cast<double>(k) / parts);
            farthest = std::max(farthest, near.distance_to(p));
        }
    }
    return farthest;
}

}  // namespace bead
