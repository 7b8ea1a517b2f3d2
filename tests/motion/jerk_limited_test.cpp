#include "motion/jerk_limited.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include "motion/jerk_ramp.h"

namespace bead {
namespace {

SpeedLimits random_limits(unsigned seed, std::size_t count) {
    std::mt19937_64 random(seed);
    const auto uniform = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    SpeedLimits limits;
    limits.jerk = 20'000;
    double speed = 60, acceleration = 1000;
    for (std::size_t i = 0; i < count; ++i) {
        if (uniform(0, 1) < 0.1) speed = uniform(10, 200);
        if (uniform(0, 1) < 0.02) acceleration = uniform(200, 3000);
        limits.length.push_back(std::exp(uniform(std::log(0.05), std::log(30))));
        limits.speed.push_back(speed);
        limits.acceleration.push_back(acceleration);
        limits.point.push_back(uniform(0, 1) < 0.3 ? uniform(0, 20) : uniform(0, 300));
    }
    limits.point.front() = 0;
    limits.point.push_back(0);
    return limits;
}

JerkPhase after(const JerkPhase& p, double t) {
    return {p.t + t, p.s + t * (p.v + t * (p.a / 2 + t * p.j / 6)), p.v + t * (p.a + t * p.j / 2),
            p.a + t * p.j, p.j};
}

class RandomPath : public testing::TestWithParam<unsigned> {};

TEST_P(RandomPath, NothingJumpsAndTheWayIsComplete) {
    const SpeedLimits limits = random_limits(GetParam(), 400);
    const SpeedPlan plan = jerk_limited(limits);
    for (std::size_t i = 0; i + 1 < plan.phases.size(); ++i) {
        const JerkPhase &p = plan.phases[i], &next = plan.phases[i + 1];
        const JerkPhase end = after(p, next.t - p.t);
        ASSERT_NEAR(end.s, next.s, 1e-7) << "phase " << i;
        ASSERT_NEAR(end.v, next.v, 1e-6) << "phase " << i;
        ASSERT_NEAR(end.a, next.a, 1e-5) << "phase " << i;
        ASSERT_GE(next.t, p.t);
    }
    const double way = std::accumulate(limits.length.begin(), limits.length.end(), 0.0);
    EXPECT_NEAR(plan.phases.back().s, way, 1e-9 * way);
    EXPECT_EQ(plan.phases.back().v, 0);
}

TEST_P(RandomPath, NoLimitIsExceeded) {
    const SpeedLimits limits = random_limits(GetParam(), 400);
    const SpeedPlan plan = jerk_limited(limits);
    for (std::size_t i = 0; i < plan.speed.size(); ++i)
        ASSERT_LE(plan.speed[i], limits.point[i] * (1 + 1e-8) + 1e-9) << "point " << i;
    double place = 0;
    std::size_t phase = 0;
    for (std::size_t i = 0; i < limits.length.size(); ++i) {  // inside every piece, by sampling
        const double end = place + limits.length[i];
        for (; plan.phases[phase].s < end && phase + 1 < plan.phases.size(); ++phase) {
            const JerkPhase& p = plan.phases[phase];
            const double longest = plan.phases[phase + 1].t - p.t;
            ASSERT_LE(std::abs(p.j), limits.jerk * (1 + 1e-12));
            for (int sample = 0; sample <= 10; ++sample) {
                const JerkPhase at = after(p, longest * sample / 10);
                if (at.s <= place + 1e-9 || at.s >= end - 1e-9) continue;
                ASSERT_LE(at.v, limits.speed[i] * (1 + 1e-7)) << "piece " << i;
                ASSERT_LE(std::abs(at.a), limits.acceleration[i] * (1 + 1e-7)) << "piece " << i;
            }
        }
        if (phase > 0) --phase;
        place = end;
    }
}

// The same way with acceleration alone is a bound from below.
TEST_P(RandomPath, IsSlowerThanWithoutALimitOfJerkButTendsToIt) {
    SpeedLimits limits = random_limits(GetParam(), 200);
    double time = jerk_limited(limits).time.back();
    for (int i = 0; i < 4; ++i) {
        limits.jerk *= 100;
        const double faster = jerk_limited(limits).time.back();
        EXPECT_LE(faster, time * 1.002);  // a detour of the search, not a law of nature
        time = faster;
    }
    std::vector<double> v = limits.point;
    const std::size_t count = limits.length.size();
    for (std::size_t i = 0; i < count; ++i)
        for (const std::size_t end : {i, i + 1}) v[end] = std::min(v[end], limits.speed[i]);
    const auto able = [&](double from, std::size_t i) {
        return std::sqrt(from * from + 2 * limits.acceleration[i] * limits.length[i]);
    };
    for (std::size_t i = 0; i < count; ++i) v[i + 1] = std::min(v[i + 1], able(v[i], i));
    for (std::size_t i = count; i-- > 0;) v[i] = std::min(v[i], able(v[i + 1], i));
    double least = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const double a = limits.acceleration[i], d = limits.length[i];
        const double top =
            std::min(limits.speed[i], std::sqrt(a * d + (v[i] * v[i] + v[i + 1] * v[i + 1]) / 2));
        const double ramps = (2 * top * top - v[i] * v[i] - v[i + 1] * v[i + 1]) / (2 * a);
        least += (2 * top - v[i] - v[i + 1]) / a + (d - ramps) / top;
    }
    EXPECT_GE(time, least * (1 - 1e-9));
    EXPECT_LE(time, least * 1.1);
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomPath, testing::Range(1U, 21U));

TEST(JerkLimited, ALongMoveIsTheTextbooksSevenPhases) {
    const SpeedLimits limits{{100}, {50}, {1000}, {0, 0}, 20'000};
    const SpeedPlan plan = jerk_limited(limits);
    EXPECT_EQ(plan.phases.size(), 6U);  // the acceleration is just reached: 50 = A²/J
    EXPECT_NEAR(plan.time.back(), 100 / 50.0 + 0.1, 1e-12);
}

RC_GTEST_PROP(JerkRamp, ReachIsTheInverseOfDistance, ()) {
    const double v0 = *rc::gen::inRange(0, 200'000) / 1000.0;
    const double distance = *rc::gen::inRange(1, 100'000) / 1000.0;
    const JerkLimits limits{1.0 * *rc::gen::inRange(100, 5000),
                            1.0 * *rc::gen::inRange(1000, 500'000)};
    const double v1 = reach(v0, distance, limits);
    RC_ASSERT(v1 > v0);
    RC_ASSERT(std::abs(ramp_distance(v0, v1, limits) - distance) < 1e-9 * distance);
}

}  // namespace
}  // namespace bead
