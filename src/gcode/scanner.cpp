#include "gcode/scanner.h"

#include <algorithm>
#include <cmath>

#include "gcode/number.h"

namespace bead {
namespace {

constexpr double largest_number = 1e9;  // no word of a real file comes near

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r'; }
bool is_letter(char c) { return unsigned((c | 0x20) - 'a') < 26; }
char capital(char c) { return char(c & ~0x20); }
bool is_name_part(char c) { return is_letter(c) || is_digit(c) || c == '_'; }
bool is_command_letter(char c) { return c == 'G' || c == 'M' || c == 'T' || c == 'D'; }

const char* skip_blanks(const char* at, const char* end) {
    while (at != end && is_blank(*at)) ++at;
    return at;
}

// Blanks and (comments in parentheses).
const char* skip_to_text(const char* at, const char* end) {
    at = skip_blanks(at, end);
    while (at != end && *at == '(') {
        at = std::find(at, end, ')');
        if (at != end) at = skip_blanks(at + 1, end);
    }
    return at;
}

const char* skip_line_number(const char* at, const char* end) {
    if (end - at < 2 || (*at != 'N' && *at != 'n') || !is_digit(at[1])) return at;
    return skip_to_text(std::find_if_not(at + 1, end, is_digit), end);
}

std::string_view between(const char* begin, const char* end) {
    return {begin, std::size_t(end - begin)};
}

Line macro(const char* begin, const char* end) {
    const char* const stop = std::find_if_not(begin, end, is_name_part);
    return {LineKind::command, 0, -1, between(begin, stop), between(stop, end)};
}

// G1, M104, T0, G92.1: a command letter with digits behind it.
Line numbered(const char* begin, const char* end) {
    int number = 0;
    const char* at = begin + 1;
    for (; at != end && is_digit(*at); ++at) number = std::min(number * 10 + (*at - '0'), 99999);
    if (at != end && *at == '.') {
        number = -1;
        at = std::find_if_not(at + 1, end, is_digit);
    }
    return {LineKind::command, capital(*begin), number, between(begin, at), between(at, end)};
}

}  // namespace

Line split_line(std::string_view text) {
    const char* const end = text.data() + text.size();
    const char* const at = skip_line_number(skip_to_text(text.data(), end), end);
    if (at == end || *at == '*') return {};
    if (*at == ';') return {LineKind::comment, 0, -1, {}, between(at + 1, end)};
    const bool digit_follows = end - at > 1 && is_digit(at[1]);
    if (digit_follows && is_command_letter(capital(*at))) return numbered(at, end);
    if (is_letter(*at) && !digit_follows) return macro(at, end);
    return {LineKind::junk, 0, -1, {}, {}};
}

Words::Words(std::string_view text) {
    const char* at = text.data();
    const char* const end = at + text.size();
    while (at != end && *at != ';' && *at != '*') {
        if (is_blank(*at)) {
            ++at;
        } else if (is_letter(*at)) {
            at = read_word(at, end);
        } else if (*at == '(') {
            at = skip_to_text(at, end);
        } else {
            junk_ = true;
            ++at;
        }
    }
    if (at != end && *at == '*') checksum_ = between(at, end);
}

bool Words::fit_checksum(std::string_view line) const {
    if (checksum_.empty()) return true;
    unsigned sum = 0;
    for (const char* at = line.data(); at != checksum_.data(); ++at) sum ^= std::uint8_t(*at);
    const char* const begin = checksum_.data() + 1;
    const char* const end = checksum_.data() + checksum_.size();
    const char* const digits = skip_blanks(begin, end);
    const Number told = read_number(digits, end, false);
    return told.end != digits && told.value == sum;
}

// A number with junk at its end, such as 1,5 or 1.2.3, is not taken for one.
const char* Words::read_word(const char* at, const char* end) {
    const char letter = capital(*at);
    const bool is_capital = *at == letter;
    const char* start = at + 1;
    if (start != end && is_blank(*start)) start = skip_blanks(start, end);
    const bool blanks = start != at + 1;
    if (start == end || (blanks && is_letter(*start))) {
        bare_ |= bit(letter);
        return start;
    }
    const Number number = read_number(start, end, is_capital);
    const char* const stop = number.end;
    if (stop == start) {
        bare_ |= bit(letter);
    } else if (stop == end || is_blank(*stop) || is_letter(*stop) || *stop == ';' || *stop == '*' ||
               *stop == '(') {
        keep(letter, number.value);
    } else {
        junk_ = true;
    }
    return stop;
}

void Words::keep(char letter, double value) {
    if (!(std::abs(value) <= largest_number)) too_large_ = letter;
    numbered_ |= bit(letter);
    numbers_[std::size_t(letter - 'A')] = value;
}

}  // namespace bead
