#include "job/one_line.h"

#include <algorithm>

namespace bead {

std::string_view trimmed(std::string_view text) {
    constexpr std::string_view blank = " \t\r\n";
    const std::size_t first = text.find_first_not_of(blank);
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(blank) - first + 1);
}

std::string one_line(std::string_view text) {
    constexpr std::size_t longest = 120;
    if (text.empty()) return "(nothing)";
    std::size_t kept = std::min(text.size(), longest);
    // Not in the middle of a UTF-8 character.
    while (kept < text.size() && kept > 0 && (text[kept] & 0xC0) == 0x80) --kept;
    std::string line(text.substr(0, kept));
    std::ranges::replace_if(
        line, [](unsigned char c) { return c < 0x20 || c == 0x7F; }, '?');
    return kept < text.size() ? line + "…" : line;
}

}  // namespace bead
