#include "fem/plane_mesh.h"

namespace bead {
namespace {

// Nodes lie on a lattice of half elements; those that the element kind does not use are left out.
class Lattice {
  public:
    Lattice(PlaneElement kind, int columns, int rows, const std::function<Vec2(Vec2)>& map)
        : columns_(columns), number_(std::size_t(2 * columns + 1) * std::size_t(2 * rows + 1), -1) {
        mesh.kind = kind;
        for (int j = 0; j <= 2 * rows; ++j)
            for (int i = 0; i <= 2 * columns; ++i) {
                if (kind == PlaneElement::q4 && (i % 2 != 0 || j % 2 != 0)) continue;
                if (kind == PlaneElement::q8 && i % 2 != 0 && j % 2 != 0) continue;
                number_[place(i, j)] = int(mesh.nodes.size());
                mesh.nodes.push_back(map({0.5 * i / columns, 0.5 * j / rows}));
            }
    }
    void add(std::initializer_list<std::pair<int, int>> nodes) {
        for (const auto& [i, j] : nodes) mesh.elements.push_back(number_[place(i, j)]);
    }
    void add_side(int i0, int j0, int i1, int j1, double from, double to) {
        const bool second = mesh.kind != PlaneElement::q4;
        mesh.sides.push_back({number_[place(i0, j0)], number_[place(i1, j1)],
                              second ? number_[place((i0 + i1) / 2, (j0 + j1) / 2)] : -1, 0, from,
                              to});
    }

    PlaneMesh mesh;

  private:
    [[nodiscard]] std::size_t place(int i, int j) const {
        return std::size_t(j) * std::size_t(2 * columns_ + 1) + std::size_t(i);
    }
    int columns_;
    std::vector<int> number_;
};

void add_cell(Lattice& lattice, int i, int j) {
    if (lattice.mesh.kind == PlaneElement::q4)
        return lattice.add({{i, j}, {i + 2, j}, {i + 2, j + 2}, {i, j + 2}});
    if (lattice.mesh.kind == PlaneElement::q8)
        return lattice.add({{i, j},
                            {i + 2, j},
                            {i + 2, j + 2},
                            {i, j + 2},
                            {i + 1, j},
                            {i + 2, j + 1},
                            {i + 1, j + 2},
                            {i, j + 1}});
    lattice.add({{i, j}, {i + 2, j}, {i + 2, j + 2}, {i + 1, j}, {i + 2, j + 1}, {i + 1, j + 1}});
    lattice.add({{i, j}, {i + 2, j + 2}, {i, j + 2}, {i + 1, j + 1}, {i + 1, j + 2}, {i, j + 1}});
}

}  // namespace

PlaneMesh structured_mesh(PlaneElement kind, int columns, int rows,
                          const std::function<Vec2(Vec2)>& map) {
    Lattice lattice(kind, columns, rows, map);
    for (int j = 0; j < 2 * rows; j += 2)
        for (int i = 0; i < 2 * columns; i += 2) add_cell(lattice, i, j);
    const int right = 2 * columns, top = 2 * rows;
    for (int i = 0; i < right; i += 2) {
        const double from = double(i) / right, to = double(i + 2) / right;
        lattice.add_side(i, 0, i + 2, 0, from, to);
        lattice.add_side(right - i, top, right - i - 2, top, 2 + from, 2 + to);
    }
    for (int j = 0; j < top; j += 2) {
        const double from = double(j) / top, to = double(j + 2) / top;
        lattice.add_side(right, j, right, j + 2, 1 + from, 1 + to);
        lattice.add_side(0, top - j, 0, top - j - 2, 3 + from, 3 + to);
    }
    return std::move(lattice.mesh);
}

}  // namespace bead
