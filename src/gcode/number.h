// A decimal number at the start of some text, read exactly and by no locale. Up to 2^53 times a
// negative power of ten down to 1e-22 is one correctly rounded division (Clinger 1990); anything
// longer goes through std::from_chars.
#pragma once
#include <array>
#include <charconv>
#include <cstdint>
#include <limits>

namespace bead {

struct Number {
    double value = 0;           // may be infinite or not a number, as the text says
    const char* end = nullptr;  // what follows it; where the search began if there is no number
};

inline bool is_digit(char c) { return c >= '0' && c <= '9'; }

// The long way. `exponent`: a lower-case e may follow the digits.
Number read_long_number(const char* begin, const char* end, bool exponent);

inline constexpr std::array<double, 20> powers_of_ten{1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,
                                                      1e7,  1e8,  1e9,  1e10, 1e11, 1e12, 1e13,
                                                      1e14, 1e15, 1e16, 1e17, 1e18, 1e19};

inline Number read_number(const char* begin, const char* end, bool exponent) {
    constexpr std::uint64_t exact = std::uint64_t{1} << 53;
    const char* at = begin;
    const bool negative = at != end && *at == '-';
    if (at != end && (*at == '-' || *at == '+')) ++at;

    std::uint64_t digits = 0;
    const char* const first = at;
    for (; at != end && is_digit(*at); ++at) digits = digits * 10 + std::uint64_t(*at - '0');
    auto count = at - first;
    std::ptrdiff_t decimals = 0;
    if (at != end && *at == '.') {
        const char* const point = ++at;
        for (; at != end && is_digit(*at); ++at) digits = digits * 10 + std::uint64_t(*at - '0');
        decimals = at - point;
        count += decimals;
    }
    const bool plain = count >= 1 && count <= 19 && digits <= exact;
    if (!plain || (exponent && at != end && *at == 'e'))
        return read_long_number(begin, end, exponent);
    const double size = double(digits) / powers_of_ten[std::size_t(decimals)];
    return {negative ? -size : size, at};
}

}  // namespace bead
