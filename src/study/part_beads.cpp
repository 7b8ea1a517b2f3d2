#include "study/part_beads.h"

#include <algorithm>
#include <numeric>

#include "geom/box.h"

namespace bead {
namespace {

constexpr double most_cells = 1500;  // along a side

bool may_be_part(const Path& path) {
    return path.role != Role::travel && path.role != Role::skirt && path.role != Role::support &&
           path.points.size() > 1;
}

Box2 covered_box(const Path& path) {
    Box2 box;
    const double half = spacing(path.bead) / 2;
    for (const Vec3& p : path.points) {
        box.include(flat(p) - Vec2{half, half});
        box.include(flat(p) + Vec2{half, half});
    }
    return box;
}

// Cells about as wide as a bead; those that a path runs through become one group.
class CellGroups {
  public:
    CellGroups(const Box2& box, double cell)
        : low_(box.low), cell_(cell), columns_(int(box.size().x / cell) + 3) {
        const int rows = int(box.size().y / cell) + 3;
        parent_.resize(std::size_t(columns_) * std::size_t(rows));
        std::iota(parent_.begin(), parent_.end(), std::size_t{0});
        used_.assign(parent_.size(), 0);
    }

    void follow(const Path& path) {
        for (std::size_t i = 1; i < path.points.size(); ++i) {
            const Vec2 from = flat(path.points[i - 1]), to = flat(path.points[i]);
            const int steps = 1 + int(2 * distance(from, to) / cell_);
            for (int k = 0; k <= steps; ++k) use(lerp(from, to, double(k) / steps));
        }
    }

    // Neighbouring cells join.
    void join_neighbours() {
        const auto columns = std::size_t(columns_);
        for (std::size_t c = 0; c < used_.size(); ++c) {
            if (used_[c] == 0) continue;
            for (const std::size_t next : {c + 1, c + columns - 1, c + columns, c + columns + 1})
                if (next < used_.size() && used_[next] != 0) parent_[root(next)] = root(c);
        }
    }

    std::size_t group_of(const Path& path) { return root(cell_at(flat(path.points.front()))); }

  private:
    [[nodiscard]] std::size_t cell_at(Vec2 p) const {
        const Vec2 at = (p - low_) / cell_;
        return std::size_t(int(at.y) + 1) * std::size_t(columns_) + std::size_t(int(at.x) + 1);
    }
    void use(Vec2 p) { used_[cell_at(p)] = 1; }
    std::size_t root(std::size_t c) {
        while (parent_[c] != c) c = parent_[c] = parent_[parent_[c]];
        return c;
    }

    Vec2 low_;
    double cell_;
    int columns_;
    std::vector<std::size_t> parent_;
    std::vector<char> used_;
};

// The box of the beads that hang together and weigh most.
Box2 heaviest_box(const std::vector<Toolpath>& layers) {
    const Box2 all = covered_box(layers);
    const double longest = std::max(all.size().x, all.size().y);
    CellGroups groups(all, std::max(mean_width(layers), longest / most_cells));
    for (const Toolpath& layer : layers)
        for (const Path& path : layer) groups.follow(path);
    groups.join_neighbours();
    std::vector<std::pair<std::size_t, double>> weights;
    for (const Toolpath& layer : layers)
        for (const Path& path : layer) weights.emplace_back(groups.group_of(path), volume(path));
    std::ranges::stable_sort(weights, {}, [](const auto& weight) { return weight.first; });
    std::size_t heaviest = 0;
    double most = -1, sum = 0;
    for (std::size_t i = 0; i < weights.size(); ++i) {
        sum = (i > 0 && weights[i].first == weights[i - 1].first ? sum : 0) + weights[i].second;
        if (sum > most) {
            most = sum;
            heaviest = weights[i].first;
        }
    }
    Box2 box;
    for (const Toolpath& layer : layers)
        for (const Path& path : layer)
            if (groups.group_of(path) == heaviest) box.include(covered_box(path));
    return box;
}

bool lies_within(const Box2& inner, const Box2& outer) {
    constexpr double touching = 1e-6;
    return inner.low.x >= outer.low.x - touching && inner.low.y >= outer.low.y - touching &&
           inner.high.x <= outer.high.x + touching && inner.high.y <= outer.high.y + touching;
}

}  // namespace

double mean_width(const std::vector<Toolpath>& layers) {
    double sum = 0, weights = 0;
    for (const Toolpath& layer : layers)
        for (const Path& path : layer) {
            sum += volume(path) * spacing(path.bead);
            weights += volume(path);
        }
    return weights > 0 ? sum / weights : 0;
}

Box2 covered_box(const std::vector<Toolpath>& layers) {
    Box2 box;
    for (const Toolpath& layer : layers)
        for (const Path& path : layer) box.include(covered_box(path));
    return box;
}

PartBeads part_beads(std::vector<Toolpath> layers) {
    PartBeads result;
    for (Toolpath& layer : layers)
        std::erase_if(layer, [](const Path& path) { return !may_be_part(path); });
    std::erase_if(layers, [](const Toolpath& layer) { return layer.empty(); });
    if (layers.empty()) return result;
    const Box2 part = heaviest_box(layers);
    for (Toolpath& layer : layers)
        std::erase_if(layer, [&](const Path& path) {
            if (lies_within(covered_box(path), part)) return false;
            result.left_out += volume(path);
            return true;
        });
    std::erase_if(layers, [](const Toolpath& layer) { return layer.empty(); });
    result.layers = std::move(layers);
    return result;
}

}  // namespace bead
