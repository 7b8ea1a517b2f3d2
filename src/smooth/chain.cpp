#include "smooth/chain.h"

#include <algorithm>

#include "core/expects.h"
#include "smooth/infill_chain.h"
#include "smooth/wall_chain.h"

namespace bead {

Chain line_chain(std::size_t lane, Ribbon line, bool reversible) {
    BEAD_EXPECTS(line.points.size() > 1);
    Chain chain;
    chain.lanes = {lane};
    chain.line = std::move(line);
    const Polyline& p = chain.line.points;
    const std::size_t n = p.size();
    const Vec2 first = (p[1] - p[0]) / distance(p[0], p[1]);
    const Vec2 last = (p[n - 1] - p[n - 2]) / distance(p[n - 1], p[n - 2]);
    chain.windings.push_back({{{false}}, {p[0], first}, {p[n - 1], last}});
    if (reversible) chain.windings.push_back({{{true}}, {p[n - 1], -last}, {p[0], -first}});
    return chain;
}

Ribbon wound(const Chain& chain, const Winding& winding) {
    if (!chain.rings.empty())
        return chain.walls ? wound_walls(chain, winding) : wound_infill(chain, winding);
    Ribbon line = chain.line;
    if (winding.turns[0].backward) {
        std::ranges::reverse(line.points);
        std::ranges::reverse(line.flows);
    }
    return line;
}

}  // namespace bead
