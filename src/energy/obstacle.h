// In words, why measured prints do not determine the coefficients of a model, and which prints to
// add so that they do.
#pragma once
#include <string>

#include "energy/energy_models.h"

namespace bead {

std::string lack_of(std::string_view column, const std::string& observation);
std::string too_few(std::size_t prints, std::size_t coefficients);

// "" if the columns can be told apart: scaled to equal size, their condition is below 10 000, at
// which an error of a per cent in one print throws coefficients off by many times themselves.
// Expects at least as many rows as columns.
std::string indistinct_columns(const Rows& rows, std::span<const ModelColumn> columns);

}  // namespace bead
