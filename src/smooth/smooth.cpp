#include "smooth/smooth.h"

#include <algorithm>
#include <array>
#include <limits>

#include "smooth/bead_plan.h"
#include "smooth/chords.h"
#include "smooth/layer_chains.h"
#include "smooth/order.h"
#include "smooth/round_corners.h"
#include "smooth/thinning.h"

namespace bead {
namespace {

constexpr double same_place = 1e-6;    // mm
constexpr double chords_leave = 0.75;  // of a wall's tolerance, for the blend that they cut
constexpr double least_speed = 9;      // mm/s; a corner that would be passed more slowly stays

// What the layer's own travel is like.
struct TravelKind {
    double speed = 120, acceleration = 0;
    double retracted_from = std::numeric_limits<double>::infinity();  // mm
};

TravelKind travel_kind(const Toolpath& layer) {
    TravelKind kind;
    bool found = false;
    for (const Path& path : layer) {
        if (path.role != Role::travel || path.points.size() < 2) continue;
        if (!found) {
            kind.speed = path.speed;
            kind.acceleration = path.acceleration;
        }
        found = true;
        if (path.retracted) kind.retracted_from = std::min(kind.retracted_from, length(path));
    }
    return kind;
}

// A stroke with the travel that leads to it, dense.
struct Laid {
    std::size_t chain = 0;
    MeasuredRibbon travel;  // may be empty
    MeasuredRibbon smooth;  // corners rounded
    MeasuredRibbon plain;   // as wound; none of infill, whose corners are always rounded

