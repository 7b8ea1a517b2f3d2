#include "infill/level_lines.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace bead {
namespace {

constexpr double full_turn = 2 * pi;
constexpr double closes = 1e-3;  // rad, by which a triangle's loop may fail to close

struct Crossing {
    double part = 0;  // of the edge
    int point = 0;
};
using EdgeKey = std::array<int, 2>;  // vertices, the lower first

class Levels {
  public:
    Levels(const StripeGrid& grid, std::span<const double> phase) : grid_(grid), phase_(phase) {
        for (const std::array<int, 3>& triangle : grid.triangles) cross(triangle);
    }

    std::vector<Polyline> chained() {
        std::vector<Polyline> lines;
        used_.assign(links_.size(), {false, false});
        for (std::size_t p = 0; p < links_.size(); ++p)
            if (links_[p][1] < 0) append_from(p, lines);
        for (std::size_t p = 0; p < links_.size(); ++p) append_from(p, lines);
        return lines;
    }

  private:
    double phase(int vertex) const { return phase_[static_cast<std::size_t>(vertex)]; }

    // What the phase does from i to j, in i's direction: the asked growth, corrected to what fits.
    PhaseStep grown(int i, int j) const {
        PhaseStep step = phase_step(grid_, i, j);
        const double there = step.flips ? -phase(j) : phase(j);
        step.growth += std::remainder(there - phase(i) - step.growth, full_turn);
        return step;
    }

    const std::vector<Crossing>& crossings(int i, int j) {
        const EdgeKey key{std::min(i, j), std::max(i, j)};
        const auto [found, is_new] = edges_.try_emplace(key);
        if (!is_new) return found->second;
        const double from = phase(key[0]) / full_turn,
                     to = from + grown(key[0], key[1]).growth / full_turn;
        const auto first = static_cast<long>(std::floor(std::min(from, to))) + 1;
        const auto last = static_cast<long>(std::ceil(std::max(from, to))) - 1;
        for (long level = first; level <= last; ++level) {
            const double part = (static_cast<double>(level) - from) / (to - from);
            found->second.push_back({part, static_cast<int>(points_.size())});
            points_.push_back(lerp(grid_.places[static_cast<std::size_t>(key[0])],
                                   grid_.places[static_cast<std::size_t>(key[1])], part));
            links_.push_back({-1, -1});
        }
        return found->second;
    }

    void cross(const std::array<int, 3>& t) {
        const PhaseStep one = grown(t[0], t[1]), two = grown(t[0], t[2]), on = grown(t[1], t[2]);
        const std::array<double, 3> f{phase(t[0]), phase(t[0]) + one.growth,
                                      phase(t[0]) + two.growth};
        if (std::abs(f[1] + (one.flips ? -on.growth : on.growth) - f[2]) > closes) return;
        std::map<long, std::vector<int>> at_level;
        for (std::size_t e = 0; e < 3; ++e) {
            const int i = t[e], j = t[(e + 1) % 3];
            const double from = i < j ? f[e] : f[(e + 1) % 3], to = i < j ? f[(e + 1) % 3] : f[e];
            for (const Crossing& crossing : crossings(i, j))
                at_level[std::lround((from + crossing.part * (to - from)) / full_turn)].push_back(
                    crossing.point);
        }
        for (const auto& [level, points] : at_level)
            if (points.size() == 2) link(points[0], points[1]);
    }

    void link(int a, int b) {
        const auto free_slot = [&](int p) -> int* {
            auto& slots = links_[static_cast<std::size_t>(p)];
            return slots[0] < 0 ? slots.data() : slots[1] < 0 ? slots.data() + 1 : nullptr;
        };
        int *const from = free_slot(a), *const to = free_slot(b);
        if (from == nullptr || to == nullptr) return;
        *from = b;
        *to = a;
    }

    void append_from(std::size_t start, std::vector<Polyline>& lines) {
        Polyline line{points_[start]};
        std::size_t at = start;
        while (true) {
            std::size_t slot = 0;
            while (slot < 2 && (links_[at][slot] < 0 || used_[at][slot])) ++slot;
            if (slot == 2) break;
            const auto next = static_cast<std::size_t>(links_[at][slot]);
            used_[at][slot] = true;
            used_[next][links_[next][0] == static_cast<int>(at) && !used_[next][0] ? 0 : 1] = true;
            line.push_back(points_[next]);
            at = next;
        }
        if (line.size() > 1) lines.push_back(std::move(line));
    }

    const StripeGrid& grid_;
    std::span<const double> phase_;
    std::map<EdgeKey, std::vector<Crossing>> edges_;
    std::vector<Vec2> points_;
    std::vector<std::array<int, 2>> links_;  // the one or two points next to each; -1: none
    std::vector<std::array<bool, 2>> used_;
};

}  // namespace

std::vector<Polyline> level_lines(const StripeGrid& grid, std::span<const double> phase) {
    return Levels(grid, phase).chained();
}

}  // namespace bead
