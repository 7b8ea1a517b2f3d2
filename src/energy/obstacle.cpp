#include "energy/obstacle.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace bead {
namespace {

constexpr double worst_condition = 1e4;

double size_of_column(const Rows& rows, std::size_t column) {
    double sum = 0;
    for (const Row& row : rows) sum += row[column] * row[column];
    return std::sqrt(sum);
}

// A column and the one that it resembles most, given all the others.
struct Alike {
    double rest = 2;  // part of its size that the others leave
    std::size_t column = 0, other = 0;
};

Alike likeness(const Rows& rows, std::size_t column) {
    Rows others;
    std::vector<double> values;
    for (const Row& row : rows) {
        values.push_back(row[column]);
        others.push_back(row);
        others.back().erase(others.back().begin() + std::ptrdiff_t(column));
    }
    const LinearFit fit = fit_linear(others, values);
    Alike alike{std::sqrt(std::max(0.0, 1 - fit.r2)), column, column == 0 ? 1UL : 0UL};
    double largest = -1;
    for (std::size_t j = 0; j < fit.coefficients.size(); ++j) {
        const double share = std::abs(fit.coefficients[j]) * size_of_column(others, j);
        if (share <= largest) continue;
        largest = share;
        alike.other = j < column ? j : j + 1;
    }
    return alike;
}

}  // namespace

std::string lack_of(std::string_view column, const std::string& observation) {
    return fmt::format("{} has no {}; add that column for every print", observation, column);
}

std::string too_few(std::size_t prints, std::size_t coefficients) {
    const std::size_t more = coefficients - prints;
    return fmt::format(
        "{} print{} cannot determine {} coefficients; measure at least {} more, and some beyond "
        "that to know the error",
        prints, prints == 1 ? "" : "s", coefficients, more);
}

std::string indistinct_columns(const Rows& rows, std::span<const ModelColumn> columns) {
    for (std::size_t j = 0; j < columns.size(); ++j)
        if (size_of_column(rows, j) == 0)
            return fmt::format("{} ({}) is 0 in every print; add {}", columns[j].name,
                               columns[j].about, columns[j].varied_by);
    if (fit_linear(rows, std::vector<double>(rows.size(), 1)).condition < worst_condition)
        return "";
    Alike worst;
    for (std::size_t j = 0; j < columns.size(); ++j)
        if (const Alike alike = likeness(rows, j); alike.rest < worst.rest) worst = alike;
    const ModelColumn &one = columns[worst.column], &other = columns[worst.other];
    return fmt::format(
        "{} ({}) and {} ({}) rise and fall together in these prints, so their coefficients cannot "
        "be told apart; add {}, or {}",
        one.name, one.about, other.name, other.about, one.varied_by, other.varied_by);
}

}  // namespace bead
