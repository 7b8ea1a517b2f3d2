#include "smooth/thinning.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <span>

#include "geom/clip.h"
#include "smooth/lattice.h"
#include "smooth/strokes.h"

namespace bead {
namespace {

constexpr double widest_void = 10;  // mm; places farther from any bead are nobody's business
constexpr double same_void = 1.01;  // a void that grows by no more counts as the same
constexpr float unreached = std::numeric_limits<float>::infinity();

Polyline flattened(const Path& path) {
    Polyline line;
    for (const Vec3& p : path.points) line.push_back(flat(p));
    return line;
}

Region inside_outer_walls(const Strokes& strokes) {
    std::vector<Polyline> outlines;
    for (const Stroke& stroke : strokes.strokes)
        if (stroke.path.role == Role::outer_wall && is_loop(stroke.path))
            outlines.push_back(loop_of(stroke.path));
    return region_of(outlines, FillRule::even_odd);
}

// G-code says beads in rounded lengths of filament.
bool alike(const Bead& a, const Bead& b) {
    return a.height == b.height && std::abs(a.width - b.width) <= 0.02 * b.width;
}

// The strokes that may go: all of the sparse infill, or none if it is not all loops of one bead.
std::vector<std::size_t> infill_loops(const Strokes& strokes) {
    std::vector<std::size_t> loops;
    for (std::size_t i = 0; i < strokes.strokes.size(); ++i) {
        const Path& path = strokes.strokes[i].path;
        if (path.role != Role::infill) continue;
        if (!is_loop(path)) return {};
        if (!loops.empty() && !alike(path.bead, strokes.strokes[loops.front()].path.bead))
            return {};
        loops.push_back(i);
    }
    return loops;
}

// Of every place, the distance to the nearest stroke but these.
std::vector<float> nearest_of(const Lattice& lattice, const Strokes& strokes,
                              std::span<const std::size_t> without, double reach) {
    std::vector<float> nearest(lattice.size(), unreached);
    for (std::size_t i = 0; i < strokes.strokes.size(); ++i)
        if (!std::ranges::binary_search(without, i))
            lattice.bring_near(nearest, flattened(strokes.strokes[i].path), reach);
    return nearest;
}

double void_radius_of(const Strokes& strokes, double pitch, double reach) {
    const Lattice lattice(inside_outer_walls(strokes), pitch);
    float radius = 0;
    for (const float away : nearest_of(lattice, strokes, {}, reach))
        if (away < unreached) radius = std::max(radius, away);
    return radius;
}

// Never less than the true void, and little more: distances change no faster than places.
double void_bound(const Strokes& strokes) {
    constexpr double coarse = 1;  // mm
    return std::min(widest_void, void_radius_of(strokes, coarse, widest_void) + coarse);
}

// How the places of a layer lie to those of its loops that are kept.
class LoopCoverage {
  public:
    LoopCoverage(const Strokes& strokes, std::span<const std::size_t> loops, double pitch,
                 double reach)
        : lattice_(inside_outer_walls(strokes), pitch),
          fixed_(nearest_of(lattice_, strokes, loops, reach)),
          kept_(loops.size(), true) {
        for (const std::size_t stroke : loops)
            near_.push_back(lattice_.near(flattened(strokes.strokes[stroke].path), reach));
        sort_by_place();
        two_.resize(lattice_.size());
        for (std::uint32_t place = 0; place < lattice_.size(); ++place) look_again(place);
    }

    [[nodiscard]] double void_radius() const {
        float radius = 0;
        for (const Two& two : two_)
            if (two.nearest < unreached) radius = std::max(radius, two.nearest);
        return radius;
    }

    // How much worse its places are off without the loop; nothing if one would be out of reach.
    [[nodiscard]] std::optional<double> loss_without(std::size_t loop, double reach) const {
        const double free = 0.75 * reach;  // mm, no loss up to here
        const auto worse = [&](double away) { return std::pow(std::max(0.0, away - free), 2); };
        double loss = 0;
        for (const NearPlace& near : near_[loop]) {
            const Two& two = two_[near.place];
            if (two.loop != static_cast<int>(loop)) continue;
            if (two.next > std::max(static_cast<float>(reach), near.distance)) return std::nullopt;
            loss += worse(two.next) - worse(near.distance);
        }
        return loss;
    }

    void leave_out(std::size_t loop) {
        kept_[loop] = false;
        for (const NearPlace& near : near_[loop]) look_again(near.place);
    }

  private:
    struct Two {
        float nearest = unreached, next = unreached;
        int loop = -1;  // that is nearest; -1: something that stays anyway
    };
    struct Entry {
        std::uint32_t loop;
        float distance;
    };

