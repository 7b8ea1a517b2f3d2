#include "fem/region_mesh.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <map>
#include <random>

#include "geom/clip.h"

namespace bead {
namespace {

double area_of(const PlaneMesh& mesh) {
    double sum = 0;
    for (std::size_t e = 0; e < mesh.count(); ++e)
        for (const QuadraturePoint& point : quadrature(mesh.kind)) {
            const double area = mapped(mesh.kind, point.place, mesh.places(e)).area;
            EXPECT_GT(area, 0);
            sum += point.weight * area;
        }
    return sum;
}

// 1 for an equilateral triangle, 0 for a flat one.
double worst_shape(const PlaneMesh& mesh) {
    double worst = 1;
    for (std::size_t e = 0; e < mesh.count(); ++e) {
        const auto p = mesh.places(e);
        const Vec2 a = p[1] - p[0], b = p[2] - p[1], c = p[0] - p[2];
        worst =
            std::min(worst, 2 * std::sqrt(3.0) * cross(a, b) / (dot(a, a) + dot(b, b) + dot(c, c)));
    }
    return worst;
}

// Every side of an element is another's, or the boundary's.
void expect_closed(const PlaneMesh& mesh) {
    std::map<std::pair<int, int>, int> sides;
    for (std::size_t e = 0; e < mesh.count(); ++e)
        for (std::size_t k = 0; k < 3; ++k)
            ++sides[{mesh.element(e)[k], mesh.element(e)[(k + 1) % 3]}];
    std::size_t open = 0;
    for (const auto& [side, count] : sides) {
        EXPECT_EQ(count, 1);
        open += sides.contains({side.second, side.first}) ? 0 : 1;
    }
    EXPECT_EQ(open, mesh.sides.size());
    for (const MeshSide& side : mesh.sides) EXPECT_TRUE(sides.contains({side.begin, side.end}));
}

TEST(RegionMesh, FillsARectangle) {
    const Region part{{{{0, 0}, {120, 0}, {120, 30}, {0, 30}}, {}}};
    const auto mesh = region_mesh(part, {}, {{0, 58, 62}}, {.size = 2});
    ASSERT_TRUE(mesh);
    EXPECT_NEAR(area_of(*mesh), 3600, 1e-9);
    EXPECT_GT(worst_shape(*mesh), 0.6);
    expect_closed(*mesh);
    for (const double x : {58.0, 62.0})  // both ends of the stretch are nodes
        EXPECT_TRUE(std::ranges::any_of(mesh->nodes, [&](Vec2 p) {
            return distance(p, {x, 0}) < 1e-9;
        }));
}

TEST(RegionMesh, RoundHolesAreRound) {
    Polyline hole;
    for (int i = 0; i < 100; ++i) hole.push_back(Vec2{20, 15} + 6.0 * unit(-2 * pi * i / 100));
    const Region part{{{{0, 0}, {40, 0}, {40, 30}, {0, 30}}, {hole}}};
    const auto mesh = region_mesh(part, {{{20, 15}, 6}}, {}, {.size = 2});
    ASSERT_TRUE(mesh);
    expect_closed(*mesh);
    EXPECT_NEAR(area_of(*mesh), 1200 - 36 * pi, 1e-3);  // quadratic arcs: 1e-6 of the hole's area
    for (const MeshSide& side : mesh->sides) {
        if (side.loop != 1) continue;
        for (const int node : {side.begin, side.end, side.middle})
            EXPECT_NEAR(distance(mesh->nodes[std::size_t(node)], {20, 15}), 6, 1e-12);
    }
}

// Sides far shorter than an element, ends of stretches beside corners: one point stands for both,
// and no heap of slivers comes of it.
TEST(RegionMesh, PassesOverWhatIsTooSmallToSee) {
    const Region exact{{{{0, 0}, {80, 0}, {80, 30}, {0, 30}}, {}}};
    for (const double small : {1e-7, 1e-5, 1e-3}) {
        const Region part{{{{0, 0}, {80, 0}, {80 + small, small}, {80, 30}, {0, 30}}, {}}};
        const auto mesh = region_mesh(part, {}, {{0, 40, 80 - small}, {0, 80, 110 + small}}, {});
        ASSERT_TRUE(mesh) << small;
        EXPECT_LT(mesh->count(), 7000U) << small;
        EXPECT_GT(worst_shape(*mesh), 0.3) << small;
        EXPECT_NEAR(area_of(*mesh), area(exact), 0.1) << small;
        expect_closed(*mesh);
    }
}

RC_GTEST_PROP(RegionMesh, MeetsAnyBoundary, (unsigned seed)) {
    // A star with a hole of the same kind.
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> uniform(0.6, 1);
    Polyline outer, hole;
    const int corners = 5 + int(seed % 12);
    for (int i = 0; i < corners; ++i)
        outer.push_back(20 * uniform(random) * unit(2 * pi * i / corners));
    for (int i = 0; i < 6; ++i) hole.push_back(7 * uniform(random) * unit(-2 * pi * i / 6));
    const Region part{{outer, {hole}}};
    const auto mesh = region_mesh(part, {}, {}, {.size = 2.5});
    RC_ASSERT(mesh.has_value());
    expect_closed(*mesh);
    RC_ASSERT(std::abs(area_of(*mesh) - area(part)) < 1e-6 * area(part));
    RC_ASSERT(worst_shape(*mesh) > 0.05);
}

}  // namespace
}  // namespace bead
