// The words of G0 and G1, and the short way to read them: "G1 X105.1 Y99 E.02221" and the like, the
// form in which slicers write nearly all lines. Anything else (other words, comments, two blanks,
// an exponent, many digits) is left to the scanner, which reads these lines to the same words.
#pragma once
#include <array>
#include <cstdint>

#include "gcode/number.h"
#include "gcode/scanner.h"
#include "toolpath/command.h"

namespace bead {

struct MoveWords {
    static constexpr std::size_t feed = axis_count;
    static constexpr unsigned axes = 15;
    unsigned told = 0;                          // a bit for each of X Y Z E F
    std::array<double, axis_count + 1> number;  // as the text says; only those told are set

    [[nodiscard]] bool has(std::size_t word) const { return (told >> word & 1) != 0; }
    void put(std::size_t word, double value) {
        told |= 1U << word;
        number[word] = value;
    }
};

inline MoveWords move_words(const Words& words) {
    constexpr std::string_view letters = "XYZEF";
    MoveWords move;
    for (std::size_t i = 0; i < letters.size(); ++i)
        if (words.has(letters[i])) move.put(i, words.at(letters[i]));
    return move;
}

struct PlainMove {
    const char* end = nullptr;  // behind the line's end; null if the line is not of this form
    MoveWords words;
};

// A number of up to 15 digits, 9 of them before the point, without an exponent: read as read_number
// reads it. `end` is null if it is something else. Something that is no part of a number follows.
inline Number read_plain_number(const char* at) {
    constexpr std::ptrdiff_t most_digits = 15, most_whole = 9;
    const bool negative = *at == '-';
    if (negative) ++at;
    const char* const first = at;
    std::uint64_t digits = 0;
    for (; is_digit(*at); ++at) digits = digits * 10 + std::uint64_t(*at - '0');
    const auto whole = at - first;
    std::ptrdiff_t decimals = 0;
    if (*at == '.') {
        const char* const point = ++at;
        for (; is_digit(*at); ++at) digits = digits * 10 + std::uint64_t(*at - '0');
        decimals = at - point;
    }
    const auto count = whole + decimals;
    if (count == 0 || count > most_digits || whole > most_whole) return {};
    const double size = double(digits) / powers_of_ten[std::size_t(decimals)];
    return {negative ? -size : size, at};
}

inline int plain_word(char letter) {
    switch (letter) {
        case 'X':
            return axis_x;
        case 'Y':
            return axis_y;
        case 'Z':
            return axis_z;
        case 'E':
            return axis_e;
        case 'F':
            return MoveWords::feed;
        default:
            return -1;
    }
}

// The text ends in a line end.
inline PlainMove read_plain_move(const char* at) {
    PlainMove move;
    if (at[0] != 'G' || (at[1] != '1' && at[1] != '0')) return move;
    for (at += 2; *at == ' ';) {
        const int word = plain_word(at[1]);
        if (word < 0) return move;
        const Number number = read_plain_number(at + 2);
        if (number.end == nullptr) return move;
        move.words.put(std::size_t(word), number.value);
        at = number.end;
    }
    if (*at == '\n') move.end = at + 1;
    return move;
}

}  // namespace bead
