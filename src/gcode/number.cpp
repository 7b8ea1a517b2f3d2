#include "gcode/number.h"

#include <string_view>

namespace bead {
namespace {

// Whether text that std::from_chars calls out of range is too small, not too large.
bool is_tiny(std::string_view text) {
    if (text.find("e-") != std::string_view::npos) return true;
    const auto start = text.find_first_not_of("-0");
    return start != std::string_view::npos && text[start] == '.' &&
           text.find('e') == std::string_view::npos;
}

}  // namespace

Number read_long_number(const char* begin, const char* end, bool exponent) {
    const bool plus = begin != end && *begin == '+';
    const char* const start = plus ? begin + 1 : begin;
    if (plus && start != end && *start == '-') return {0, begin};
    double value = 0;
    const auto format = exponent ? std::chars_format::general : std::chars_format::fixed;
    const auto [stop, fault] = std::from_chars(start, end, value, format);
    if (fault == std::errc::invalid_argument) return {0, begin};
    if (fault == std::errc::result_out_of_range) {
        const bool tiny = is_tiny({start, std::size_t(stop - start)});
        value = tiny ? 0 : std::numeric_limits<double>::infinity();
    }
    return {value, stop};
}

}  // namespace bead
