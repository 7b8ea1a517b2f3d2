#include "smooth/smooth.h"

#include <algorithm>

#include "smooth/bead_plan.h"
#include "smooth/chord_budget.h"
#include "smooth/layer_chains.h"
#include "smooth/order.h"
#include "smooth/round_corners.h"
#include "smooth/same_place.h"
#include "smooth/thinning.h"
#include "smooth/travel_kind.h"

namespace bead {
namespace {

constexpr double chords_leave = 0.75;  // of a wall's tolerance, for the blend that they cut
constexpr double edges_leave = 0.57;   // of an outer wall's, whose edge counts: round as a bead is
constexpr double least_speed = 9;      // mm/s; a corner that would be passed more slowly stays

std::size_t points_of(const Toolpath& layer) {
    std::size_t count = 0;
    for (const Path& path : layer) count += path.points.size();
    return count - std::min(count, layer.size() > 0 ? layer.size() - 1 : 0);
}

Path path_like(const Flow& flow, double factor, const Lane& lane) {
    Path path;
    path.role = flow.role;
    path.speed = flow.speed;
    path.acceleration = lane.acceleration;
    const double section = std::max(flow.section * factor, 1e-9);
    path.bead = {width_of(section, flow.height), flow.height};
    return path;
}

void append_stroke(Toolpath& path, const Ribbon& stroke, const Lane& lane, double target) {
    const double factor = target / volume(stroke);
    for (std::size_t i = 0; i < stroke.flows.size(); ++i) {
        Path next = path_like(stroke.flows[i], factor, lane);
        const bool begins = i == 0 || next.bead != path.back().bead ||
                            next.role != path.back().role || next.speed != path.back().speed;
        if (begins) {
            next.points.push_back(at_height(stroke.points[i], lane.z));
            path.push_back(std::move(next));
        }
        path.back().points.push_back(at_height(stroke.points[i + 1], lane.z));
    }
}

class Smoothing {
  public:
    Smoothing(const Toolpath& layer, std::vector<Lane> lanes, const SmoothOptions& options)
        : layer_(layer), lanes_(std::move(lanes)), options_(options), travel_(layer) {}

    SmoothedLayer result() {
        LayerChains found = layer_chains(lanes_, options_);
        chains_ = std::move(found.chains);
        const Path& first = layer_.front();
        const bool begins = first.role == Role::travel && !first.points.empty();
        start_ = begins ? flat(first.points.front()) : options_.start;
        const std::vector<LaidStroke> strokes = laid(order(found.phases));
        SmoothedLayer result;
        const double most = options_.point_budget * static_cast<double>(points_of(layer_));
        const std::vector<ChordedStroke> chords = within_budget(strokes, options_, most);
        for (std::size_t i = 0; i < strokes.size(); ++i) append(result.path, strokes[i], chords[i]);
        leave(result.path);
        result.chains = static_cast<int>(chains_.size());
        result.links = found.links;
        result.arcs = found.arcs;
        result.blends = blends_;
        result.kept = found.kept;
        return result;
    }

  private:
    std::vector<OrderedStroke> order(const std::vector<int>& phases) const {
        OrderOptions order;
        order.radius = options_.tolerances.travel;
        if (options_.retraction > 0) {
            order.retracted_from = travel_.shortest_retracted();
            order.retraction = options_.retraction;
        }
        order.effort = 30'000 + 30 * points_of(layer_);
        if (options_.stages.order) return ordered(chains_, phases, start_, order);
        std::vector<OrderedStroke> result;
        for (std::size_t i = 0; i < chains_.size(); ++i) result.push_back({i, 0});
        return result;
    }

    Ribbon travel_to(const StrokeEnd& from, const StrokeEnd& to) const {
        if (distance(from.at, to.at) <= same_place) return {};
        Ribbon travel;
        const Flow flow{0, 0, Role::travel, 0};
        for (const Vec2 point : way(from, to)) append_point(travel, point, flow);
        return travel;
    }

    // The nozzle stands while filament is pulled back: there is nothing to turn out of then.
    Polyline way(const StrokeEnd& from, const StrokeEnd& to) const {
        Polyline straight{from.at, to.at};
        const bool stops = options_.retraction > 0;
        if (!options_.stages.order || (stops && travel_.is_retracted(straight))) return straight;
        Polyline turned = travel_line(from, to, options_.tolerances.travel).points;
        return stops && travel_.is_retracted(turned) ? straight : turned;
    }

