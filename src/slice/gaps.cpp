#include "slice/gaps.h"

#include <algorithm>
#include <tuple>

namespace bead {
namespace {

constexpr int none = -1;

struct Meeting {
    double distance = 0;
    int end = 0, start = 0;  // the line that ends here, the line that starts here
};

// Lines strung together. A string is known by its first line, which knows the last and vice versa.
class Strings {
  public:
    explicit Strings(const std::vector<Polyline>& lines)
        : lines_(lines), next_(lines.size(), none), previous_(lines.size(), none) {
        for (std::size_t i = 0; i < lines.size(); ++i) {
            first_.push_back(static_cast<int>(i));
            last_.push_back(static_cast<int>(i));
            length_.push_back(length(lines[i]));
        }
    }
    void join_within(double gap);
    [[nodiscard]] Joined result() const;

  private:
    [[nodiscard]] std::vector<Meeting> meetings(double gap) const;
    void join(const Meeting& meeting);
    [[nodiscard]] Polyline string_from(int first) const;

    const std::vector<Polyline>& lines_;
    std::vector<int> next_, previous_;
    std::vector<int> first_, last_;  // of a string, valid at its last and first line
    std::vector<double> length_;     // of a string, valid at its first line
};

std::size_t at(int i) { return static_cast<std::size_t>(i); }

// Pairs of a free end and a free start, found in a window that sweeps along x.
std::vector<Meeting> Strings::meetings(double gap) const {
    std::vector<int> ends;
    std::vector<int> starts;
    for (std::size_t i = 0; i < lines_.size(); ++i) {
        if (next_[i] == none) ends.push_back(static_cast<int>(i));
        if (previous_[i] == none) starts.push_back(static_cast<int>(i));
    }
    std::ranges::sort(ends, {}, [&](int i) { return lines_[at(i)].back().x; });
    std::ranges::sort(starts, {}, [&](int i) { return lines_[at(i)].front().x; });

    std::vector<Meeting> found;
    std::size_t window = 0;
    for (const int end : ends) {
        const Vec2 here = lines_[at(end)].back();
        while (window < starts.size() && lines_[at(starts[window])].front().x < here.x - gap)
            ++window;
        for (std::size_t i = window; i < starts.size(); ++i) {
            const Vec2 there = lines_[at(starts[i])].front();
            if (there.x > here.x + gap) break;
            const double apart = distance(here, there);
            if (apart <= gap) found.push_back({apart, end, starts[i]});
        }
    }
    std::ranges::sort(found, [](const Meeting& a, const Meeting& b) {
        return std::tie(a.distance, a.end, a.start) < std::tie(b.distance, b.end, b.start);
    });
    return found;
}

void Strings::join(const Meeting& meeting) {
    const auto [apart, end, start] = meeting;
    if (next_[at(end)] != none || previous_[at(start)] != none) return;
    const int first = first_[at(end)];
    if (first == start && apart >= length_[at(first)] / 2) return;
    next_[at(end)] = start;
    previous_[at(start)] = end;
    if (first == start) return;
    const int last = last_[at(start)];
    first_[at(last)] = first;
    last_[at(first)] = last;
    length_[at(first)] += apart + length_[at(start)];
}

void Strings::join_within(double gap) {
    for (const Meeting& meeting : meetings(gap)) join(meeting);
}

Polyline Strings::string_from(int first) const {
    Polyline line;
    int i = first;
    do {
        line.insert(line.end(), lines_[at(i)].begin(), lines_[at(i)].end());
        i = next_[at(i)];
    } while (i != none && i != first);
    return line;
}

Joined Strings::result() const {
    Joined result;
    std::vector<bool> used(lines_.size(), false);
    const auto take = [&](std::size_t first) {
        for (int i = static_cast<int>(first); i != none && !used[at(i)]; i = next_[at(i)])
            used[at(i)] = true;
        return string_from(static_cast<int>(first));
    };
    for (std::size_t i = 0; i < lines_.size(); ++i)
        if (previous_[i] == none) result.open.push_back(take(i));
    for (std::size_t i = 0; i < lines_.size(); ++i)
        if (!used[i]) result.loops.push_back(take(i));
    return result;
}

}  // namespace

// Widening the reach step by step joins the same pairs as the full reach at once would, but finds
// few candidates in each step, as most ends meet within rounding.
Joined joined(const std::vector<Polyline>& lines, double gap) {
    constexpr int steps = 10;
    constexpr double widening = 4;
    Strings strings(lines);
    double reach = gap / std::pow(widening, steps);
    for (int i = 0; i < steps; ++i, reach *= widening) strings.join_within(reach);
    strings.join_within(gap);
    return strings.result();
}

}  // namespace bead
