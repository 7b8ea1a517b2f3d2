#include "job/nearest_name.h"

#include <algorithm>
#include <limits>
#include <tuple>
#include <vector>

namespace bead {
namespace {

constexpr std::size_t longest_name = 60;  // what is longer is no slip of the finger

struct Difference {
    std::size_t to_start = std::numeric_limits<std::size_t>::max();  // edits to how the name begins
    std::size_t to_all = std::numeric_limits<std::size_t>::max();    // edits to the whole name
    bool operator<(const Difference& other) const {
        return std::tie(to_start, to_all) < std::tie(other.to_start, other.to_all);
    }
};

char folded(char c) {
    if (c == '-' || c == ' ') return '_';
    return c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c;
}

// Levenshtein's distance, a row at a time; the last row holds the distance to every start of
// `name`.
Difference difference(std::string_view wrong, std::string_view name) {
    std::vector<std::size_t> row(name.size() + 1);
    for (std::size_t j = 0; j < row.size(); ++j) row[j] = j;
    for (std::size_t i = 0; i < wrong.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i + 1;
        for (std::size_t j = 0; j < name.size(); ++j) {
            const std::size_t swapped = diagonal + (folded(wrong[i]) != folded(name[j]) ? 1 : 0);
            diagonal = row[j + 1];
            row[j + 1] = std::min({swapped, diagonal + 1, row[j] + 1});
        }
    }
    return {*std::ranges::min_element(row), row.back()};
}

}  // namespace

std::string nearest_name(std::string_view wrong, std::span<const std::string_view> known) {
    if (wrong.empty() || wrong.size() > longest_name) return "";
    Difference least;
    std::string_view nearest;
    for (const std::string_view name : known) {
        const Difference found = difference(wrong, name);
        if (!(found < least)) continue;
        least = found;
        nearest = name;
    }
    const bool near = least.to_start <= wrong.size() / 3 || least.to_all <= 1;
    return std::string(near ? nearest : "");
}

std::string suggestion(std::string_view wrong, std::span<const std::string_view> known) {
    const std::string near = nearest_name(wrong, known);
    return near.empty() ? "" : "; did you mean " + near + "?";
}

}  // namespace bead