    std::vector<LaidStroke> laid(const std::vector<OrderedStroke>& order) {
        std::vector<LaidStroke> strokes;
        StrokeEnd here{start_, {1, 0}};
        for (const OrderedStroke& stroke : order) {
            const Chain& chain = chains_[stroke.chain];
            const Winding& winding = chain.windings[stroke.winding];
            const Vec2 way = winding.in.at - here.at;
            if (strokes.empty() && length(way) > same_place) here.along = way / length(way);
            LaidStroke laid{stroke.chain, measured(travel_to(here, winding.in)), {}, {}, false};
            round(laid, wound(chain, winding));
            here = winding.out;
            strokes.push_back(std::move(laid));
        }
        return strokes;
    }

    void round(LaidStroke& laid, Ribbon plain) {
        if (!options_.stages.blends || !lanes_[chains_[laid.chain].lanes[0]].level) {
            laid.smooth = measured(std::move(plain));
            return;
        }
        CornerTolerances tolerances{edges_leave * options_.tolerances.outer_wall,
                                    chords_leave * options_.tolerances.wall,
                                    options_.tolerances.infill, true};
        tolerances.sharpest = options_.acceleration / (least_speed * least_speed);
        RoundedRibbon round = rounded(plain, tolerances);
        laid.smooth = measured(std::move(round.ribbon));
        blends_ += round.blends;
        laid.infill = plain.flows.front().role == Role::infill;
        if (round.blends > 0) laid.plain = measured(std::move(plain));
    }

    void append(Toolpath& path, const LaidStroke& laid, const ChordedStroke& chords) const {
        const Chain& chain = chains_[laid.chain];
        const Lane& lane = lanes_[chain.lanes[0]];
        if (chords.travel.points.size() > 1)
            path.push_back(travel_.path_along(chords.travel.points, lane.z));
        if (!lane.level) {
            const auto first = layer_.begin() + static_cast<std::ptrdiff_t>(lane.first_path);
            path.insert(path.end(), first, first + static_cast<std::ptrdiff_t>(lane.paths));
            return;
        }
        double target = 0;
        for (const std::size_t i : chain.lanes) target += lanes_[i].volume;
        append_stroke(path, chords.stroke, lane, target);
    }

    // A layer that ends with travel still ends there.
    void leave(Toolpath& path) const {
        const Path& last = layer_.back();
        if (last.role != Role::travel || last.points.empty()) return;
        const Vec3 from = path.back().points.back(), to = last.points.back();
        if (length(to - from) <= same_place) return;
        Path leaving = last;
        leaving.points = {from, to};
        path.push_back(std::move(leaving));
    }

    const Toolpath& layer_;
    std::vector<Lane> lanes_;
    const SmoothOptions& options_;
    TravelKind travel_;
    std::vector<Chain> chains_;
    Vec2 start_;
    int blends_ = 0;
};

}  // namespace

SmoothedLayer smoothed(const Toolpath& layer, const SmoothOptions& options) {
    if (options.stages.bead_plan || options.stages.thinning) {
        SmoothOptions rest = options;
        rest.stages.bead_plan = rest.stages.thinning = false;
        Toolpath planned = options.stages.bead_plan ? bead_planned(layer) : layer;
        if (options.stages.thinning) planned = thinned(planned);
        // Fewer beads need fewer points; up to those given they may be spent on finer chords.
        const auto given = static_cast<double>(points_of(layer));
        const auto left = static_cast<double>(points_of(planned));
        if (left > 0) rest.point_budget = std::max(rest.point_budget, given / left);
        return smoothed(planned, rest);
    }
    std::vector<Lane> lanes = lanes_of(layer);
    if (lanes.empty()) return {.path = layer};
    if (options.stages.clean)
        for (Lane& lane : lanes)
            if (lane.level) lane = cleaned(std::move(lane));
    const double most = options.point_budget * static_cast<double>(points_of(layer));
    const auto is_affordable = [&](const SmoothedLayer& result) {
        return !options.stages.chords || static_cast<double>(points_of(result.path)) <= most;
    };
    SmoothedLayer linked = Smoothing(layer, lanes, options).result();
    if (is_affordable(linked)) return linked;
    // Few points and real corners: links cost more points than there are to spend.
    SmoothOptions unlinked = options;
    unlinked.stages.chains = false;
    SmoothedLayer plain = Smoothing(layer, lanes, unlinked).result();
    if (is_affordable(plain)) return plain;
    return {.path = layer, .kept = static_cast<int>(lanes.size())};
}

}  // namespace bead