    [[nodiscard]] const MeasuredRibbon& stroke(bool wall_blends) const {
        return wall_blends || plain.at.empty() ? smooth : plain;
    }
};

struct Rung {
    double wall = 0.025;  // mm, chord from curve
    bool wall_blends = true;
    double frequency = 1;  // of the highest mode: how much of it is heeded
};
// From fine to coarse; the first with which the budget can be kept is taken.
constexpr std::array rungs{Rung{0.025, true, 1}, Rung{0.033, true, 1}, Rung{0.033, true, 0.8},
                           Rung{0.033, false, 0.65}};
constexpr double quietest = 20, loudest = 1000;  // mm/s²
constexpr std::size_t few_points = 1000;         // below, coarse chords are not worth it

struct Emitted {
    Ribbon travel, stroke;
};

ChordOptions chord_options(const SmoothOptions& options, const Rung& rung, double loudness) {
    ChordOptions chords;
    chords.wall = rung.wall;
    chords.infill = std::max(0.06, 2.5 * rung.wall);
    chords.frequency = rung.frequency * std::max(options.modes[0], options.modes[1]);
    chords.loudness = loudness;
    chords.acceleration = options.acceleration;
    if (options.stages.chords) return chords;
    chords.wall = chords.infill = chords.travel = 0.01;
    chords.quiet = std::numeric_limits<double>::infinity();
    return chords;
}

std::vector<Emitted> emitted(const std::vector<Laid>& strokes, const SmoothOptions& options,
                             const Rung& rung, double loudness) {
    const ChordOptions chords = chord_options(options, rung, loudness);
    std::vector<Emitted> result;
    result.reserve(strokes.size());
    for (const Laid& laid : strokes)
        result.push_back(
            {chorded(laid.travel, chords), chorded(laid.stroke(rung.wall_blends), chords)});
    return result;
}

// Travel does not heed what the rungs and the loudness are about.
std::size_t travel_count(const std::vector<Laid>& strokes, const SmoothOptions& options) {
    const ChordOptions chords = chord_options(options, rungs[0], loudest);
    std::size_t count = 0;
    for (const Laid& laid : strokes) count += chord_count(laid.travel, chords);
    return count;
}

bool fits_into(double most, const std::vector<Laid>& strokes, const ChordOptions& chords,
               bool wall_blends) {
    std::size_t count = 1;
    for (const Laid& laid : strokes) {
        count += chord_count(laid.stroke(wall_blends), chords);
        if (static_cast<double>(count) > most) return false;
    }
    return true;
}

std::size_t points_of(const Toolpath& layer) {
    std::size_t count = 0;
    for (const Path& path : layer) count += path.points.size();
    return count - std::min(count, layer.size() > 0 ? layer.size() - 1 : 0);
}

// As quiet as the budget allows, by bisection; coarser where even the loudest has too many points.
std::vector<Emitted> within_budget(const std::vector<Laid>& strokes, const SmoothOptions& options,
                                   std::size_t given) {
    const double most = options.point_budget * static_cast<double>(given) -
                        static_cast<double>(travel_count(strokes, options));
    const auto fits = [&](const Rung& rung, double loudness) {
        return !options.stages.chords ||
               fits_into(most, strokes, chord_options(options, rung, loudness), rung.wall_blends);
    };
    if (fits(rungs[0], quietest)) return emitted(strokes, options, rungs[0], quietest);
    std::size_t rung = 0;
    const std::size_t last = given < few_points ? 0 : rungs.size() - 1;
    while (rung < last && !fits(rungs[rung], loudest)) ++rung;
    double low = quietest, high = loudest;
    for (int halving = 0; halving < 6; ++halving) {
        const double middle = std::sqrt(low * high);
        (fits(rungs[rung], middle) ? high : low) = middle;
    }
    return emitted(strokes, options, rungs[rung], high);
}

Path path_like(const Flow& flow, double factor, const Lane& lane) {
    Path path;
    path.role = flow.role;
    path.speed = flow.speed;
    path.acceleration = lane.acceleration;
    const double section = std::max(flow.section * factor, 1e-9);
    path.bead = {width_of(section, lane.height), lane.height};
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

void append_travel(Toolpath& path, const Ribbon& travel, const TravelKind& kind, double z) {
    if (travel.points.size() < 2) return;
    Path next;
    next.speed = kind.speed;
    next.acceleration = kind.acceleration;
    next.retracted = length(travel) >= kind.retracted_from;
    for (const Vec2 point : travel.points) next.points.push_back(at_height(point, z));
    path.push_back(std::move(next));
}

class Smoothing {
  public:
    Smoothing(const Toolpath& layer, std::vector<Lane> lanes, const SmoothOptions& options)
        : layer_(layer), lanes_(std::move(lanes)), options_(options), kind_(travel_kind(layer)) {}

    SmoothedLayer result() {
        LayerChains found = layer_chains(lanes_, options_);
        chains_ = std::move(found.chains);
        const Path& first = layer_.front();
        const bool begins = first.role == Role::travel && !first.points.empty();
        start_ = begins ? flat(first.points.front()) : options_.start;
        const std::vector<Laid> strokes = laid(order(found.phases));
        SmoothedLayer result;
        const std::vector<Emitted> chords = within_budget(strokes, options_, points_of(layer_));
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
        order.effort = 30'000 + 30 * points_of(layer_);
        if (options_.stages.order) return ordered(chains_, phases, start_, order);
        std::vector<OrderedStroke> result;
        for (std::size_t i = 0; i < chains_.size(); ++i) result.push_back({i, 0});
        return result;
    }

    Ribbon travel_to(const StrokeEnd& from, const StrokeEnd& to) const {
        if (distance(from.at, to.at) <= same_place) return {};
        Ribbon travel;
        const Flow flow{0, kind_.speed, Role::travel, 0};
        const TravelLine line = options_.stages.order
                                    ? travel_line(from, to, options_.tolerances.travel)
                                    : TravelLine{{from.at, to.at}, true};
        for (const Vec2 point : line.points) append_point(travel, point, flow);
        return travel;
    }

    std::vector<Laid> laid(const std::vector<OrderedStroke>& order) {
        std::vector<Laid> strokes;
        StrokeEnd here{start_, {1, 0}};
        for (const OrderedStroke& stroke : order) {
            const Chain& chain = chains_[stroke.chain];
            const Winding& winding = chain.windings[stroke.winding];
            const Vec2 way = winding.in.at - here.at;
            if (strokes.empty() && length(way) > same_place) here.along = way / length(way);
            Laid laid{stroke.chain, measured(travel_to(here, winding.in)), {}, {}};
            round(laid, wound(chain, winding));
            here = winding.out;
            strokes.push_back(std::move(laid));
        }
        return strokes;
    }

    void round(Laid& laid, Ribbon plain) {
        if (!options_.stages.blends || !lanes_[chains_[laid.chain].lanes[0]].level) {
            laid.smooth = measured(std::move(plain));
            return;
        }
        CornerTolerances tolerances{chords_leave * options_.tolerances.outer_wall,
                                    chords_leave * options_.tolerances.wall,
                                    options_.tolerances.infill, true};
        tolerances.sharpest = options_.acceleration / (least_speed * least_speed);
        RoundedRibbon round = rounded(plain, tolerances);
        laid.smooth = measured(std::move(round.ribbon));
        blends_ += round.blends;
        if (plain.flows.front().role != Role::infill) laid.plain = measured(std::move(plain));
    }

    void append(Toolpath& path, const Laid& laid, const Emitted& chords) const {
        const Chain& chain = chains_[laid.chain];
        const Lane& lane = lanes_[chain.lanes[0]];
        append_travel(path, chords.travel, kind_, lane.z);
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
    TravelKind kind_;
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
    return Smoothing(layer, std::move(lanes), options).result();
}

}  // namespace bead
