// A table of comma-, semicolon- or tab-separated values with what messages need: the file and line
// of each row. Blank lines and lines that start with # are passed over; cells may stand in double
// quotes; a byte-order mark and any line ends are understood.
//
//     const CsvTable table = read_csv("prints.csv");
//     const auto c = number_in(table.rows[1].cells[2]);
#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace bead {

struct CsvRow {
    std::size_t line = 0;
    std::vector<std::string> cells;  // trimmed
};

struct CsvTable {
    std::string name;  // of the file
    std::vector<CsvRow> rows;
};

// Throws Error if it cannot be read or is no text.
CsvTable read_csv(const std::string& file);
// `name` is what messages call the text.
CsvTable parsed_csv(std::string_view text, const std::string& name);

// "prints.csv:7"
std::string place_of(const CsvTable& table, const CsvRow& row);

// The whole cell as a finite number with a decimal point, of a size that can be meant (below 1e15).
std::optional<double> number_in(std::string_view cell);

}  // namespace bead
