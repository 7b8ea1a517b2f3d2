#include "study/path_figures.h"

#include <algorithm>
#include <cmath>

#include "geom/clip.h"
#include "smooth/lattice.h"
#include "vibration/piece.h"

namespace bead {
namespace {

constexpr double turning = pi / 4;      // rad
constexpr double turn_window = 1.5;     // mm
constexpr double straight = 1e-9;       // mm², twice a triple's area
constexpr double beyond = 0.6;          // mm outside the outline that are looked at
constexpr double stretch_length = 1.5;  // mm of a bead that are counted at once

// A bead counts once where its own stretches follow each other, but again where it comes back.
class Coats {
  public:
    Coats(const Region& region, double pitch)
        : lattice_(region, pitch), count_(lattice_.size()), last_(lattice_.size(), -10) {}

    void add(const Path& path) {
        next_ += 10;  // unlike any stretch before
        Polyline stretch;
        double way = 0;
        for (std::size_t i = 0; i < path.points.size(); ++i) {
            const Vec2 point = flat(path.points[i]);
            if (!stretch.empty()) way += distance(stretch.back(), point);
            stretch.push_back(point);
            if (way < stretch_length && i + 1 < path.points.size()) continue;
            lay(stretch, path.bead.width / 2);
            stretch = {point};
            way = 0;
        }
    }
    [[nodiscard]] std::size_t bare() const { return std::size_t(std::ranges::count(count_, 0)); }
    [[nodiscard]] std::size_t covered() const { return count_.size() - bare(); }
    [[nodiscard]] std::size_t again() const {
        std::size_t sum = 0;
        for (const int coats : count_) sum += std::size_t(std::max(0, coats - 1));
        return sum;
    }

  private:
    void lay(const Polyline& stretch, double reach) {
        ++next_;
        for (const NearPlace& near : lattice_.near(stretch, reach)) {
            if (last_[near.place] < next_ - 2) ++count_[near.place];
            last_[near.place] = next_;
        }
    }

    Lattice lattice_;
    std::vector<int> count_, last_;  // coats; number of the last stretch that reached there
    int next_ = 0;
};

bool deposits(const Path& path) { return path.role != Role::travel && path.points.size() > 1; }

double turn_at(const Piece& before, const Piece& after) {
    const Vec2 a = before.to - before.from, b = after.to - after.from;
    return std::atan2(cross(a, b), dot(a, b));
}

// The sagitta of the triple's first chord in the circle through the three points.
double chord_error(const Piece& before, const Piece& after) {
    const Vec2 a = before.to - before.from, b = after.to - after.from;
    const double twice_area = std::abs(cross(a, b));
    if (twice_area < straight) return 0;
    const double l = length(a);
    const double r = l * length(b) * length(a + b) / (2 * twice_area);
    return r - std::sqrt(std::max(0.0, r * r - l * l / 4));
}

int windowed_turns(const std::vector<Piece>& pieces) {
    int turns = 0;
    for (std::size_t i = 0; i + 1 < pieces.size();) {
        double turned = 0, way = 0;
        std::size_t k = i;
        for (; k + 1 < pieces.size() && way <= turn_window; ++k) {
            turned += turn_at(pieces[k], pieces[k + 1]);
            if (std::abs(turned) > turning) break;
            way += length(pieces[k + 1]);
        }
        const bool turns_here = k + 1 < pieces.size() && std::abs(turned) > turning;
        turns += turns_here;
        i = turns_here ? k + 1 : i + 1;
    }
    return turns;
}

}  // namespace

Coverage coverage(const Toolpath& layer, const Region& outline, double band, double pitch) {
    const Region inner = offset(outline, -band);
    Coats walls(difference(outline, inner), pitch), inside(outline, pitch);
    Coats outside(difference(offset(outline, beyond), outline), pitch);
    for (const Path& path : layer) {
        if (!deposits(path)) continue;
        walls.add(path);
        inside.add(path);
        outside.add(path);
    }
    const double cell = pitch * pitch;
    return {cell * double(walls.bare()), cell * double(inside.again()),
            cell * double(outside.covered())};
}

std::vector<Figure> path_figures(const Toolpath& layer) {
    double printed = 0, travel = 0, infill = 0, leading = 0;
    for (const Path& path : layer) {
        const double way = length(path);
        (deposits(path) ? printed : travel) += way;
        if (path.role == Role::infill) infill += way + leading;
        leading = deposits(path) ? 0 : leading + way;
    }
    constexpr double fast = 120;
    const std::vector<Piece> pieces = pieces_of(layer, fast);
    int turns = 0;
    double errors = 0;
    for (std::size_t i = 0; i + 1 < pieces.size(); ++i) {
        turns += std::abs(turn_at(pieces[i], pieces[i + 1])) > turning;
        errors += chord_error(pieces[i], pieces[i + 1]);
    }
    const double triples = std::max(1.0, double(pieces.size()) - 1);
    return {
        {"length, mm", printed + travel},     {"travel, mm", travel},
        {"infill with travel, mm", infill},   {"points", double(pieces.size() + 1)},
        {"turns 45°", double(turns)},         {"windowed turns", double(windowed_turns(pieces))},
        {"chord error, mm", errors / triples}};
}

std::vector<Figure> figures_of(const Coverage& c) {
    return {{underfill_name, c.under}, {overfill_name, c.over}, {"outside, mm²", c.outside}};
}

}  // namespace bead
