#include "smooth/infill_chain.h"

#include <algorithm>
#include <optional>

#include "smooth/link.h"
#include "smooth/neighbourhood.h"

namespace bead {
namespace {

constexpr double least_agreement = 0.7;     // cosine between neighbours where a link joins them
constexpr double farthest_neighbour = 1.3;  // spacings
constexpr std::size_t least_seams = 4;      // that a chain keeps

double gap_of(const Ring& ring, double most) { return std::min(most, 0.08 * ring.length); }

// One of the ways to wind a chain, as far as its last ring.
struct Step {
    Winding::Turn turn;
    std::size_t before = 0;  // index among the steps of the ring before
    StrokeEnd in, out;       // of its first ring; of its last
};

class ChainBuilder {
  public:
    ChainBuilder(std::vector<InfillRing> rings, const InfillSurroundings& surroundings,
                 const ChainOptions& options)
        : rings_(std::move(rings)),
          surroundings_(surroundings),
          options_(options),
          link_(std::min(6.0, 1.3 * surroundings.spacing)),
          neighbours_(neighbours(rings_, std::max(0.1, farthest_neighbour * surroundings.spacing))),
          used_(rings_.size(), false) {
        backward_.reserve(rings_.size());
        for (const InfillRing& ring : rings_) backward_.push_back(reversed(ring.ring));
    }

    std::vector<Chain> chains() {
        std::vector<Chain> chains;
        for (std::size_t first = 0; first < rings_.size(); ++first)
            if (!used_[first]) chains.push_back(chain_from(first));
        return chains;
    }

  private:
    static Neighbourhood neighbours(const std::vector<InfillRing>& rings, double reach) {
        std::vector<const Polyline*> loops;
        loops.reserve(rings.size());
        for (const InfillRing& ring : rings) loops.push_back(&ring.ring.points);
        return {loops, reach};
    }

    Chain chain_from(std::size_t first) {
        std::vector<std::size_t> way{first};
        std::vector<std::vector<Step>> steps{starts(first)};
        used_[first] = true;
        while (rings_[way.back()].ring.length >= 4 * link_) {
            Extension next = best_extension(way.back(), steps.back());
            if (next.steps.size() < least_seams) break;
            used_[next.ring] = true;
            way.push_back(next.ring);
            steps.push_back(std::move(next.steps));
        }
        return wound_along(way, steps);
    }

    [[nodiscard]] std::vector<Step> starts(std::size_t first) const {
        std::vector<Step> steps;
        for (const bool backward : {false, true}) {
            const Ring& ring = backward ? backward_[first] : rings_[first].ring;
            const double gap = gap_of(ring, options_.link);
            for (int i = 0; i < options_.seams; ++i) {
                const double seam = ring.length * i / options_.seams;
                steps.push_back(
                    {{backward, seam}, 0, end_at(ring, seam), end_at(ring, seam - gap)});
            }
        }
        return steps;
    }

    struct Extension {
        std::size_t ring = 0;
        std::vector<Step> steps;
    };

    [[nodiscard]] Extension best_extension(std::size_t last, const std::vector<Step>& steps) const {
        struct Near {
            std::size_t ring, step;
        };
        std::vector<Near> near;
        for (std::size_t i = 0; i < steps.size(); ++i)
            for (const std::uint32_t ring : neighbours_.around(steps[i].out.at))
                if (!used_[ring] && rings_[ring].ring.length >= 4 * link_)
                    near.push_back({ring, i});
        std::ranges::stable_sort(near, {}, &Near::ring);
        Extension best;
        for (auto it = near.begin(); it != near.end();) {
            const std::size_t ring = it->ring;
            const auto end = std::ranges::find_if(
                it, near.end(), [&](const Near& other) { return other.ring != ring; });
            std::vector<Step> longer;
            for (; it != end; ++it) {
                const auto left = static_cast<std::size_t>(end - it);
                if (longer.size() + left <= best.steps.size()) break;
                if (auto step = extended(last, steps, it->step, ring)) longer.push_back(*step);
            }
            it = end;
            if (longer.size() > best.steps.size()) best = {ring, std::move(longer)};
        }
        return best;
    }

