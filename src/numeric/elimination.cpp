#include "numeric/elimination.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>

namespace bead {
namespace {

constexpr std::size_t small = 1000;  // points of a part that is cut in the middle without a choice
constexpr std::size_t leaf = 20;     // points; fewer cost more in book-keeping than they save

// Where a point is during the recursion: in the part being cut, on its far side, or in no part any
// more because it is in a separator above.
enum Side : std::uint8_t { near, far, taken };

struct Part {
    std::vector<int> points, elements;
};

class Dissection {
  public:
    explicit Dissection(const ElementPattern& pattern)
        : pattern_(pattern), side_(pattern.places.size(), taken) {}

    // The fronts of the part, its root last. None of its points is on a side.
    int dissect(Part part, std::vector<Front>& fronts);

  private:
    [[nodiscard]] std::span<const int> points_of(int element) const {
        const auto count = std::size_t(pattern_.points_per_element);
        return std::span(pattern_.points).subspan(std::size_t(element) * count, count);
    }
    [[nodiscard]] float coordinate(int point, int axis) const {
        return pattern_.places[std::size_t(point)][std::size_t(axis)];
    }
    [[nodiscard]] int longest_axis(const Part& part) const;
    [[nodiscard]] std::vector<float> candidates(const Part& part, int axis) const;
    void cut(const Part& part, int axis);
    void divide(const Part& part, int axis, float at);
    [[nodiscard]] float smallest_cut(const Part& part, int axis,
                                     const std::vector<float>& places) const;
    std::vector<int> take_separator(const Part& part, std::array<Part, 2>& halves);

