#include "infill/link.h"

#include <algorithm>
#include <limits>
#include <tuple>
#include <utility>

#include "geom/near_order.h"

namespace bead {
namespace {

// Line i has the ends 2 i (its start) and 2 i + 1.
constexpr std::size_t line_of(std::size_t end) { return end / 2; }
constexpr std::size_t other_end(std::size_t end) { return end ^ 1U; }

constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

struct Neighbour {
    std::size_t end = none;
    double way = std::numeric_limits<double>::infinity();  // mm along the edge
};

class Linker {
  public:
    Linker(const std::vector<CutLine>& lines, const std::vector<MeasuredLoop>& loops,
           double longest)
        : lines_(lines), loops_(loops), longest_(longest), used_(lines.size(), false) {
        ahead_.resize(2 * lines.size());
        behind_.resize(2 * lines.size());
        find_neighbours();
    }

    std::vector<Polyline> paths() {
        std::vector<Polyline> result;
        for (std::size_t i = 0; i < lines_.size(); ++i) {
            if (used_[i]) continue;
            used_[i] = true;
            Polyline path = lines_[i].points;
            go_on(path, 2 * i + 1);
            std::reverse(path.begin(), path.end());
            go_on(path, 2 * i);
            result.push_back(std::move(path));
        }
        return result;
    }

  private:
    [[nodiscard]] const EdgePlace& place(std::size_t end) const {
        return end % 2 == 0 ? lines_[line_of(end)].start : lines_[line_of(end)].end;
    }

    void find_neighbours() {
        std::vector<std::size_t> ends;
        for (std::size_t end = 0; end < 2 * lines_.size(); ++end)
            if (place(end).loop >= 0) ends.push_back(end);
        std::sort(ends.begin(), ends.end(), [&](std::size_t a, std::size_t b) {
            const EdgePlace &p = place(a), &q = place(b);
            return std::tie(p.loop, p.at, a) < std::tie(q.loop, q.at, b);
        });
        for (std::size_t first = 0, i = 0; i < ends.size(); ++i) {
            const int loop = place(ends[i]).loop;
            const bool last = i + 1 == ends.size() || place(ends[i + 1]).loop != loop;
            const std::size_t next = ends[last ? first : i + 1];
            const double way = place(next).at - place(ends[i]).at +
                               (last ? loops_[static_cast<std::size_t>(loop)].length : 0);
            ahead_[ends[i]] = {next, way};
            behind_[next] = {ends[i], way};
            if (last) first = i + 1;
        }
    }

    [[nodiscard]] bool can_take(const Neighbour& neighbour) const {
        return neighbour.way <= longest_ && !used_[line_of(neighbour.end)];
    }

    // Lengthens the path, which ends with `end`, by line after line until there is no neighbour.
    void go_on(Polyline& path, std::size_t end) {
        while (true) {
            const Neighbour &ahead = ahead_[end], &behind = behind_[end];
            const bool forward = can_take(ahead) && !(can_take(behind) && behind.way < ahead.way);
            if (!forward && !can_take(behind)) return;
            const std::size_t next = forward ? ahead.end : behind.end;
            append_way(path, end, next, forward);
            append_line(path, next);
            used_[line_of(next)] = true;
            end = other_end(next);
        }
    }

    void append_way(Polyline& path, std::size_t end, std::size_t next, bool forward) const {
        const MeasuredLoop& loop = loops_[static_cast<std::size_t>(place(end).loop)];
        if (forward) {
            const Polyline corners = way(loop, place(end).at, place(next).at);
            path.insert(path.end(), corners.begin(), corners.end());
        } else {
            const Polyline corners = way(loop, place(next).at, place(end).at);
            path.insert(path.end(), corners.rbegin(), corners.rend());
        }
    }

    void append_line(Polyline& path, std::size_t entry) const {
        const Polyline& points = lines_[line_of(entry)].points;
        if (entry % 2 == 0)
            path.insert(path.end(), points.begin(), points.end());
        else
            path.insert(path.end(), points.rbegin(), points.rend());
    }

    const std::vector<CutLine>& lines_;
    const std::vector<MeasuredLoop>& loops_;
    double longest_;
    std::vector<bool> used_;
    std::vector<Neighbour> ahead_, behind_;  // by end
};

}  // namespace

std::vector<Polyline> linked(const std::vector<CutLine>& lines,
                             const std::vector<MeasuredLoop>& loops, double longest) {
    std::vector<Polyline> paths = Linker(lines, loops, longest).paths();
    if (paths.empty()) return paths;
    const Vec2 start = paths.front().front();
    return near_order(std::move(paths), start);
}

}  // namespace bead
