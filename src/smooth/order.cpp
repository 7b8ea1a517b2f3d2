#include "smooth/order.h"

#include <algorithm>
#include <limits>

#include "smooth/stroke_distances.h"

namespace bead {
namespace {

constexpr std::size_t few = 16;  // windings looked at while strokes are moved

struct Search {
    const std::vector<Chain>& chains;
    const OrderOptions& options;
    std::size_t left;  // comparisons
};

const Winding& winding_of(const Search& search, OrderedStroke stroke) {
    return search.chains[stroke.chain].windings[stroke.winding];
}

double cost(Search& search, OrderedStroke from, OrderedStroke to) {
    if (search.left > 0) --search.left;
    const StrokeEnd &out = winding_of(search, from).out, &in = winding_of(search, to).in;
    const double far = distance(out.at, in.at);
    if (far >= search.options.retracted_from) return far + search.options.retraction;
    return travel_cost(out, in, search.options.radius);
}

struct Reached {
    double cost;
    std::size_t winding;  // of the stroke
    std::size_t before;   // index of a winding that was looked at of the stroke before
};
using Column = std::vector<Reached>;  // rising in cost

Column column(const std::vector<std::size_t>& windings) {
    Column column;
    column.reserve(windings.size());
    for (const std::size_t i : windings) column.push_back({0, i, 0});
    return column;
}

// Each winding's cheapest way from those before; the ways that begin dearer are not looked at.
void reach(Search& search, const Column& before, std::size_t from, Column& here, std::size_t to) {
    std::vector<std::size_t> rising(before.size());
    for (std::size_t i = 0; i < rising.size(); ++i) rising[i] = i;
    std::ranges::sort(rising, {}, [&](std::size_t i) { return std::pair(before[i].cost, i); });
    for (Reached& state : here) {
        const Vec2 in = search.chains[to].windings[state.winding].in.at;
        double least = std::numeric_limits<double>::infinity();
        for (const std::size_t i : rising) {
            if (before[i].cost >= least) break;
            const Vec2 out = search.chains[from].windings[before[i].winding].out.at;
            if (before[i].cost + distance(out, in) >= least) continue;
            const double all =
                before[i].cost + cost(search, {from, before[i].winding}, {to, state.winding});
            if (all >= least) continue;
            least = all;
            state.before = i;
        }
        state.cost += least;
    }
}

std::vector<std::size_t> spread(const Chain& chain, std::size_t most) {
    std::vector<std::size_t> result;
    const std::size_t step = std::max<std::size_t>(1, chain.windings.size() / most);
    for (std::size_t i = 0; i < chain.windings.size(); i += step) result.push_back(i);
    return result;
}

// The windings near one, along the first loop both ways round, in both directions.
std::vector<std::size_t> around(const Chain& chain, std::size_t winding, std::size_t reach) {
    const std::size_t n = chain.windings.size();
    if (n <= few) return spread(chain, n);
    std::vector<std::size_t> result;
    for (std::size_t i = 0; i <= 2 * reach; ++i) result.push_back((winding + n + i - reach) % n);
    return result;
}

using Choices = std::vector<std::vector<std::size_t>>;

// The cheapest windings of all strokes, of those to choose from.
double choose(Search& search, std::vector<OrderedStroke>& strokes, Vec2 start,
              const Choices& choices) {
    std::vector<Column> columns;
    for (std::size_t i = 0; i < strokes.size(); ++i) {
        Column here = column(choices[i]);
        if (i == 0)
            for (Reached& state : here)
                state.cost +=
                    distance(start, search.chains[strokes[0].chain].windings[state.winding].in.at);
        else
            reach(search, columns.back(), strokes[i - 1].chain, here, strokes[i].chain);
        columns.push_back(std::move(here));
    }
    if (columns.empty()) return 0;
    const auto last = std::ranges::min_element(columns.back(), {}, &Reached::cost);
    auto state = static_cast<std::size_t>(last - columns.back().begin());
    for (std::size_t i = strokes.size(); i-- > 0;) {
        strokes[i].winding = columns[i][state].winding;
        state = columns[i][state].before;
    }
    return last->cost;
}

double choose_roughly(Search& search, std::vector<OrderedStroke>& strokes, Vec2 start) {
    Choices choices;
    for (const OrderedStroke& stroke : strokes)
        choices.push_back(spread(search.chains[stroke.chain], few));
    return choose(search, strokes, start, choices);
}

void choose_finely(Search& search, std::vector<OrderedStroke>& strokes, Vec2 start) {
    Choices choices;
    for (const OrderedStroke& stroke : strokes)
        choices.push_back(around(search.chains[stroke.chain], stroke.winding, 5));
    choose(search, strokes, start, choices);
}

// The cost of going on from position i - 1 to i with the windings chosen.
double step_cost(Search& search, const std::vector<OrderedStroke>& strokes, std::size_t i,
                 Vec2 start) {
    if (i >= strokes.size()) return 0;
    if (i == 0) return distance(start, winding_of(search, strokes[0]).in.at);
    return cost(search, strokes[i - 1], strokes[i]);
}

struct Insertion {
    double detour = std::numeric_limits<double>::infinity();
    std::size_t position = 0, winding = 0;
};

// The chain put before position i with its best winding, the others as they are.
Insertion inserted(Search& search, const std::vector<OrderedStroke>& strokes, std::size_t i,
                   std::size_t chain, double now, Vec2 start, double most) {
    Insertion best{most, i, 0};
    for (const std::size_t w : spread(search.chains[chain], few)) {
        const Winding& winding = search.chains[chain].windings[w];
        const Vec2 before = i > 0 ? winding_of(search, strokes[i - 1]).out.at : start;
        double detour = distance(before, winding.in.at) - now;
        if (i < strokes.size())
            detour += distance(winding.out.at, winding_of(search, strokes[i]).in.at);
        if (detour >= best.detour) continue;
        detour = -now;
        detour += i > 0 ? cost(search, strokes[i - 1], {chain, w}) : distance(start, winding.in.at);
        if (detour < best.detour && i < strokes.size())
            detour += cost(search, {chain, w}, strokes[i]);
        if (detour < best.detour) best = {detour, i, w};
    }
    return best;
}

// Each stroke taken out and put in where the detour is least, among the strokes of its phase.
bool moved(Search& search, std::vector<OrderedStroke>& strokes, const std::vector<int>& phases,
           Vec2 start) {
    bool better = false;
    for (std::size_t chain = 0; chain < search.chains.size() && search.left > 0; ++chain) {
        const auto at = std::ranges::find(strokes, chain, &OrderedStroke::chain);
        const auto i = static_cast<std::size_t>(at - strokes.begin());
        const OrderedStroke old = strokes[i];
        const double with =
            step_cost(search, strokes, i, start) + step_cost(search, strokes, i + 1, start);
        strokes.erase(at);
        const double gained = with - step_cost(search, strokes, i, start);
        Insertion best{gained - 1e-6, i, old.winding};
        for (std::size_t k = 0; k <= strokes.size(); ++k) {
            if (k > 0 && phases[strokes[k - 1].chain] > phases[chain]) break;
            if (k < strokes.size() && phases[strokes[k].chain] < phases[chain]) continue;
            const double now = step_cost(search, strokes, k, start);
            const Insertion here = inserted(search, strokes, k, chain, now, start, best.detour);
            if (here.detour < best.detour) best = here;
        }
        strokes.insert(strokes.begin() + static_cast<std::ptrdiff_t>(best.position),
                       {chain, best.winding});
        better = better || best.position != i || best.winding != old.winding;
    }
    return better;
}

std::vector<OrderedStroke> first_order(const std::vector<Chain>& chains,
                                       const std::vector<int>& phases, Vec2 start,
                                       const OrderOptions& options) {
    std::vector<OrderedStroke> strokes;
    for (std::size_t first = 0; first < chains.size();) {
        std::vector<std::size_t> phase;
        for (; first < chains.size() && (phase.empty() || phases[first] == phases[phase[0]]);
             ++first)
            phase.push_back(first);
        if (options.reorder && phase.size() <= options.most)
            phase = short_order(chains, phase, start);
        for (const std::size_t i : phase) strokes.push_back({i, 0});
        start = chains[phase.back()].windings[0].out.at;
    }
    return strokes;
}

}  // namespace

std::vector<OrderedStroke> ordered(const std::vector<Chain>& chains, const std::vector<int>& phases,
                                   Vec2 start, const OrderOptions& options) {
    std::vector<OrderedStroke> strokes = first_order(chains, phases, start, options);
    Search search{chains, options, options.effort};
    std::vector<OrderedStroke> best = strokes;
    double least = choose_roughly(search, best, start);
    strokes = best;
    constexpr int rounds = 6;
    for (int round = 0; options.reorder && chains.size() <= options.most && round < rounds;
         ++round) {
        if (search.left == 0 || !moved(search, strokes, phases, start)) break;
        const double now = choose_roughly(search, strokes, start);
        if (now >= least - 1e-6) break;
        least = now;
        best = strokes;
    }
    choose_finely(search, best, start);
    return best;
}

}  // namespace bead
