#include "vibration/timed.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "vibration/point_speeds.h"

namespace bead {
namespace {

// Rings of chords of many lengths with travel in between, corners and straight runs among them.
std::vector<Piece> rings(unsigned seed, std::size_t count) {
    std::mt19937_64 random(seed);
    const auto uniform = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    Path ring{.role = Role::wall, .bead = {0.4, 0.2}, .speed = 50, .points = {}};
    Toolpath toolpath;
    for (std::size_t points = 0; points < count; points += ring.points.size()) {
        const double radius = std::exp(uniform(std::log(1), std::log(60)));
        const auto chords = std::size_t(uniform(3, 200));
        const Vec2 middle{uniform(0, 200), uniform(0, 200)};
        ring.speed = uniform(0, 1) < 0.5 ? 50 : 60;
        ring.points.clear();
        for (std::size_t i = 0; i <= chords; ++i) {
            const Vec2 at = middle + radius * unit(2 * pi * double(i) / double(chords));
            ring.points.push_back({at.x, at.y, 0});
        }
        toolpath.push_back(ring);
    }
    return pieces_of(toolpath, 120);
}

struct ToldPiece {
    std::vector<MotionSegment> segments;
    double duration = 0, length = 0;
};

ToldPiece told(std::span<const Piece> pieces, const TimeLaw& law) {
    ToldPiece all;
    timed(pieces, law, [&](const MotionSegment& segment) {
        all.segments.push_back(segment);
        all.duration += segment.duration;
        all.length += segment.length;
    });
    return all;
}

constexpr TimeLaw k0{}, k1{.profile = SpeedProfile::jerk_limited};

class AnyPath : public testing::TestWithParam<unsigned> {};

TEST_P(AnyPath, ExceedsNothing) {
    const std::vector<Piece> pieces = rings(GetParam(), 3000);
    for (const TimeLaw& law : {k0, k1}) {
        const std::vector<double> caps = point_speeds(pieces, law);
        std::size_t piece = 0;
        double done = 0, v = 0, a = 0;
        const bool limited = law.profile == SpeedProfile::jerk_limited;
        for (const MotionSegment& s : told(pieces, law).segments) {
            ASSERT_NEAR(s.speed, v, 1e-5);
            if (limited) {
                ASSERT_LE(std::abs(s.jerk), law.jerk * (1 + 1e-4));
                ASSERT_NEAR(s.acceleration, a, 1e-4 * law.acceleration);
            }
            v = speed(s, s.duration);
            a = s.acceleration + s.duration * s.jerk;
            ASSERT_LE(std::abs(s.acceleration), law.acceleration * (1 + 1e-4));
            ASSERT_LE(std::abs(a), law.acceleration * (1 + 1e-4));
            ASSERT_LE(std::max(s.speed, v), pieces[piece].feed * (1 + 1e-4));
            ASSERT_NEAR(way(s, s.duration), s.length, 1e-6);
            done += s.length;
            if (done < length(pieces[piece]) - 1e-9) continue;
            ++piece;
            done = 0;
            ASSERT_LE(v, caps[piece] * (1 + 1e-4) + 1e-6) << "point " << piece;
        }
        EXPECT_EQ(piece, pieces.size());
        EXPECT_NEAR(v, 0, 1e-6);
    }
}

// Not to the bit: which anchors the search for jerk-limited speeds finds depends on the window.
TEST_P(AnyPath, AsAStreamTakesAsLong) {
    const std::vector<Piece> pieces = rings(GetParam(), 30'000);
    for (const TimeLaw& law : {k0, k1}) {
        const ToldPiece whole = told(pieces, law);
        double duration = 0, length = 0;
        Timing timing(law, [&](const MotionSegment& segment) {
            duration += segment.duration;
            length += segment.length;
        });
        for (const Piece& piece : pieces) timing.add(piece);
        timing.finish();
        EXPECT_NEAR(length, whole.length, 1e-6);
        EXPECT_NEAR(duration, whole.duration, 3e-3 * whole.duration);
    }
}

INSTANTIATE_TEST_SUITE_P(Seeds, AnyPath, testing::Range(1U, 6U));

TEST(Timing, StandsStillWhereItIsTold) {
    std::vector<MotionSegment> all;
    Timing timing(k1, [&](const MotionSegment& segment) { all.push_back(segment); });
    const Piece first{{0, 0}, {10, 0}, 50, 0, 0.08}, second{{10, 0}, {20, 0}, 50, 0, 0.08};
    timing.add(first);
    timing.stand(0.25);
    timing.add(second);
    timing.finish();
    double still = 0;
    for (const MotionSegment& s : all)
        if (s.length == 0) {
            still += s.duration;
            EXPECT_EQ(s.from, (Vec2{10, 0}));
        }
    EXPECT_NEAR(still, 0.25, 1e-12);
}

// On a fine circle the bend's own acceleration decides, and as fine as you like.
TEST(PointSpeeds, DoNotBrakeForFineChords) {
    for (const double chord : {0.05, 0.2, 0.5}) {
        std::vector<Piece> pieces;
        const double radius = 10;
        const double angle = chord / radius;
        for (int i = 0; i < 1000; ++i)
            pieces.push_back({radius * unit(angle * i), radius * unit(angle * (i + 1)), 500, 0, 0});
        const std::vector<double> caps = point_speeds(pieces, k1);
        EXPECT_NEAR(caps[500], std::sqrt(1000 * radius), 0.04 * caps[500]) << chord;
        EXPECT_NEAR(windowed_curvature(pieces, 1.5)[500], 0.1, 0.008);  // whole chords only
    }
}

TEST(PointSpeeds, BoundTheStepOfVelocityAtCoarseOnes) {
    const std::vector<Piece> pieces{
        {{0, 0}, {10, 0}, 500, 0, 0},
        {{10, 0}, {10 + 10 * std::cos(0.3), 10 * std::sin(0.3)}, 500, 0, 0}};
    EXPECT_LE(point_speeds(pieces, k1)[1] * 2 * std::sin(0.15), 12 + 1e-9);
    EXPECT_LE(point_speeds(pieces, k0)[1] * 2 * std::sin(0.15), 9.1);
}

}  // namespace
}  // namespace bead
