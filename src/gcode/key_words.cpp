#include "gcode/key_words.h"

#include <algorithm>
#include <cmath>

#include "gcode/number.h"

namespace bead {
namespace {

constexpr std::string_view blanks = " \t\r";
constexpr double largest_setting = 1e9;

char upper_case(char c) { return c >= 'a' && c <= 'z' ? char(c - 'a' + 'A') : c; }

bool same(std::string_view a, std::string_view b) {
    return std::ranges::equal(a, b, {}, upper_case, upper_case);
}

std::string_view unquoted(std::string_view value) {
    if (value.size() < 2 || value.front() != value.back()) return value;
    if (value.front() != '"' && value.front() != '\'') return value;
    return value.substr(1, value.size() - 2);
}

}  // namespace

std::optional<std::string_view> value_of(std::string_view words, std::string_view key) {
    words = words.substr(0, words.find(';'));
    while (true) {
        words.remove_prefix(std::min(words.find_first_not_of(blanks), words.size()));
        if (words.empty()) return {};
        const std::string_view word = words.substr(0, words.find_first_of(blanks));
        const auto equals = word.find('=');
        if (equals != std::string_view::npos && same(word.substr(0, equals), key))
            return unquoted(word.substr(equals + 1));
        words.remove_prefix(word.size());
    }
}

KeyNumber number_of(std::string_view words, std::string_view key) {
    const auto text = value_of(words, key);
    if (!text) return {};
    const char* const end = text->data() + text->size();
    const Number number = read_number(text->data(), end, true);
    const bool whole = !text->empty() && number.end == end;
    if (!whole || !(std::abs(number.value) <= largest_setting)) return {.named = true, .value = {}};
    return {.named = true, .value = number.value};
}

}  // namespace bead
