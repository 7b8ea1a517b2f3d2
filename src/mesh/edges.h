// Who meets at the edges of a mesh: the sides of all triangles, ordered so that the sides along the
// same edge are neighbours. Triangles that have a point twice have no sides here: what they fill in
// is an edge already.
#pragma once
#include <span>
#include <vector>

#include "mesh/mesh.h"

namespace bead {

struct Side {
    int low = 0, high = 0;  // the edge's points, low < high
    int index = 0;          // 3 * triangle + corner where the side begins
    bool rising = false;    // runs from low to high
};

[[nodiscard]] inline bool is_collapsed(const std::array<int, 3>& t) {
    return t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
}

// Ordered by low, high and index. Linear in the size of the mesh.
std::vector<Side> sorted_sides(const Mesh& mesh);

// Calls visit(sides of one edge) for every edge in turn.
template <class Visit>
void for_each_edge(std::span<const Side> sides, Visit visit) {
    std::size_t begin = 0;
    while (begin < sides.size()) {
        std::size_t end = begin + 1;
        while (end < sides.size() && sides[end].low == sides[begin].low &&
               sides[end].high == sides[begin].high)
            ++end;
        visit(sides.subspan(begin, end - begin));
        begin = end;
    }
}

}  // namespace bead
