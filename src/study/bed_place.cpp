#include "study/bed_place.h"

#include <algorithm>
#include <array>

#include "geom/along.h"
#include "geom/clip.h"
#include "geom/line_index.h"
#include "geom/resample.h"
#include "study/part_beads.h"

namespace bead {
namespace {

constexpr double scan_step = pi / 36;      // 5 degrees
constexpr double exact = pi / 180 / 1000;  // of a refined turn
constexpr std::size_t bead_samples = 3000, boundary_samples = 1000;
constexpr std::size_t layers_looked_at = 5;
constexpr double least_inside = 0.98;  // of the beads' samples
constexpr double least_walled = 0.95;  // of the boundary, if the print has walls
constexpr double beside = 1.5;         // bead widths from the boundary to its wall
constexpr double as_good = 0.1;        // of a bead's width: fits that do not differ

struct Placed {
    BedPlace place;
    double misfit = 0;  // mm
    double inside = 0;  // share of the beads
    double walled = 0;  // share of the boundary
    Vec2 box_off;       // mm, print's box less part's
};

// The print and the part, prepared for many tries.
class Matching {
  public:
    Matching(const std::vector<Toolpath>& layers, const Region& part)
        : part_(part),
          lines_(lines_of(layers)),
          beads_(lines_, reach()),
          width_(mean_width(layers)),
          has_walls_(names_walls(layers)) {
        for (const MeasuredLoop& loop : measured_loops(part)) {
            Polyline closed = loop.points;
            closed.push_back(closed.front());
            boundary_.push_back(closed);
        }
        const double step = std::max(0.1, perimeter(part) / double(boundary_samples));
        for (const Polyline& loop : boundary_)
            for (const Vec2 p : resampled(loop, step)) around_.push_back(p);
        const std::size_t every = 1 + bead_count() / bead_samples;
        std::size_t number = 0;
        for (const Polyline& line : lines_)
            for (const Vec2 p : line)
                if (number++ % every == 0) samples_.push_back(p);
        edge_.emplace(boundary_, reach());
    }

    [[nodiscard]] double width() const { return width_; }

    [[nodiscard]] Placed at(double turn, bool mirrored, std::optional<Vec2> origin) const {
        Placed placed{{turn, mirrored, {}}, 0, 0, 0, {}};
        Box2 box;
        for (const Polyline& line : lines_)
            for (const Vec2 p : line) box.include(in_case(placed.place, p));
        const Vec2 half{width_ / 2, width_ / 2};
        const Box2 wanted = bounds(part_);
        placed.box_off = box.size() + 2 * half - wanted.size();
        const Vec2 shift = wanted.centre() - box.centre();
        placed.place.origin = origin ? *origin : on_bed(placed.place, -shift);
        return placed;
    }

    void judge(Placed& placed) const {
        std::size_t inside = 0, walled = 0;
        double beyond = 0, gaps = 0;  // mm², sums of squares
        for (const Vec2 sample : samples_) {
            const double off = outside(in_case(placed.place, sample));
            if (off <= width_ / 2) ++inside;
            beyond += off * off;
        }
        for (const Vec2 p : around_) {
            const auto near = beads_.nearest(on_bed(placed.place, p), reach());
            const double gap = near ? near->distance : reach();
            if (gap <= beside * width_) ++walled;
            gaps += gap * gap;
        }
        placed.misfit = std::sqrt(beyond / double(samples_.size())) +
                        std::sqrt(gaps / double(around_.size())) +
                        0.5 * (std::abs(placed.box_off.x) + std::abs(placed.box_off.y));
        placed.inside = double(inside) / double(samples_.size());
        placed.walled = double(walled) / double(around_.size());
    }

    [[nodiscard]] bool is_fit(const Placed& placed) const {
        return std::abs(placed.box_off.x) <= width_ && std::abs(placed.box_off.y) <= width_ &&
               placed.inside >= least_inside && (!has_walls_ || placed.walled >= least_walled);
    }

  private:
    static Vec2 on_bed(const BedPlace& place, Vec2 p) {
        const Vec2 turned = rotated(place.mirrored ? Vec2{-p.x, p.y} : p, unit(place.turn));
        return turned + place.origin;
    }

    static bool names_walls(const std::vector<Toolpath>& layers) {
        return std::ranges::any_of(layers.front(), [](const Path& path) {
            return path.role == Role::outer_wall || path.role == Role::wall;
        });
    }

    // Of a few layers, with points close enough to stand for the lines.
    static std::vector<Polyline> lines_of(const std::vector<Toolpath>& layers) {
        std::vector<Polyline> lines;
        const std::size_t every = 1 + (layers.size() - 1) / layers_looked_at;
        for (std::size_t k = 0; k < layers.size(); k += every)
            for (const Path& path : layers[k]) {
                Polyline line;
                line.reserve(path.points.size());
                for (const Vec3& p : path.points) line.push_back(flat(p));
                lines.push_back(resampled(line, spacing(path.bead)));
            }
        return lines;
    }

