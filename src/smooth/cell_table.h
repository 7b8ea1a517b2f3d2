// Numbers sorted by the cell of a raster that they belong to, in the order in which they came: all
// of one cell lie side by side. Two passes over the entries (a counting sort), no comparisons.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

namespace bead {

inline constexpr double most_cells = 4e6;  // of a raster: cells grow rather than become more

struct CellEntry {
    std::uint32_t cell, number;
};

struct CellTable {
    std::vector<std::uint32_t> starts;   // of each cell in `numbers`, and the end
    std::vector<std::uint32_t> numbers;  // of cell 0, of cell 1, …

    // Of the cells from `first` to `last`, both included.
    [[nodiscard]] std::span<const std::uint32_t> in(std::size_t first, std::size_t last) const {
        return std::span(numbers).subspan(starts[first], starts[last + 1] - starts[first]);
    }
};

// Cells are numbered from 0 to `cells` - 1.
CellTable sorted_by_cell(std::span<const CellEntry> entries, std::size_t cells);

}  // namespace bead
