// Numbers with a fixed count of decimals: whole numbers of the last decimal, so that rounding
// happens once and equal numbers compare equal, and their text without trailing zeros, by no
// locale.
#pragma once
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <string>

#include "core/expects.h"

namespace bead {

constexpr std::int64_t power_of_ten(int exponent) {
    std::int64_t power = 1;
    for (int i = 0; i < exponent; ++i) power *= 10;
    return power;
}

inline std::int64_t fixed(double value, int decimals) {
    const double scaled = value * double(power_of_ten(decimals));
    BEAD_EXPECTS(std::abs(scaled) < 9e18);  // also refuses what is not a number
    return std::llround(scaled);
}

// append_fixed(text, -10500, 3) appends "-10.5".
inline void append_fixed(std::string& text, std::int64_t value, int decimals) {
    std::array<char, 48> digits;
    char* at = digits.data();
    if (value < 0) *at++ = '-';
    const std::int64_t size = value < 0 ? -value : value;
    const std::int64_t one = power_of_ten(decimals);
    at = std::to_chars(at, digits.data() + digits.size(), size / one).ptr;
    std::int64_t rest = size % one;
    if (rest != 0) *at++ = '.';
    for (std::int64_t place = one / 10; rest != 0; place /= 10) {
        *at++ = char('0' + rest / place);
        rest %= place;
    }
    text.append(digits.data(), at);
}

}  // namespace bead