    const ElementPattern& pattern_;
    std::vector<std::uint8_t> side_;
};

int Dissection::longest_axis(const Part& part) const {
    std::array<float, 3> low, high;
    low.fill(std::numeric_limits<float>::max());
    high.fill(std::numeric_limits<float>::lowest());
    for (const int point : part.points)
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const float at = pattern_.places[std::size_t(point)][axis];
            low[axis] = std::min(low[axis], at);
            high[axis] = std::max(high[axis], at);
        }
    int longest = 0;
    for (int axis = 1; axis < 3; ++axis)
        if (high[std::size_t(axis)] - low[std::size_t(axis)] >
            high[std::size_t(longest)] - low[std::size_t(longest)])
            longest = axis;
    return longest;
}

// The median first, and two places beside it.
std::vector<float> Dissection::candidates(const Part& part, int axis) const {
    std::vector<float> at(part.points.size());
    std::ranges::transform(part.points, at.begin(),
                           [&](int point) { return coordinate(point, axis); });
    const auto place = [&](double share) {
        return at.begin() + std::ptrdiff_t(share * double(at.size()));
    };
    const auto middle = place(0.5), lower = place(0.42), upper = place(0.58);
    std::nth_element(at.begin(), middle, at.end());
    if (part.points.size() < small) return {*middle};
    std::nth_element(at.begin(), lower, middle);
    std::nth_element(middle + 1, upper, at.end());
    return {*middle, *lower, *upper};
}

// Near the median; where the part is thin, a cut beside it is smaller. Divides the part.
void Dissection::cut(const Part& part, int axis) {
    const std::vector<float> places = candidates(part, axis);
    divide(part, axis, places.front());
    if (places.size() == 1) return;
    const float best = smallest_cut(part, axis, places);
    if (best != places.front()) divide(part, axis, best);
}

void Dissection::divide(const Part& part, int axis, float at) {
    for (const int point : part.points)
        side_[std::size_t(point)] = coordinate(point, axis) < at ? near : far;
}

// The one that goes through the fewest elements; the first of several. The part is divided, no
// matter where.
float Dissection::smallest_cut(const Part& part, int axis, const std::vector<float>& places) const {
    std::vector<std::size_t> crossed(places.size(), 0);
    for (const int element : part.elements) {
        float low = std::numeric_limits<float>::max(), high = -low;
        for (const int point : points_of(element)) {
            if (side_[std::size_t(point)] == taken) continue;
            low = std::min(low, coordinate(point, axis));
            high = std::max(high, coordinate(point, axis));
        }
        for (std::size_t k = 0; k < places.size(); ++k)
            crossed[k] += low < places[k] && places[k] <= high;
    }
    return places[std::size_t(std::ranges::min_element(crossed) - crossed.begin())];
}

// The far points of elements that have points on both sides are taken out of both; what is left
// goes into the halves.
std::vector<int> Dissection::take_separator(const Part& part, std::array<Part, 2>& halves) {
    std::vector<int> separator;
    for (const int element : part.elements) {
        bool is_near = false, is_far = false;
        for (const int point : points_of(element)) {
            is_near |= side_[std::size_t(point)] == near;
            is_far |= side_[std::size_t(point)] == far;
        }
        if (is_near) halves[near].elements.push_back(element);
        if (is_far && !is_near) halves[far].elements.push_back(element);
        if (!is_near || !is_far) continue;
        for (const int point : points_of(element))
            if (side_[std::size_t(point)] == far) separator.push_back(point);
    }
    std::ranges::sort(separator);
    separator.erase(std::unique(separator.begin(), separator.end()), separator.end());
    for (const int point : separator) side_[std::size_t(point)] = taken;
    for (const int point : part.points)
        if (side_[std::size_t(point)] != taken)
            halves[side_[std::size_t(point)]].points.push_back(point);
    return separator;
}

int Dissection::dissect(Part part, std::vector<Front>& fronts) {
    Front root;
    std::vector<int> children;
    std::array<Part, 2> halves;
    if (part.points.size() > leaf) {
        const int axis = longest_axis(part);
        cut(part, axis);
        root.own = take_separator(part, halves);
    }
    // Elements that lie wholly between points of the separator stay with it.
    if (halves[0].points.empty() || halves[1].points.empty()) {
        root.own = part.points;
        for (Part& empty : halves) empty = {};
    }
    part = {};
    for (Part& piece : halves) {
        if (piece.points.empty()) continue;
        for (const int point : piece.points) side_[std::size_t(point)] = taken;
        children.push_back(dissect(std::move(piece), fronts));
    }
    const int place = int(fronts.size());
    for (const int child : children) fronts[std::size_t(child)].parent = place;
    root.children = int(children.size());
    fronts.push_back(std::move(root));
    return place;
}

// Which elements each front adds up and which points it hands on.
void complete(EliminationTree& tree) {
    const ElementPattern& pattern = tree.pattern;
    std::vector<int> order(pattern.places.size(), -1), front_of(pattern.places.size(), -1);
    int next = 0;
    for (std::size_t f = 0; f < tree.fronts.size(); ++f)
        for (const int point : tree.fronts[f].own) {
            order[std::size_t(point)] = next++;
            front_of[std::size_t(point)] = int(f);
        }
    const auto earlier = [&](int a, int b) {
        return order[std::size_t(a)] < order[std::size_t(b)];
    };
    const auto count = std::size_t(pattern.points_per_element);
    for (std::size_t e = 0; e * count < pattern.points.size(); ++e) {
        const auto points = std::span(pattern.points).subspan(e * count, count);
        const int first = *std::ranges::min_element(points, earlier);
        tree.fronts[std::size_t(front_of[std::size_t(first)])].elements.push_back(int(e));
    }
    std::vector<int> seen(pattern.places.size(), -1);
    for (std::size_t f = 0; f < tree.fronts.size(); ++f) {
        Front& front = tree.fronts[f];
        for (const int point : front.own) seen[std::size_t(point)] = int(f);
        const auto touch = [&](int point) {
            if (seen[std::size_t(point)] == int(f)) return;
            seen[std::size_t(point)] = int(f);
            front.border.push_back(point);
        };
        for (const int e : front.elements)
            for (const int point : std::span(pattern.points).subspan(std::size_t(e) * count, count))
                touch(point);
        for (std::size_t c = f, left = std::size_t(front.children); left > 0;) {
            --c;
            if (tree.fronts[c].parent != int(f)) continue;
            --left;
            std::ranges::for_each(tree.fronts[c].border, touch);
        }
        std::ranges::sort(front.border, earlier);
    }
}

}  // namespace

EliminationTree elimination_tree(ElementPattern pattern) {
    EliminationTree tree{std::move(pattern), {}};
    Part all;
    std::vector<std::uint8_t> used(tree.pattern.places.size(), 0);
    for (const int point : tree.pattern.points) used[std::size_t(point)] = 1;
    for (std::size_t i = 0; i < used.size(); ++i)
        if (used[i] != 0) all.points.push_back(int(i));
    const auto elements = tree.pattern.points.size() / std::size_t(tree.pattern.points_per_element);
    for (std::size_t e = 0; e < elements; ++e) all.elements.push_back(int(e));
    if (all.points.empty()) return tree;
    Dissection(tree.pattern).dissect(std::move(all), tree.fronts);
    complete(tree);
    return tree;
}

}  // namespace bead
