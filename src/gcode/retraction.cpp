#include "gcode/retraction.h"

#include <algorithm>
#include <optional>

#include "gcode/key_words.h"

namespace bead {
namespace {

double speed_told(const Words& words, char letter, double otherwise) {
    const bool any = words.has(letter) && words.at(letter) > 0;
    return any ? words.at(letter) / 60 : otherwise;  // mm/min in the text
}

double length_told(const Words& words, char letter, double otherwise) {
    return words.has(letter) ? std::max(0.0, words.at(letter)) : otherwise;
}

double told(std::string_view words, std::string_view key, double least, double otherwise) {
    const std::optional<double> value = number_of(words, key).value;
    return value && *value >= least ? *value : otherwise;
}

}  // namespace

Retraction with_m207(Retraction retraction, const Words& words, Dialect dialect) {
    retraction.length = length_told(words, 'S', retraction.length);
    retraction.lift = length_told(words, 'Z', retraction.lift);
    retraction.speed = speed_told(words, 'F', retraction.speed);
    if (dialect != reprap_dialect) return retraction;
    if (words.has('R')) retraction.extra = words.at('R');
    retraction.recover_speed =
        speed_told(words, 'T', speed_told(words, 'F', retraction.recover_speed));
    return retraction;
}

Retraction with_m208(Retraction retraction, const Words& words) {
    if (words.has('S')) retraction.extra = words.at('S');
    retraction.recover_speed = speed_told(words, 'F', retraction.recover_speed);
    return retraction;
}

Retraction with_klipper_words(Retraction retraction, std::string_view words) {
    constexpr double least_speed = 1;
    retraction.length = told(words, "RETRACT_LENGTH", 0, retraction.length);
    retraction.speed = told(words, "RETRACT_SPEED", least_speed, retraction.speed);
    retraction.extra = told(words, "UNRETRACT_EXTRA_LENGTH", 0, retraction.extra);
    retraction.recover_speed =
        told(words, "UNRETRACT_SPEED", least_speed, retraction.recover_speed);
    return retraction;
}

}  // namespace bead
