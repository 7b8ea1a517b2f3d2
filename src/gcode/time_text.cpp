#include "gcode/time_text.h"

#include <array>
#include <cmath>
#include <cstdint>

#include "gcode/number.h"

namespace bead {
namespace {

struct Unit {
    char letter;
    std::int64_t seconds;
};
constexpr std::array units{Unit{'d', 86400}, Unit{'h', 3600}, Unit{'m', 60}, Unit{'s', 1}};

}  // namespace

std::string time_text(double seconds) {
    auto rest = static_cast<std::int64_t>(std::max(0.0, seconds));
    std::string text;
    for (const Unit& unit : units) {
        if (text.empty() && rest < unit.seconds && unit.seconds > 1) continue;
        if (!text.empty()) text += ' ';
        text += std::to_string(rest / unit.seconds) + unit.letter;
        rest %= unit.seconds;
    }
    return text;
}

std::optional<double> time_in(std::string_view text) {
    std::optional<double> seconds;
    const char* at = text.data();
    const char* const end = at + text.size();
    while (at != end) {
        const Number number = read_number(at, end, false);
        if (number.end == at) {
            ++at;
            continue;
        }
        at = number.end;
        for (const Unit& unit : units)
            if (at != end && *at == unit.letter)
                seconds = seconds.value_or(0) + number.value * double(unit.seconds);
    }
    return seconds;
}

}  // namespace bead
