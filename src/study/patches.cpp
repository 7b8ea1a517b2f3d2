#include "study/patches.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "geom/clip.h"
#include "geom/line_index.h"
#include "geom/resample.h"

namespace bead {
namespace {

constexpr double around = 1;  // mm along a line over which the index is looked at
constexpr double shortest_way = 2, longest_way = 15;  // mm, either way from the hot spot
constexpr double beyond = 1;                          // mm more than is warm
constexpr int most_copies = 20;
constexpr double outward = 0.05;         // mm, where a copy's room is looked at
constexpr double room = 0.7;             // share of solid below which a copy has room
constexpr double inside_share = 0.9;     // of its points that must be inside
constexpr double shortest_patch = 1.5;   // mm
constexpr double hopeless = 0.985;       // of the highest index: a spot that must be patched
constexpr std::size_t looked_at = 4000;  // pixels

class Patcher {
  public:
    Patcher(const Layout& layout, const PixelModel& model, std::span<const double> index,
            const LoadCase& load_case, const PatchLineOptions& options)
        : model_(model),
          index_(index),
          options_(options),
          highest_(*std::ranges::max_element(index)),
          inside_(offset(load_case.part, -load_case.print.bead_width / 2 + 1e-4)),
          width_(load_case.print.bead_width),
          aside_(solid_pitch * width_) {
        for (const LayoutLine& line : layout) lines_.push_back(resampled(line.points, line_step));
    }

    std::optional<Layout> patches() const {
        const LineIndex nearest(lines_, 1.0);
        Layout found;
        std::vector<Vec2> spots;
        double used = 0;
        for (const std::size_t pixel : hot_pixels()) {
            const Vec2 spot = model_.grid.centre(pixel);
            const auto is_near = [&](Vec2 other) { return distance(other, spot) < options_.apart; };
            if (std::ranges::any_of(spots, is_near)) continue;
            if (spots.size() >= static_cast<std::size_t>(options_.most)) break;
            spots.push_back(spot);
            const auto line = nearest.nearest(spot, 2 * width_);
            const std::optional<Polyline> copy =
                line ? copy_of(warm_stretch(lines_[line->line], line->along),
                               spots.size() == 1 ? options_.place : 0)
                     : std::nullopt;
            if (!copy) {
                if (index_[pixel] > hopeless * highest_) return std::nullopt;
                continue;
            }
            found.push_back({LineKind::patch, *copy});
            used += length(*copy) * width_;
            if (used > options_.area) break;
        }
        if (found.empty()) return std::nullopt;
        return found;
    }

  private:
    std::vector<std::size_t> hot_pixels() const {
        std::vector<std::size_t> hot;
        for (std::size_t p = 0; p < index_.size(); ++p)
            if (index_[p] > options_.hot * highest_) hot.push_back(p);
        std::ranges::stable_sort(
            hot, [&](std::size_t a, std::size_t b) { return index_[a] > index_[b]; });
        if (hot.size() > looked_at) hot.resize(looked_at);
        return hot;
    }

    double index_at(Vec2 p) const {
        const std::optional<std::size_t> pixel = pixel_at(model_.grid, p);
        return pixel ? index_[*pixel] : 0;
    }

    Polyline warm_stretch(const Polyline& line, double along) const {
        const double step = length(line) / static_cast<double>(line.size() - 1);
        const auto at = static_cast<long>(std::lround(along / step));
        const long reach = std::lround(around / step), last = static_cast<long>(line.size()) - 1;
        const auto is_warm = [&](long i) {
            for (long k = std::max(i - reach, 0L); k <= std::min(i + reach, last); ++k)
                if (index_at(line[static_cast<std::size_t>(k)]) > options_.warm * highest_)
                    return true;
            return false;
        };
        const auto end = [&](long way) {
            long i = at;
            const auto gone = [&] { return static_cast<double>(std::abs(i - at)) * step; };
            while (i + way >= 0 && i + way <= last && gone() < longest_way &&
                   (gone() < shortest_way || is_warm(i + way)))
                i += way;
            return std::clamp(i + way * std::lround(beyond / step), 0L, last);
        };
        return {line.begin() + end(-1), line.begin() + end(1) + 1};
    }

    // Of the line, moved aside step by step until there is room, to the emptier side first;
    // `place` of those that are found so.
    std::optional<Polyline> copy_of(const Polyline& stretch, int place) const {
        if (stretch.size() < 6) return std::nullopt;
        int found = 0;
        for (int number = 1; number <= most_copies; ++number) {
            const double left = fullness(stretch, number, 1), right = fullness(stretch, number, -1);
            const double first = left <= right ? 1 : -1;
            for (const double side : {first, -first})
                if ((side > 0 ? left : right) < room && found++ == place)
                    return clipped(shifted_aside(stretch, side * number * aside_));
        }
        return std::nullopt;
    }

    // How much of a copy's outer side is solid already; 1 if the copy is not inside.
    double fullness(const Polyline& stretch, int number, double side) const {
        const double off = side * number * aside_;
        const Polyline copy = shifted_aside(stretch, off);
        if (share(copy, [&](Vec2 p) { return contains(inside_, p); }) < inside_share) return 1;
        return share(shifted_aside(stretch, off + side * outward), [&](Vec2 p) {
            const std::optional<std::size_t> pixel = pixel_at(model_.grid, p);
            return pixel && model_.factor[*pixel] > 0;
        });
    }

    template <class Test>
    static double share(const Polyline& line, const Test& test) {
        return static_cast<double>(std::ranges::count_if(line, test)) /
               static_cast<double>(line.size());
    }

    std::optional<Polyline> clipped(const Polyline& copy) const {
        Polyline longest;
        for (Polyline& part : inside_parts({copy}, inside_))
            if (length(part) > length(longest)) longest = std::move(part);
        if (length(longest) < shortest_patch) return std::nullopt;
        return smoothed(resampled(longest, line_step), 2);
    }

    const PixelModel& model_;
    std::span<const double> index_;
    const PatchLineOptions& options_;
    double highest_;
    Region inside_;
    double width_;
    double aside_;  // mm between copies
    std::vector<Polyline> lines_;
};

}  // namespace

std::optional<Layout> patch_lines(const Layout& layout, const PixelModel& model,
                                  std::span<const double> index, const LoadCase& load_case,
                                  const PatchLineOptions& options) {
    return Patcher(layout, model, index, load_case, options).patches();
}

}  // namespace bead
