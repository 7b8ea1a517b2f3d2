#include "smooth/stroke_distances.h"

#include <algorithm>
#include <limits>

namespace bead {
namespace {

using Order = std::vector<std::size_t>;  // of 0 … n - 1

// Between any two strokes, and in the last row from the start.
class Distances {
  public:
    Distances(const std::vector<Chain>& chains, const std::vector<std::size_t>& strokes, Vec2 start)
        : count_(strokes.size()), values_((count_ + 1) * count_) {
        const std::size_t samples = count_ > 150 ? 8 : 16;
        std::vector<Polyline> places;
        for (const std::size_t stroke : strokes) {
            const std::vector<Winding>& windings = chains[stroke].windings;
            const std::size_t step = std::max<std::size_t>(1, windings.size() / samples);
            places.emplace_back();
            for (std::size_t i = 0; i < windings.size(); i += step)
                places.back().push_back(windings[i].in.at);
        }
        places.push_back({start});
        for (std::size_t i = 0; i <= count_; ++i)
            for (std::size_t k = 0; k < std::min(i, count_); ++k) {
                double least = std::numeric_limits<double>::infinity();
                for (const Vec2 a : places[i])
                    for (const Vec2 b : places[k]) least = std::min(least, dot(b - a, b - a));
                values_[i * count_ + k] = std::sqrt(least);
                if (i < count_) values_[k * count_ + i] = values_[i * count_ + k];
            }
    }
    [[nodiscard]] std::size_t count() const { return count_; }
    // From the stroke before position i of an order; there is none after the last.
    [[nodiscard]] double before(const Order& order, std::size_t i, std::size_t stroke) const {
        return values_[(i == 0 ? count_ : order[i - 1]) * count_ + stroke];
    }
    [[nodiscard]] double after(const Order& order, std::size_t i, std::size_t stroke) const {
        return i + 1 < order.size() ? values_[stroke * count_ + order[i + 1]] : 0;
    }

  private:
    std::size_t count_;
    std::vector<double> values_;
};

Order nearest_first(const Distances& distances) {
    Order order, left;
    for (std::size_t i = 0; i < distances.count(); ++i) left.push_back(i);
    while (!left.empty()) {
        const auto next = std::ranges::min_element(left, {}, [&](std::size_t stroke) {
            return distances.before(order, order.size(), stroke);
        });
        order.push_back(*next);
        left.erase(next);
    }
    return order;
}

// A stretch of the order turned round where that is shorter.
bool reversals(Order& order, const Distances& d) {
    bool better = false;
    for (std::size_t i = 0; i + 1 < order.size(); ++i)
        for (std::size_t k = i + 1; k < order.size(); ++k) {
            const double now = d.before(order, i, order[i]) + d.after(order, k, order[k]);
            const double then = d.before(order, i, order[k]) + d.after(order, k, order[i]);
            if (then >= now - 1e-9) continue;
            std::reverse(order.begin() + static_cast<std::ptrdiff_t>(i),
                         order.begin() + static_cast<std::ptrdiff_t>(k) + 1);
            better = true;
        }
    return better;
}

// Single strokes moved to where they are less of a detour.
bool moves(Order& order, const Distances& d) {
    bool better = false;
    for (std::size_t i = 0; i < order.size(); ++i) {
        const std::size_t stroke = order[i];
        Order rest = order;
        rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(i));
        const auto detour = [&](std::size_t k) {  // put before position k of the rest
            const double old = k < rest.size() ? d.before(rest, k, rest[k]) : 0;
            const double out = k < rest.size() ? d.after(rest, k - 1, stroke) : 0;
            return d.before(rest, k, stroke) + out - old;
        };
        const auto at = [&](std::size_t k) {
            // `after` counts from a position; before the first there is none
            return k == 0 && !rest.empty()
                       ? d.before(rest, 0, stroke) + d.before({stroke}, 1, rest[0]) -
                             d.before(rest, 0, rest[0])
                       : detour(k);
        };
        std::size_t best = i;
        double least = at(i) - 1e-9;
        for (std::size_t k = 0; k <= rest.size(); ++k)
            if (k != i && at(k) < least) {
                least = at(k);
                best = k;
            }
        if (best == i) continue;
        rest.insert(rest.begin() + static_cast<std::ptrdiff_t>(best), stroke);
        order = std::move(rest);
        better = true;
    }
    return better;
}

}  // namespace

std::vector<std::size_t> short_order(const std::vector<Chain>& chains,
                                     const std::vector<std::size_t>& strokes, Vec2 start) {
    const Distances distances(chains, strokes, start);
    Order order = nearest_first(distances);
    constexpr int rounds = 8;
    for (int round = 0; round < rounds; ++round) {
        const bool turned = reversals(order, distances);
        if (!moves(order, distances) && !turned) break;
    }
    std::vector<std::size_t> result;
    for (const std::size_t i : order) result.push_back(strokes[i]);
    return result;
}

}  // namespace bead
