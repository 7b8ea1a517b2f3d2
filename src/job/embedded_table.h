// A .csv of data/ inside the program: a line of names, then rows. Cells hold no quotes and no
// commas.
//
//     const EmbeddedTable table("somade2023/doe300.csv");
//     for (const auto& row : table.rows()) sum += table.number(row, "energy_mWs").value_or(0);
#pragma once
#include <optional>
#include <string_view>
#include <vector>

namespace bead {

class EmbeddedTable {
  public:
    using Row = std::vector<std::string_view>;

    // The file and its columns are the program's own: what is not there is a bug.
    explicit EmbeddedTable(std::string_view path);
    [[nodiscard]] const std::vector<Row>& rows() const { return rows_; }
    [[nodiscard]] std::string_view text(const Row& row, std::string_view column) const;
    // Nothing where the cell is blank.
    [[nodiscard]] std::optional<double> number(const Row& row, std::string_view column) const;

  private:
    Row names_;
    std::vector<Row> rows_;
};

}  // namespace bead
