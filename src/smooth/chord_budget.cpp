#include "smooth/chord_budget.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace bead {
namespace {

struct Rung {
    double wall = 0.025, infill = 0.06;  // mm, chord from curve
    double frequency = 1;                // of the highest mode: how much of it is heeded
    double velocity_step = 14;           // mm/s, from chord to chord
    bool rounds_walls = true;
    bool fine_travel = true;
    bool fine_links = true;
    bool rounds_infill = true;
};

// From fine to coarse; the first with which the budget can be kept is taken. The last ones are for
// what has few points for its length, or real corners.
constexpr std::array<Rung, 13> rungs = [] {
    std::array<Rung, 13> steps;
    Rung step;
    std::size_t next = 0;
    const auto add = [&] { steps[next++] = step; };
    add();
    step.wall = 0.033, step.infill = 0.0825, add();
    step.frequency = 0.8, add();
    step.frequency = 0.65, step.rounds_walls = false, add();
    step.wall = 0.045, step.infill = 0.1125, step.frequency = 0.5, add();
    step.fine_travel = false, add();
    step.frequency = 0, add();
    step.infill = 0.2, add();
    step.infill = 0.4, add();
    step.fine_links = false, add();
    step.velocity_step = 20, add();
    step.velocity_step = 30, add();
    step.rounds_infill = false, add();
    return steps;
}();
constexpr double near_enough = 0.02;             // of the points, that may be left over
constexpr double far_off = 0.3;                  // of the points, that more are missing
constexpr double quietest = 20, loudest = 1000;  // mm/s²
constexpr double first_loudness = 100;           // mm/s², that is tried
constexpr double growth = 16;            // share of the points by which they grow with 1 / loudness
constexpr double corner_frequency = 30;  // Hz: chords of some 0.6 mm, passed at 20 mm/s
constexpr double most_braked = 6;        // times slower than asked, where two chords of a bend meet

// The louder chords may be, the more firmware may brake where they meet.
double braked(double loudness) {
    return std::pow(most_braked, std::log(loudness / quietest) / std::log(loudest / quietest));
}

ChordOptions chord_options(const SmoothOptions& options, const Rung& rung, double loudness) {
    ChordOptions chords;
    chords.wall = rung.wall;
    chords.infill = rung.infill;
    chords.frequency = rung.frequency * std::max(options.modes[0], options.modes[1]);
    chords.loudness = loudness;
    chords.acceleration = options.acceleration;
    if (!rung.fine_travel) {
        chords.travel = 0.4;
        chords.travel_turn = 50 * pi / 180;
    }
    chords.fine_links = rung.fine_links;
    chords.velocity_step = rung.velocity_step;
    if (options.stages.chords) {
        if (options.step) chords.step = braked(loudness) * *options.step;
        return chords;
    }
    chords.wall = chords.infill = chords.travel = 0.01;
    chords.quiet = std::numeric_limits<double>::infinity();
    return chords;
}

class Budget {
  public:
    Budget(const std::vector<LaidStroke>& strokes, const SmoothOptions& options, double most)
        : strokes_(strokes), options_(options), most_(most) {}

    [[nodiscard]] std::vector<ChordedStroke> chorded_strokes() {
        if (!options_.stages.chords) return made(rungs[0], quietest, 0);
        std::size_t rung = 0;
        Choice choice = quietest_of(heeded(rung), first_loudness);
        while (choice.spare < 0 && rung + 1 < rungs.size())
            choice = quietest_of(heeded(++rung), loudest);
        return made(heeded(rung), choice.loudness, options_.step ? choice.spare : 0);
    }

  private:
    struct Choice {
        double loudness, spare;  // mm/s²; points that it leaves, below 0: even this needs too many
    };

    // By secants in 1 / loudness, with which points grow about evenly, between what leaves some and
    // what needs too many.
    [[nodiscard]] Choice quietest_of(const Rung& rung, double first) {
        Choice best{loudest, -1};
        double low = 1 / loudest, high = 1 / quietest, next = 1 / first;
        double last = 0, was = 0, per_point = 1 / (growth * most_);
        for (int attempt = 0; attempt < 7; ++attempt) {
            const double left =
                points_left(rung, 1 / next, next > 1 / loudest ? far_off * most_ : 0);
            if (attempt > 0) per_point = (next - last) / (was - left);
            last = next;
            was = left;
            if (left >= 0) {
                best = {1 / next, left};
                low = next;
                if (left <= near_enough * most_ || next >= 1 / quietest) break;
            } else {
                high = next;
                if (next <= 1 / loudest) break;
            }
            const double margin = 0.1 * (high - low), aimed = near_enough / 2 * most_;
            next = best.spare < 0 ? 1 / loudest
                                  : std::clamp(last + (left - aimed) * per_point, low + margin,
                                               high < 1 / quietest ? high - margin : high);
        }
        return best;
    }

    // Firmware brakes between the few chords that a budget has for a rounded corner. Where they do
    // not lie above the modes only what is left rounds some corners, and finely.
    [[nodiscard]] Rung heeded(std::size_t i) const {
        Rung rung = rungs[i];
        const double mode = std::max(options_.modes[0], options_.modes[1]);
        if (options_.step && mode > corner_frequency)
            rung.rounds_walls = rung.rounds_infill = false;
        return rung;
    }

    // Below 0: there are too few. How many are missing is counted as far as `most_missing`.
    [[nodiscard]] double points_left(const Rung& rung, double loudness, double most_missing) {
        const ChordOptions chords = chord_options(options_, rung, loudness);
        double left = most_ - 1 - static_cast<double>(travel_points(rung.fine_travel));
        for (const LaidStroke& laid : strokes_) {
            left -= static_cast<double>(
                chord_count(laid.stroke(rung.rounds_walls, rung.rounds_infill), chords));
            if (left < -most_missing) break;
        }
        return left;
    }

    // Travel does not heed anything else that the rungs and the loudness are about.
    std::size_t travel_points(bool fine) {
        std::size_t& count = travel_[fine ? 1 : 0];
        if (count > 0) return count;
        const ChordOptions chords =
            chord_options(options_, fine ? rungs.front() : rungs.back(), loudest);
        for (const LaidStroke& laid : strokes_) count += chord_count(laid.travel, chords);
        return count;
    }

    // `left`: points that round strokes that the rung does not.
    [[nodiscard]] std::vector<ChordedStroke> made(const Rung& rung, double loudness,
                                                  double left) const {
        const ChordOptions chords = chord_options(options_, rung, loudness);
        std::vector<ChordedStroke> result;
        result.reserve(strokes_.size());
        for (const LaidStroke& laid : strokes_) {
            Ribbon stroke = chorded(laid.stroke(rung.rounds_walls, rung.rounds_infill), chords);
            if (left > 0 && !laid.plain.at.empty()) {
                const auto more = static_cast<double>(chord_count(laid.smooth, chords)) -
                                  static_cast<double>(stroke.flows.size());
                if (more <= left) {
                    left -= more;
                    stroke = chorded(laid.smooth, chords);
                }
            }
            result.push_back({chorded(laid.travel, chords), std::move(stroke)});
        }
        return result;
    }

    const std::vector<LaidStroke>& strokes_;
    const SmoothOptions& options_;
    double most_;
    std::array<std::size_t, 2> travel_{};
};

}  // namespace

// As quiet as the budget allows, by bisection; coarser where even the loudest has too many points.
std::vector<ChordedStroke> within_budget(const std::vector<LaidStroke>& strokes,
                                         const SmoothOptions& options, double most) {
    return Budget(strokes, options, most).chorded_strokes();
}

}  // namespace bead
