#include "smooth/cell_table.h"

namespace bead {

CellTable sorted_by_cell(std::span<const CellEntry> entries, std::size_t cells) {
    CellTable table;
    table.starts.assign(cells + 1, 0);
    for (const CellEntry& entry : entries) ++table.starts[entry.cell + 1];
    for (std::size_t i = 1; i < table.starts.size(); ++i) table.starts[i] += table.starts[i - 1];
    table.numbers.resize(entries.size());
    std::vector<std::uint32_t> next(table.starts.begin(), table.starts.end() - 1);
    for (const CellEntry& entry : entries) table.numbers[next[entry.cell]++] = entry.number;
    return table;
}

}  // namespace bead
