#include "fem/region_mesh.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "fem/boundary_points.h"
#include "geom/delaunay.h"

namespace bead {
namespace {

using Triangles = std::vector<std::array<int, 3>>;

constexpr int smoothings = 8;
constexpr int most_repairs = 25;
constexpr double half_level =
    1.189207115002721;               // 2^(1/4); lattices are a factor of its square apart
constexpr double degenerate = 1e-5;  // area of a triangle, of its longest side's square

// Points by the square cell that they lie in.
class Bins {
  public:
    Bins(const Box2& box, double cell)
        : low_(box.low),
          cell_(std::max(cell, std::max(box.size().x, box.size().y) / 2000)),
          columns_(int(box.size().x / cell_) + 1),
          cells_(std::size_t(columns_) * std::size_t(int(box.size().y / cell_) + 1)) {}

    void add(Vec2 p) { cells_[index(column(p), row(p))].push_back(p); }
    [[nodiscard]] bool has_near(Vec2 p, double far) const {
        const int reach = int(std::ceil(far / cell_));
        const int rows = int(cells_.size()) / columns_;
        for (int j = std::max(0, row(p) - reach); j <= std::min(rows - 1, row(p) + reach); ++j)
            for (int i = std::max(0, column(p) - reach);
                 i <= std::min(columns_ - 1, column(p) + reach); ++i)
                for (const Vec2 q : cells_[index(i, j)])
                    if (distance(p, q) < far) return true;
        return false;
    }

  private:
    [[nodiscard]] int column(Vec2 p) const { return int((p.x - low_.x) / cell_); }
    [[nodiscard]] int row(Vec2 p) const { return int((p.y - low_.y) / cell_); }
    [[nodiscard]] std::size_t index(int i, int j) const {
        return std::size_t(j) * std::size_t(columns_) + std::size_t(i);
    }
    Vec2 low_;
    double cell_;
    int columns_;
    std::vector<std::vector<Vec2>> cells_;
};

class Mesher {
  public:
    Mesher(Boundary boundary, const SizeField& sizes, const MeshSizes& wanted)
        : boundary_(std::move(boundary)),
          most_sides_(4 * boundary_.sides.size() + 1000),
          sizes_(sizes),
          wanted_(wanted) {}

    std::optional<PlaneMesh> mesh();

  private:
    void fill();
    void fill_level(double spacing, Bins& taken);
    void fill_block(const Box2& block, double spacing, Bins& taken);
    void smooth();
    bool repair();
    // Sides that are halved again and again are too short for the triangulation's grid.
    [[nodiscard]] bool is_endless() const;
    void triangulate();
    [[nodiscard]] Vec2 at(int i) const {
        return std::size_t(i) < boundary_.points.size()
                   ? boundary_.points[std::size_t(i)].place
                   : inner_[std::size_t(i) - boundary_.points.size()];
    }
    [[nodiscard]] bool is_boundary(int i) const { return std::size_t(i) < boundary_.points.size(); }
    [[nodiscard]] bool is_clear_of_boundary(Vec2 p, double far) const;
    [[nodiscard]] PlaneMesh second_order() const;

