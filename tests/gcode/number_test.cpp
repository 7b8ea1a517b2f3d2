#include "gcode/number.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <clocale>
#include <cmath>
#include <cstdlib>
#include <string>

namespace bead {
namespace {

double value_in(const std::string& text, bool exponent = false) {
    return read_number(text.data(), text.data() + text.size(), exponent).value;
}
std::size_t length_in(const std::string& text, bool exponent = false) {
    const char* const begin = text.data();
    return std::size_t(read_number(begin, begin + text.size(), exponent).end - begin);
}

// Twin: the C library, which rounds correctly.
RC_GTEST_PROP(Number, is_the_nearest_double, (bool negative)) {
    const auto digits = [](int least, int most) {
        const int count = *rc::gen::inRange(least, most);
        return *rc::gen::container<std::string>(std::size_t(count), rc::gen::inRange('0', ':'));
    };
    const std::string text =
        std::string(negative ? "-" : "").append(digits(1, 12)).append(".").append(digits(0, 14));
    RC_ASSERT(value_in(text) == std::strtod(text.c_str(), nullptr));
    RC_ASSERT(length_in(text) == text.size());
}

TEST(Number, takes_every_plain_form) {
    EXPECT_EQ(value_in("+1.5"), 1.5);
    EXPECT_EQ(value_in("-.5"), -0.5);
    EXPECT_EQ(value_in("7."), 7);
    EXPECT_EQ(value_in("007"), 7);
    EXPECT_TRUE(std::signbit(value_in("-0")));
    EXPECT_EQ(value_in("0.12345678901234567890123"), 0.12345678901234567890123);
    EXPECT_EQ(value_in("18446744073709551617"), 18446744073709551617.0);  // 2^64 + 1
    EXPECT_EQ(value_in("123456789012345678901234567890"), 123456789012345678901234567890.0);
}

TEST(Number, ends_where_the_number_does) {
    EXPECT_EQ(length_in("1.5Y2"), 3U);
    EXPECT_EQ(length_in("1e3"), 1U);
    EXPECT_EQ(length_in("1E3", true), 1U);
    EXPECT_EQ(length_in("1e3", true), 3U);
    EXPECT_EQ(length_in("1.2.3"), 3U);
}

TEST(Number, is_absent_without_digits) {
    for (const char* text : {"", "-", "+", ".", "-.", "+-1", "--1", "e5", "x"})
        EXPECT_EQ(length_in(text, true), 0U) << text;
}

TEST(Number, goes_to_infinity_or_zero_beyond_what_a_double_holds) {
    EXPECT_TRUE(std::isinf(value_in("1e999", true)));
    EXPECT_TRUE(std::isinf(value_in("1" + std::string(400, '0'))));
    EXPECT_EQ(value_in("1e-999", true), 0);
    EXPECT_EQ(value_in("0." + std::string(400, '0') + "1"), 0);
    EXPECT_TRUE(std::isinf(value_in("inf")));
    EXPECT_TRUE(std::isnan(value_in("nan")));
}

TEST(Number, knows_no_locale) {
    const std::string before = std::setlocale(LC_ALL, nullptr);
    if (std::setlocale(LC_ALL, "de_DE.UTF-8") == nullptr)
        GTEST_SKIP() << "no locale de_DE.UTF-8 here";
    const double value = value_in("1.5");
    const double long_value = value_in("1.50000000000000000000000");
    std::setlocale(LC_ALL, before.c_str());
    EXPECT_EQ(value, 1.5);
    EXPECT_EQ(long_value, 1.5);
}

}  // namespace
}  // namespace bead
