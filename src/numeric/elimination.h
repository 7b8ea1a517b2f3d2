// The order in which a large sparse system is eliminated, for a matrix that is a sum of small dense
// ones over the points of elements (finite elements). Nested dissection by coordinates (George
// 1973): a cut through the points' places separates two halves that know of each other only through
// the separator, which is eliminated last; so on down. What comes out is a tree of fronts: each
// eliminates its own points and hands the rest, its border, to its parent.
#pragma once
#include <array>
#include <vector>

namespace bead {

struct ElementPattern {
    int unknowns_per_point = 2;
    int points_per_element = 4;
    std::vector<std::array<float, 3>> places;  // of the points; any that tell near from far
    std::vector<int> points;                   // of the elements, one after another
};

struct Front {
    std::vector<int> own;       // points that are eliminated here
    std::vector<int> border;    // points that are touched here and eliminated later, in that order
    std::vector<int> elements;  // whose first eliminated point is one of the own
    int parent = -1;            // place in the tree; children come before parents
    int children = 0;
};

// Points of no element are in no front.
struct EliminationTree {
    ElementPattern pattern;
    std::vector<Front> fronts;
};

EliminationTree elimination_tree(ElementPattern pattern);

}  // namespace bead