    Boundary boundary_;
    std::size_t most_sides_;
    const SizeField& sizes_;
    MeshSizes wanted_;
    Region outline_;
    std::vector<Vec2> inner_;
    Triangles triangles_;
};

// Away from the boundary, and outside the circles over its sides, which keeps the sides Delaunay.
bool Mesher::is_clear_of_boundary(Vec2 p, double far) const {
    for (const auto& [a, b] : boundary_.sides) {
        const Vec2 from = at(a), to = at(b);
        const double reach = std::max(far, 0.5 * distance(from, to));
        if (std::abs(p.x - from.x) > 3 * reach || std::abs(p.y - from.y) > 3 * reach) continue;
        if (distance(p, 0.5 * (from + to)) < 0.55 * distance(from, to)) return false;
        const Vec2 side = to - from;
        const double t = std::clamp(dot(p - from, side) / dot(side, side), 0.0, 1.0);
        if (distance(p, from + t * side) < far) return false;
    }
    return true;
}

// The lattice is looked at block by block, for most of the part wants another level's spacing.
void Mesher::fill_level(double spacing, Bins& taken) {
    const Box2 box = bounds(outline_);
    const double block = std::max(wanted_.size, 4 * spacing);
    const double spread = wanted_.growth * block;
    for (double y = box.low.y; y < box.high.y; y += block)
        for (double x = box.low.x; x < box.high.x; x += block) {
            const double size = sizes_.at({x + block / 2, y + block / 2});
            if (size + spread < spacing / half_level || size - spread >= spacing * half_level)
                continue;
            fill_block({{x, y}, {std::min(x + block, box.high.x), std::min(y + block, box.high.y)}},
                       spacing, taken);
        }
}

void Mesher::fill_block(const Box2& block, double spacing, Bins& taken) {
    const Vec2 origin = bounds(outline_).low;
    const double step = std::sqrt(0.75) * spacing;
    const auto first = [](double from, double pitch) { return long(std::ceil(from / pitch)); };
    for (long j = std::max(1L, first(block.low.y - origin.y, step));
         origin.y + double(j) * step < block.high.y; ++j) {
        const double shift = origin.x + (j % 2 == 1 ? 0.5 : 1.0) * spacing;
        for (long i = std::max(0L, first(block.low.x - shift, spacing));
             shift + double(i) * spacing < block.high.x; ++i) {
            const Vec2 p{shift + double(i) * spacing, origin.y + double(j) * step};
            const double size = sizes_.at(p);
            if (size < spacing / half_level || size >= spacing * half_level) continue;
            if (!contains(outline_, p) || taken.has_near(p, 0.7 * size)) continue;
            if (!is_clear_of_boundary(p, 0.55 * size)) continue;
            taken.add(p);
            inner_.push_back(p);
        }
    }
}

void Mesher::fill() {
    outline_ = boundary_.region();
    Bins taken(bounds(outline_), wanted_.size / 2);
    for (double spacing = wanted_.size; spacing * half_level > sizes_.least();
         spacing /= half_level * half_level)
        fill_level(spacing, taken);
}

void Mesher::triangulate() {
    std::vector<Vec2> points;
    for (const BoundaryPoint& p : boundary_.points) points.push_back(p.place);
    points.insert(points.end(), inner_.begin(), inner_.end());
    triangles_.clear();
    for (const std::array<int, 3>& t : delaunay(points)) {
        const Vec2 a = at(t[0]), b = at(t[1]), c = at(t[2]);
        const double longest = std::max({distance(a, b), distance(b, c), distance(c, a)});
        if (cross(b - a, c - a) < degenerate * longest * longest) continue;
        const bool on_boundary = is_boundary(t[0]) && is_boundary(t[1]) && is_boundary(t[2]);
        if (on_boundary && !contains(outline_, 1.0 / 3 * (a + b + c))) continue;
        triangles_.push_back(t);
    }
}

// Every inner point goes to the middle of the triangles around it, weighted by how many elements of
// the wanted size they hold.
void Mesher::smooth() {
    std::vector<Vec2> sum(inner_.size());
    std::vector<double> weight(inner_.size(), 0.0);
    const int first = int(boundary_.points.size());
    for (const std::array<int, 3>& t : triangles_) {
        const Vec2 a = at(t[0]), b = at(t[1]), c = at(t[2]);
        const Vec2 centre = 1.0 / 3 * (a + b + c);
        const double size = sizes_.at(centre);
        const double w = cross(b - a, c - a) / (size * size);
        for (const int corner : t)
            if (corner >= first) {
                sum[std::size_t(corner - first)] = sum[std::size_t(corner - first)] + w * centre;
                weight[std::size_t(corner - first)] += w;
            }
    }
    for (std::size_t i = 0; i < inner_.size(); ++i) {
        if (!(weight[i] > 0)) continue;
        const Vec2 to = sum[i] / weight[i];
        if (is_clear_of_boundary(to, 0.5 * sizes_.at(to))) inner_[i] = to;
    }
}

bool Mesher::is_endless() const { return boundary_.sides.size() > most_sides_; }

// Halves the sides of the boundary that are no triangle's side; true if there were none.
bool Mesher::repair() {
    std::set<std::pair<int, int>> edges;
    for (const std::array<int, 3>& t : triangles_)
        for (std::size_t k = 0; k < 3; ++k) edges.emplace(t[k], t[(k + 1) % 3]);
    std::vector<std::size_t> missing;
    for (std::size_t s = 0; s < boundary_.sides.size(); ++s)
        if (!edges.contains(boundary_.sides[s])) missing.push_back(s);
    if (missing.empty()) return true;
    for (const std::size_t s : missing) boundary_.halve(s);
    outline_ = boundary_.region();
    std::erase_if(inner_, [&](Vec2 p) { return !is_clear_of_boundary(p, 0); });
    return false;
}

std::optional<PlaneMesh> Mesher::mesh() {
    fill();
    triangulate();
    for (int k = 0; k < smoothings; ++k) {
        smooth();
        triangulate();
    }
    for (int k = 0; k < most_repairs; ++k) {
        if (repair()) return second_order();
        if (is_endless()) return std::nullopt;
        triangulate();
    }
    return std::nullopt;
}

PlaneMesh Mesher::second_order() const {
    PlaneMesh mesh;
    std::map<int, int> number;  // of the points that are used
    const auto node = [&](int point) {
        const auto [place, is_new] = number.try_emplace(point, int(mesh.nodes.size()));
        if (is_new) mesh.nodes.push_back(at(point));
        return place->second;
    };
    std::map<std::pair<int, int>, int> middles;
    const auto middle = [&](int a, int b) {
        const auto [place, is_new] = middles.try_emplace(std::minmax(a, b), int(mesh.nodes.size()));
        if (is_new) mesh.nodes.push_back(0.5 * (at(a) + at(b)));
        return place->second;
    };
    for (const std::array<int, 3>& t : triangles_) {
        for (const int corner : t) mesh.elements.push_back(node(corner));
        for (std::size_t k = 0; k < 3; ++k) mesh.elements.push_back(middle(t[k], t[(k + 1) % 3]));
    }
    for (const auto& [a, b] : boundary_.sides) {
        const BoundaryPoint& from = boundary_.points[std::size_t(a)];
        MeshSide side{node(a),   node(b), middle(a, b),
                      from.loop, from.at, boundary_.points[std::size_t(b)].at};
        if (side.to <= side.from) side.to += boundary_.loops[from.loop].length;
        mesh.nodes[std::size_t(side.middle)] =
            boundary_.on_curve(side.loop, (side.from + side.to) / 2);
        mesh.sides.push_back(side);
    }
    return mesh;
}

// Straightens sides that bend so far that an element is turned inside out.
void straighten(PlaneMesh& mesh) {
    std::set<int> bad;
    for (std::size_t e = 0; e < mesh.count(); ++e) {
        const auto places = mesh.places(e);
        for (const Vec2 p :
             {Vec2{0, 0}, Vec2{1, 0}, Vec2{0, 1}, Vec2{0.5, 0}, Vec2{0.5, 0.5}, Vec2{0, 0.5}})
            if (!(mapped(mesh.kind, p, places).area > 0))
                for (const int node : mesh.element(e).subspan(3)) bad.insert(node);
    }
    for (const MeshSide& side : mesh.sides)
        if (bad.contains(side.middle))
            mesh.nodes[std::size_t(side.middle)] =
                0.5 * (mesh.nodes[std::size_t(side.begin)] + mesh.nodes[std::size_t(side.end)]);
}

}  // namespace

std::optional<PlaneMesh> region_mesh(const Region& part, const std::vector<Circle>& circles,
                                     const std::vector<BoundarySpan>& stretches,
                                     const MeshSizes& sizes) {
    const std::vector<MeasuredLoop> loops = measured_loops(part);
    const SizeField field(loops, sizes);
    std::optional<PlaneMesh> mesh =
        Mesher(boundary_of(loops, circles, stretches, field), field, sizes).mesh();
    if (mesh) straighten(*mesh);
    return mesh;
}

}  // namespace bead
