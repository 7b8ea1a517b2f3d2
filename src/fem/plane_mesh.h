// Meshes of plane elements, and the sides of them that lie on the part's boundary.
#pragma once
#include <functional>
#include <span>
#include <vector>

#include "fem/plane_element.h"

namespace bead {

// A side on the boundary: its two ends and, for elements of second order, its middle (else -1),
// counter-clockwise about the solid. Where on which loop it lies, mm (geom/along.h).
struct MeshSide {
    int begin = 0, end = 0, middle = -1;
    std::size_t loop = 0;
    double from = 0, to = 0;
};

struct PlaneMesh {
    PlaneElement kind = PlaneElement::t6;
    std::vector<Vec2> nodes;
    std::vector<int> elements;  // the nodes of one after another
    std::vector<MeshSide> sides;

    [[nodiscard]] std::size_t count() const {
        return elements.size() / std::size_t(nodes_of(kind));
    }
    [[nodiscard]] std::span<const int> element(std::size_t e) const {
        const auto n = std::size_t(nodes_of(kind));
        return std::span(elements).subspan(e * n, n);
    }
    // Where the element's nodes are, or what values they have.
    [[nodiscard]] std::array<Vec2, most_nodes> places(std::size_t e) const {
        std::array<Vec2, most_nodes> at{};
        const std::span<const int> n = element(e);
        for (std::size_t a = 0; a < n.size(); ++a) at[a] = nodes[std::size_t(n[a])];
        return at;
    }
};

// A square [0, 1]² of `columns` x `rows` elements put in shape by a map; its sides lie on one loop
// counted from (0, 0) counter-clockwise, 1 per side of the square. For tests and closed forms.
PlaneMesh structured_mesh(PlaneElement kind, int columns, int rows,
                          const std::function<Vec2(Vec2)>& map);

}  // namespace bead
