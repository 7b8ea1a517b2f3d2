#include "geom/near_order.h"

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <numeric>
#include <utility>

#include "core/expects.h"

namespace bead {
namespace {

struct End {
    Vec2 point;
    std::size_t line = 0;
    bool is_last = false;
};

// The ends of some lines in square cells, about one to a cell.
class EndGrid {
  public:
    EndGrid(const std::vector<Polyline>& lines, const std::vector<std::size_t>& some) {
        for (const std::size_t line : some) {
            box_.include(lines[line].front());
            box_.include(lines[line].back());
        }
        const Vec2 size = box_.size();
        const double ends = 2.0 * static_cast<double>(some.size());
        edge_ = std::max({std::sqrt(size.x * size.y / ends), (size.x + size.y) / ends, 1e-9});
        columns_ = static_cast<int>(size.x / edge_) + 1;
        rows_ = static_cast<int>(size.y / edge_) + 1;
        cells_.resize(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
        for (const std::size_t line : some) {
            add({lines[line].front(), line, false});
            add({lines[line].back(), line, true});
        }
    }

    // The nearest end, rings of cells from `from` outwards; ties go to the earlier line.
    [[nodiscard]] End nearest(Vec2 from) const {
        const auto [column, row] = cell_of(from);
        End best;
        double least = std::numeric_limits<double>::infinity();
        for (int ring = 0; ring <= std::max(columns_, rows_) && least > (ring - 1) * edge_; ++ring)
            for (int y = std::max(row - ring, 0); y <= std::min(row + ring, rows_ - 1); ++y) {
                const int step = std::abs(y - row) == ring ? 1 : std::max(2 * ring, 1);
                for (int x = column - ring; x <= column + ring; x += step)
                    if (x >= 0 && x < columns_) take_nearer(cell(x, y), from, best, least);
            }
        return best;
    }

    void remove(const Polyline& points, std::size_t line) {
        for (const Vec2 end : {points.front(), points.back()}) {
            const auto [column, row] = cell_of(end);
            std::erase_if(cell(column, row), [&](const End& e) { return e.line == line; });
        }
    }

  private:
    static void take_nearer(const std::vector<End>& ends, Vec2 from, End& best, double& least) {
        for (const End& end : ends) {
            const double far = distance(end.point, from);
            if (far > least || (far == least && end.line >= best.line)) continue;
            best = end;
            least = far;
        }
    }
    [[nodiscard]] std::pair<int, int> cell_of(Vec2 p) const {
        return {static_cast<int>(std::clamp((p.x - box_.low.x) / edge_, 0.0, columns_ - 1.0)),
                static_cast<int>(std::clamp((p.y - box_.low.y) / edge_, 0.0, rows_ - 1.0))};
    }
    [[nodiscard]] std::size_t index(int column, int row) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
               static_cast<std::size_t>(column);
    }
    std::vector<End>& cell(int column, int row) { return cells_[index(column, row)]; }
    [[nodiscard]] const std::vector<End>& cell(int column, int row) const {
        return cells_[index(column, row)];
    }
    void add(const End& end) {
        const auto [column, row] = cell_of(end.point);
        cell(column, row).push_back(end);
    }

    Box2 box_;
    double edge_ = 1;
    int columns_ = 1, rows_ = 1;
    std::vector<std::vector<End>> cells_;
};

}  // namespace

std::vector<Polyline> near_order(std::vector<Polyline> lines, Vec2 start) {
    for (const Polyline& line : lines) BEAD_EXPECTS(!line.empty());
    std::vector<Polyline> ordered;
    ordered.reserve(lines.size());
    std::vector<std::size_t> left(lines.size());
    std::iota(left.begin(), left.end(), std::size_t{0});
    // A grid that has lost half its lines is made anew: searches do not cross empty cells for long.
    while (!left.empty()) {
        EndGrid grid(lines, left);
        for (std::size_t count = (left.size() + 1) / 2; count > 0; --count) {
            const End end = grid.nearest(start);
            Polyline& line = lines[end.line];
            grid.remove(line, end.line);
            if (end.is_last) std::reverse(line.begin(), line.end());
            start = line.back();
            ordered.push_back(std::move(line));
            line.clear();
        }
        std::erase_if(left, [&](std::size_t line) { return lines[line].empty(); });
    }
    return ordered;
}

}  // namespace bead
