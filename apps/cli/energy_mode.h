// Three ways of telling an energy, never mixed in one result: docs/energy.md.
#pragma once
#include <array>
#include <string_view>

namespace bead::cli {

enum class EnergyMode { published, corrected, physics };

inline constexpr std::array<std::string_view, 3> energy_mode_names{"published", "corrected",
                                                                   "physics"};
constexpr std::string_view name_of(EnergyMode mode) {
    return energy_mode_names[static_cast<std::size_t>(mode)];
}
constexpr std::string_view about(EnergyMode mode) {
    constexpr std::array<std::string_view, 3> words{
        "X and Y motors by Eq. 28 of Somade (2023), to compare with the publication",
        "X and Y motors by the published coefficients, standing power always charged",
        "the whole machine, at the wall"};
    return words[static_cast<std::size_t>(mode)];
}

}  // namespace bead::cli
