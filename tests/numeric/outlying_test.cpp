#include "numeric/outlying.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <random>
#include <set>

namespace bead {
namespace {

// Up to four of twelve rows are wrong by a factor, all in the same direction.
RC_GTEST_PROP(Outlying, FindsExactlyTheRowsThatAreWrong, ()) {
    std::mt19937_64 random(*rc::gen::arbitrary<unsigned>());
    std::uniform_real_distribution<double> uniform(1, 3);
    const int wrong = *rc::gen::inRange(0, 5);
    const double factor = *rc::gen::element(0.001, 0.3, 3.0, 1000.0);
    Rows rows;
    std::vector<double> values;
    for (int i = 0; i < 12; ++i) {
        rows.push_back({uniform(random), uniform(random)});
        values.push_back(dot(rows.back(), {4, 1}) * (i < wrong ? factor : 1));
    }
    std::set<std::size_t> found, expected;
    for (const OutlyingRow& row : outlying(rows, values)) found.insert(row.row);
    for (int i = 0; i < wrong; ++i) expected.insert(std::size_t(i));
    RC_ASSERT(found == expected);
}

TEST(Outlying, LeavesHonestNoiseAlone) {
    std::mt19937_64 random(3);
    std::normal_distribution<double> normal;
    std::uniform_real_distribution<double> uniform(1, 3);
    for (int sample = 0; sample < 50; ++sample) {
        Rows rows;
        std::vector<double> values;
        for (int i = 0; i < 10; ++i) {
            rows.push_back({uniform(random), uniform(random)});
            values.push_back(dot(rows.back(), {4, 1}) * (1 + 0.05 * normal(random)));
        }
        EXPECT_TRUE(outlying(rows, values).empty()) << sample;
    }
}

TEST(Outlying, NamesTheFactor) {
    Rows rows;
    std::vector<double> values;
    for (int i = 1; i <= 8; ++i) {
        rows.push_back({double(i)});
        values.push_back(2.0 * i);
    }
    values[5] *= 3.6;
    const auto found = outlying(rows, values);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].row, 5U);
    EXPECT_NEAR(found[0].ratio, 3.6, 1e-9);
}

TEST(Outlying, AsksForRowsEnoughToTell) {
    EXPECT_TRUE(outlying({{1}, {1}, {1}}, {1, 1, 100}).empty());
    EXPECT_TRUE(outlying({}, {}).empty());
}

}  // namespace
}  // namespace bead