    void sort_by_place() {
        begin_.assign(lattice_.size() + 1, 0);
        for (const auto& places : near_)
            for (const NearPlace& near : places) ++begin_[near.place + 1];
        for (std::size_t i = 1; i < begin_.size(); ++i) begin_[i] += begin_[i - 1];
        entries_.resize(begin_.back());
        std::vector<std::size_t> next(begin_.begin(), begin_.end() - 1);
        for (std::uint32_t loop = 0; loop < near_.size(); ++loop)
            for (const NearPlace& near : near_[loop])
                entries_[next[near.place]++] = {loop, near.distance};
    }

    void look_again(std::uint32_t place) {
        Two two{fixed_[place], unreached, -1};
        for (std::size_t i = begin_[place]; i < begin_[place + 1]; ++i) {
            const Entry& entry = entries_[i];
            if (!kept_[entry.loop]) continue;
            if (entry.distance < two.nearest)
                two = {entry.distance, two.nearest, static_cast<int>(entry.loop)};
            else
                two.next = std::min(two.next, entry.distance);
        }
        two_[place] = two;
    }

    Lattice lattice_;
    std::vector<float> fixed_;
    std::vector<bool> kept_;
    std::vector<std::vector<NearPlace>> near_;  // of every loop
    std::vector<std::size_t> begin_;            // of every place's part of `entries_`
    std::vector<Entry> entries_;
    std::vector<Two> two_;
};

double section_of(const std::vector<Path>& paths, const std::vector<bool>& kept) {
    double all = 0, left = 0;
    for (std::size_t i = 0; i < paths.size(); ++i) {
        all += volume(paths[i]);
        if (kept[i]) left += length(paths[i]);
    }
    return all / left;
}

struct ThinningLimits {
    double reach = 0;         // mm
    double most_section = 0;  // mm²
};

// What goes next: the loop whose places are least worse off per mm, or simply the longest.
enum class Rule { least_loss, longest };

std::optional<std::size_t> next_to_go(const LoopCoverage& coverage, const std::vector<Path>& paths,
                                      const std::vector<bool>& kept, const ThinningLimits& limits,
                                      Rule rule) {
    std::optional<std::size_t> best;
    double least = 0;
    for (std::size_t loop = 0; loop < paths.size(); ++loop) {
        if (!kept[loop]) continue;
        std::vector<bool> rest = kept;
        rest[loop] = false;
        if (section_of(paths, rest) > limits.most_section) continue;
        const std::optional<double> loss = coverage.loss_without(loop, limits.reach);
        if (!loss) continue;
        const double saved = length(paths[loop]);
        const double cost = rule == Rule::longest ? -saved : *loss / saved;
        if (best && cost >= least) continue;
        least = cost;
        best = loop;
    }
    return best;
}

std::vector<bool> kept_by(Rule rule, LoopCoverage coverage, const std::vector<Path>& paths,
                          const ThinningLimits& limits) {
    std::vector<bool> kept(paths.size(), true);
    while (const auto loop = next_to_go(coverage, paths, kept, limits, rule)) {
        coverage.leave_out(*loop);
        kept[*loop] = false;
    }
    return kept;
}

}  // namespace

double void_radius(const Toolpath& layer, double pitch) {
    const Strokes strokes = strokes_of(layer);
    return void_radius_of(strokes, pitch, void_bound(strokes));
}

Toolpath thinned(const Toolpath& layer, const ThinningOptions& options) {
    Strokes strokes = strokes_of(layer);
    const std::vector<std::size_t> loops = infill_loops(strokes);
    if (loops.size() < 2) return joined(std::move(strokes));
    std::vector<Path> paths;
    paths.reserve(loops.size());
    for (const std::size_t stroke : loops) paths.push_back(strokes.strokes[stroke].path);
    const Bead bead = paths.front().bead;
    if (bead.height <= 0 || bead.width <= 0) return joined(std::move(strokes));

    const LoopCoverage coverage(strokes, loops, options.pitch,
                                std::max(options.void_radius, void_bound(strokes)));
    const ThinningLimits limits{
        options.void_radius > 0 ? options.void_radius : same_void * coverage.void_radius(),
        options.widest * options.nozzle * bead.height + 1e-9};
    std::vector<bool> kept = kept_by(Rule::least_loss, coverage, paths, limits);
    const std::vector<bool> other = kept_by(Rule::longest, coverage, paths, limits);
    if (section_of(paths, other) > section_of(paths, kept)) kept = other;
    if (std::ranges::count(kept, false) == 0) return joined(std::move(strokes));
    const double wide = section_of(paths, kept);
    for (std::size_t i = 0; i < loops.size(); ++i) {
        Path& path = strokes.strokes[loops[i]].path;
        if (!kept[i]) path.points.clear();
        path.bead.width = width_for(wide, bead.height);
        path.speed = std::min(path.speed, options.max_flow / wide);
    }
    std::erase_if(strokes.strokes, [](const Stroke& s) { return s.path.points.empty(); });
    return joined(std::move(strokes));
}

}  // namespace bead
