#include "infill/principal_lines.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

#include "field/sampled.h"
#include "geom/clip.h"

namespace bead {
namespace {

constexpr auto first = PrincipalFamily::first, second = PrincipalFamily::second;

Region circle(double radius) {
    Polygon polygon;
    for (int i = 0; i < 720; ++i) polygon.outer.push_back(radius * unit(2 * pi * i / 720));
    return {polygon};
}

Region ring(double inner, double outer) { return difference(circle(outer), circle(inner)); }

Region rectangle(Vec2 low, Vec2 high) {
    return {{{low, {high.x, low.y}, high, {low.x, high.y}}, {}}};
}

// Polar components about the origin in x and y.
PlaneTensor from_polar(Vec2 p, PlaneTensor polar) { return rotated(polar, p / length(p)); }

// A ring twisted in its plane: pure shear, lines at 45 degrees to the radius, r = r0 exp(±θ).
PlaneTensor twisted_ring(Vec2 p) { return from_polar(p, {0, 0, 1000 / dot(p, p)}); }

// Lamé's ring of radii 10 and 38 under a pressure of 1 inside.
PlaneTensor pressed_ring(Vec2 p) {
    const double scale = 100.0 / (38 * 38 - 100), ratio = 38 * 38 / dot(p, p);
    return from_polar(p, {scale * (1 - ratio), scale * (1 + ratio), 0});
}

// A concentrated force on a half plane y < 0 (Flamant).
PlaneTensor flamant(Vec2 p) { return from_polar(p, {2 / pi * p.y / dot(p, p), 0, 0}); }

// A plate pulled along x with a round hole of radius 5 (Kirsch).
PlaneTensor kirsch(Vec2 p) {
    const double r = length(p), q = 25 / (r * r), c = std::cos(2 * std::atan2(p.y, p.x)),
                 s = std::sin(2 * std::atan2(p.y, p.x));
    return from_polar(p, {(1 - q) / 2 + (1 - 4 * q + 3 * q * q) / 2 * c,
                          (1 + q) / 2 - (1 + 3 * q * q) / 2 * c, -(1 + 2 * q - 3 * q * q) / 2 * s});
}

// A beam of height 20 under a shear force, away from its ends.
PlaneTensor bent(Vec2 p) { return {(100 - p.x) * p.y, 0, (100 - p.y * p.y) / 2}; }

Sampled<PlaneTensor> sampled(const TensorField& field, double step) {
    const int count = static_cast<int>(100 / step) + 1;
    Sampled<PlaneTensor> grid{{-50.1, -50.2}, step, count, count, {}};
    for (int j = 0; j < count; ++j)
        for (int i = 0; i < count; ++i) {
            const Vec2 p = grid.origin + step * Vec2{double(i), double(j)};
            grid.values.push_back(field(length(p) < 3 ? Vec2{3, 0} : p));
        }
    return grid;
}

// How far the line leaves the spiral through its seed, mm along the normal.
double off_spiral(const Polyline& line, Vec2 seed, double sign) {
    double most = 0, angle = 0;
    for (std::size_t i = 1; i < line.size(); ++i)
        angle += std::atan2(cross(line[i - 1], line[i]), dot(line[i - 1], line[i]));
    const double start = std::log(length(line.front()));
    double turned = 0;
    const auto law = [&](std::size_t i) {
        return length(line[i]) * std::abs(std::log(length(line[i])) - start - sign * turned) /
               std::sqrt(2.0);
    };
    for (std::size_t i = 1; i < line.size(); ++i) {
        turned += std::atan2(cross(line[i - 1], line[i]), dot(line[i - 1], line[i]));
        most = std::max(most, law(i));
    }
    EXPECT_GT(std::abs(angle), 1);
    EXPECT_TRUE(std::ranges::any_of(line, [&](Vec2 p) { return distance(p, seed) < 1e-9; }));
    return most;
}

double spiral_error(const TensorField& field, double step, PrincipalFamily family) {
    const Vec2 seed{12, 0};
    const PrincipalTracer tracer(field, ring(11.9, 36), {.step = step, .scale = 10});
    const std::optional<TracedLine> line = tracer.line(seed, family);
    EXPECT_TRUE(line);
    EXPECT_EQ(line->end, TraceEnd::boundary);
    EXPECT_EQ(line->begin, TraceEnd::boundary);
    return off_spiral(line->points, seed, family == first ? 1 : -1);
}

TEST(PrincipalLines, OfATwistedRingAreLogarithmicSpirals) {
    const double bound[] = {0.006, 0.0016, 0.0004};  // mm, on nodes 2, 1 and 0.5 mm apart
    for (const PrincipalFamily family : {first, second}) {
        double step = 2;
        for (const double most : bound) {
            EXPECT_LT(spiral_error(sampled(twisted_ring, step), 0.25, family), 1.1 * most) << step;
            step /= 2;
        }
        EXPECT_LT(spiral_error(twisted_ring, 0.25, family), 1e-6);
    }
}

// Half the step, a sixteenth of the error.
TEST(PrincipalLines, AreOfFourthOrder) {
    const double coarse = spiral_error(twisted_ring, 2, first),
                 fine = spiral_error(twisted_ring, 1, first);
    EXPECT_GT(coarse, 1e-6);
    EXPECT_NEAR(std::log2(coarse / fine), 4, 0.5);
}

TEST(PrincipalLines, OfAPressedRingAreCirclesAndRadii) {
    for (const auto& [step, most] : {std::pair{2.0, 0.0016}, {1.0, 0.00045}, {0.5, 0.0002}}) {
        const PrincipalTracer tracer(sampled(pressed_ring, step), ring(10.2, 37.8), {});
        const std::optional<TracedLine> round = tracer.line({20, 0}, first);
        ASSERT_TRUE(round);
        EXPECT_EQ(round->end, TraceEnd::closed);
        EXPECT_EQ(round->points.front(), round->points.back());
        for (const Vec2 p : round->points) EXPECT_NEAR(length(p), 20, 10 * most);
        const Vec2 last = round->points[round->points.size() - 2];
        EXPECT_LT(std::abs(length(last) - 20), most) << step;
        const std::optional<TracedLine> radius = tracer.line(20 * unit(0.3), second);
        ASSERT_TRUE(radius);
        for (const Vec2 p : radius->points) EXPECT_LT(std::abs(cross(p, unit(0.3))), 0.02);
        EXPECT_NEAR(length(radius->points.back() - radius->points.front()), 27.6, 0.01);
    }
}

TEST(PrincipalLines, OfAPointLoadAreRaysAndHalfCircles) {
    const PrincipalTracer tracer(flamant, difference(circle(30), rectangle({-40, -1}, {40, 40})),
                                 {.scale = 0.1});
    const std::optional<TracedLine> round = tracer.line({0, -12}, first);
    const std::optional<TracedLine> ray = tracer.line(12 * unit(-1), second);
    ASSERT_TRUE(round && ray);
    for (const Vec2 p : round->points) EXPECT_NEAR(length(p), 12, 1e-4);
    for (const Vec2 p : ray->points) EXPECT_LT(std::abs(cross(p, unit(-1))), 1e-4);
}

TEST(PrincipalLines, OfPureBendingEndWhereNothingIsStressed) {
    const auto bending = [](Vec2 p) { return PlaneTensor{p.y, 0, 0}; };
    const PrincipalTracer tracer(bending, rectangle({0, -10}, {100, 10}), {.scale = 5});
    const std::optional<TracedLine> along = tracer.line({50, 6}, first);
    ASSERT_TRUE(along);
    EXPECT_NEAR(length(along->points), 100, 1e-9);
    for (const Vec2 p : along->points) EXPECT_EQ(p.y, 6);
    const std::optional<TracedLine> across = tracer.line({50, 6}, second);
    ASSERT_TRUE(across);
    EXPECT_EQ(across->begin == TraceEnd::isotropic ? across->end : across->begin,
              TraceEnd::boundary);
    for (const Vec2 p : across->points) EXPECT_GT(p.y, -0.01);
    EXPECT_FALSE(tracer.line({50, 0}, first));
}

TEST(PrincipalLines, OfABentBeamCrossItsAxisAtHalfARightAngle) {
    const PrincipalTracer tracer(bent, rectangle({0, -10}, {60, 10}), {.scale = 50});
    const std::optional<TracedLine> line = tracer.line({20, 0}, first);
    ASSERT_TRUE(line);
    const auto at = std::ranges::find_if(line->points, [](Vec2 p) { return p == Vec2{20, 0}; });
    ASSERT_TRUE(at != line->points.begin() && at + 1 < line->points.end());
    const Vec2 way = at[1] - at[-1];
    EXPECT_NEAR(std::abs(way.y / way.x), 1, 3e-3);
    // At the free edges along or across them.
    const Vec2 low = line->points.front(), next = line->points[1];
    EXPECT_NEAR(std::abs(low.y), 10, 1e-9);
    EXPECT_LT(std::abs((next.x - low.x) / (next.y - low.y)), 0.1);
}

TEST(PrincipalLines, StopAtPointsWithoutDirection) {
    // On the rim where the hoop stress changes its sign nothing is stressed at all.
    const Vec2 zero = 5 * unit(pi / 6);
    EXPECT_LT(std::hypot(principal(kirsch(zero)).first, principal(kirsch(zero)).second), 1e-12);
    const PrincipalTracer tracer(kirsch, difference(circle(40), circle(4.99)), {.scale = 1.5});
    EXPECT_FALSE(tracer.line(zero, first));
    EXPECT_TRUE(tracer.line(6 * unit(pi / 2), first));
}

Vec2 any_place(Vec2 low, Vec2 high) {
    const auto share = [] { return double(*rc::gen::inRange(1, 1000)) / 1000; };
    return {low.x + share() * (high.x - low.x), low.y + share() * (high.y - low.y)};
}

RC_GTEST_PROP(PrincipalLines, EndOnTheBoundaryAndFollowTheField, ()) {
    const Region region = rectangle({1, -9}, {60, 9});
    const Vec2 seed = any_place({2, -8.9}, {59, 8.9});
    const PrincipalFamily family = *rc::gen::element(first, second);
    const std::optional<TracedLine> line =
        PrincipalTracer(bent, region, {.scale = 50}).line(seed, family);
    RC_ASSERT(line.has_value());
    for (const Vec2 end : {line->points.front(), line->points.back()})
        RC_ASSERT(boundary_distance(region, end) < 1e-9);
    for (std::size_t i = 1; i < line->points.size(); ++i) {
        const Vec2 way = line->points[i] - line->points[i - 1];
        RC_ASSERT(length(way) < 0.25 + 1e-9);
        const Vec2 middle = lerp(line->points[i], line->points[i - 1], 0.5);
        RC_ASSERT(std::abs(cross(way, direction(bent(middle), family))) < 2e-3);
    }
}

// Two lines through one point, one of each family, cross at a right angle there.
RC_GTEST_PROP(PrincipalLines, OfTheTwoFamiliesCrossAtRightAngles, ()) {
    const PrincipalTracer tracer(bent, rectangle({1, -9}, {60, 9}), {.step = 0.05, .scale = 50});
    const Vec2 seed = any_place({3, -8}, {58, 8});
    std::vector<Vec2> ways;
    for (const PrincipalFamily family : {first, second}) {
        const Polyline line = tracer.line(seed, family).value().points;
        const auto at = std::ranges::find(line, seed);
        RC_ASSERT(at != line.begin() && at + 1 < line.end());
        ways.push_back(at[1] - at[-1]);
    }
    RC_ASSERT(std::abs(dot(ways[0], ways[1])) < 1e-3 * length(ways[0]) * length(ways[1]));
}

// Mirrored field and seed, mirrored line.
RC_GTEST_PROP(PrincipalLines, OfAMirroredPartAreMirrored, ()) {
    const auto turned_over = [](Vec2 p) {
        const PlaneTensor t = bent({p.x, -p.y});
        return PlaneTensor{t.xx, t.yy, -t.xy};
    };
    const Region region = rectangle({1, -9}, {60, 9});
    const Vec2 seed = any_place({2, -8.9}, {59, 8.9});
    const auto family = *rc::gen::element(first, second);
    Polyline line = PrincipalTracer(bent, region, {.scale = 50}).line(seed, family)->points;
    Polyline mirrored =
        PrincipalTracer(turned_over, region, {.scale = 50}).line({seed.x, -seed.y}, family)->points;
    RC_ASSERT(line.size() == mirrored.size());
    if (distance({line.front().x, -line.front().y}, mirrored.front()) > 1e-6)
        std::ranges::reverse(mirrored);
    for (std::size_t i = 0; i < line.size(); ++i)
        RC_ASSERT(distance({line[i].x, -line[i].y}, mirrored[i]) < 1e-6);
}

}  // namespace
}  // namespace bead