    // One more ring, if a link from the end of the last one reaches it.
    [[nodiscard]] std::optional<Step> extended(std::size_t last, const std::vector<Step>& steps,
                                               std::size_t before, std::size_t next) const {
        const Step& step = steps[before];
        const Ring& ring = step.turn.backward ? backward_[last] : rings_[last].ring;
        const Ring& forward = rings_[next].ring;
        double there = nearest_place(forward, step.out.at);
        const RingSpot spot = spot_at(forward, there);
        if (distance(spot.point, step.out.at) > farthest_neighbour * surroundings_.spacing)
            return std::nullopt;
        const bool turned = dot(spot.along, step.out.along) < 0;
        if (turned) there = forward.length - there;
        const double leaves = step.turn.place + ring.length - gap_of(ring, options_.link);
        const Link link{&ring, turned ? &backward_[next] : &forward, leaves, there + link_, link_};
        if (!near_each_other(link) || !clear(link, rings_[last].lane, rings_[next].lane))
            return std::nullopt;
        return Step{{turned, link.lands},
                    before,
                    step.in,
                    end_at(*link.to, link.lands - gap_of(*link.to, options_.link))};
    }

    [[nodiscard]] bool near_each_other(const Link& link) const {
        for (const double t : {0.0, 0.5, 1.0}) {
            const RingSpot a = spot_at(*link.from, link.leaves + t * link.length);
            const RingSpot b = spot_at(*link.to, link.lands - (1 - t) * link.length);
            if (distance(a.point, b.point) > 1.5 * surroundings_.spacing) return false;
            if (dot(a.along, b.along) < least_agreement) return false;
        }
        return true;
    }

    [[nodiscard]] bool clear(const Link& link, std::size_t from, std::size_t to) const {
        for (int i = 1; i < 8; ++i)
            if (!surroundings_.grid.is_clear(point_at(link, i / 8.0), surroundings_.clearance,
                                             {from, to}))
                return false;
        return true;
    }

    Chain wound_along(const std::vector<std::size_t>& way,
                      const std::vector<std::vector<Step>>& steps) {
        Chain chain;
        chain.link = link_;
        chain.gap = options_.link;
        for (const std::size_t i : way) {
            chain.lanes.push_back(rings_[i].lane);
            chain.rings.push_back(std::move(rings_[i].ring));
            chain.backward.push_back(std::move(backward_[i]));
        }
        for (const Step& last : steps.back()) {
            Winding winding{std::vector<Winding::Turn>(way.size()), last.in, last.out};
            const Step* step = &last;
            for (std::size_t i = way.size(); i-- > 0;) {
                winding.turns[i] = step->turn;
                if (i > 0) step = &steps[i - 1][step->before];
            }
            chain.windings.push_back(std::move(winding));
        }
        return chain;
    }

    std::vector<InfillRing> rings_;
    std::vector<Ring> backward_;
    const InfillSurroundings& surroundings_;
    const ChainOptions& options_;
    double link_;  // mm
    Neighbourhood neighbours_;
    std::vector<bool> used_;
};

}  // namespace

std::vector<Chain> infill_chains(std::vector<InfillRing> rings,
                                 const InfillSurroundings& surroundings,
                                 const ChainOptions& options) {
    return ChainBuilder(std::move(rings), surroundings, options).chains();
}

Ribbon wound_infill(const Chain& chain, const Winding& winding) {
    Ribbon ribbon;
    for (std::size_t i = 0; i < chain.rings.size(); ++i) {
        const Ring& ring = ring_of(chain, winding, i);
        const double place = winding.turns[i].place;
        const double end = place + ring.length - gap_of(ring, chain.gap);
        append_way(ribbon, ring, place, end);
        if (i + 1 == chain.rings.size()) break;
        const Ring& next = ring_of(chain, winding, i + 1);
        const double lands = winding.turns[i + 1].place;
        append_link(ribbon, {&ring, &next, end, lands, chain.link}, flow_at(ring, end),
                    flow_at(next, lands));
    }
    return ribbon;
}

}  // namespace bead