    [[nodiscard]] double reach() const {
        const Vec2 size = bounds(part_).size();
        return 0.05 * std::max(size.x, size.y);
    }

    [[nodiscard]] std::size_t bead_count() const {
        std::size_t count = 0;
        for (const Polyline& line : lines_) count += line.size();
        return count;
    }

    [[nodiscard]] double outside(Vec2 p) const {
        if (contains(part_, p)) return 0;
        const auto near = edge_->nearest(p, reach());
        return near ? near->distance : reach();
    }

    const Region& part_;
    std::vector<Polyline> lines_;  // on the bed
    LineIndex beads_;
    double width_;
    bool has_walls_;
    std::vector<Polyline> boundary_;
    std::optional<LineIndex> edge_;
    std::vector<Vec2> samples_, around_;
};

using Best = std::optional<Placed>;

void keep_better(const Matching& match, Placed placed, Best& best) {
    match.judge(placed);
    if (!match.is_fit(placed)) return;
    if (!best || placed.misfit < best->misfit - as_good * match.width()) best = placed;
}

// The turn between two others at which the print fits best.
Placed refined(const Matching& match, double low, double high, bool mirrored,
               std::optional<Vec2> origin) {
    constexpr double golden = 0.6180339887498949;
    const auto tried = [&](double turn) {
        Placed placed = match.at(turn, mirrored, origin);
        match.judge(placed);
        return placed;
    };
    Placed left = tried(high - golden * (high - low)), right = tried(low + golden * (high - low));
    while (high - low > exact)
        if (left.misfit < right.misfit) {
            high = right.place.turn;
            right = left;
            left = tried(high - golden * (high - low));
        } else {
            low = left.place.turn;
            left = right;
            right = tried(low + golden * (high - low));
        }
    return left.misfit < right.misfit ? left : right;
}

// Users turn parts by whole degrees; if such a turn fits as well, it is the one.
Placed to_whole_degree(const Matching& match, const Placed& placed, std::optional<Vec2> origin) {
    constexpr double degree = pi / 180;
    const double whole = std::round(placed.place.turn / degree) * degree;
    Placed snapped = match.at(whole, placed.place.mirrored, origin);
    match.judge(snapped);
    return snapped.misfit < placed.misfit + as_good * match.width() ? snapped : placed;
}

// Where the boxes' sizes agree as well as so coarse a turn lets them.
Best among_all_turns(const Matching& match, const Region& part, bool mirrored,
                     std::optional<Vec2> origin) {
    const Vec2 size = bounds(part).size();
    const double near = match.width() + scan_step * std::max(size.x, size.y);
    Best best;
    for (int k = 0; k < 72; ++k) {
        const Placed coarse = match.at(k * scan_step, mirrored, origin);
        if (std::abs(coarse.box_off.x) > near || std::abs(coarse.box_off.y) > near) continue;
        const Placed fine =
            refined(match, (k - 1) * scan_step, (k + 1) * scan_step, mirrored, origin);
        keep_better(match, to_whole_degree(match, fine, origin), best);
    }
    return best;
}

}  // namespace

Vec2 in_case(const BedPlace& place, Vec2 on_bed) {
    const Vec2 turned = rotated(on_bed - place.origin, unit(-place.turn));
    return place.mirrored ? Vec2{-turned.x, turned.y} : turned;
}

std::vector<Toolpath> in_case(const BedPlace& place, std::vector<Toolpath> layers) {
    for (Toolpath& layer : layers)
        for (Path& path : layer)
            for (Vec3& p : path.points) p = at_height(in_case(place, flat(p)), p.z);
    return layers;
}

namespace {

Best place_on(const Region& part, const std::vector<Toolpath>& layers, const BedPlaceWish& wish) {
    const Matching match(layers, part);
    Best best;
    if (wish.turn) {
        keep_better(match, match.at(*wish.turn, false, wish.origin), best);
        return best;
    }
    for (const bool mirrored : {false, true}) {
        for (int quarter = 0; quarter < 4; ++quarter)
            keep_better(match, match.at(quarter * pi / 2, mirrored, wish.origin), best);
        if (!best) best = among_all_turns(match, part, mirrored, wish.origin);
        if (best) return best;
    }
    return best;
}

}  // namespace

std::optional<BedPlace> bed_place(const std::vector<Toolpath>& layers, const Region& part,
                                  const BedPlaceWish& wish) {
    if (const Best best = place_on(part, layers, wish)) return best->place;
    // What is thinner than a bead may be left out of a print.
    const Region printable = opened(part, 0.45 * mean_width(layers));
    if (printable.empty() || area(part) - area(printable) < mean_width(layers) * mean_width(layers))
        return std::nullopt;
    if (const Best best = place_on(printable, layers, wish)) return best->place;
    return std::nullopt;
}

}  // namespace bead
