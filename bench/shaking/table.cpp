#include "table.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace bead::shaking {
namespace {

constexpr std::array path_columns{"length, mm",       "extruded, mm",
                                  "travel, mm",       "infill with travel, mm",
                                  "infill alone, mm", "points",
                                  "turns 45°",        "windowed turns",
                                  "e_c (Eq. 31), mm", "travels across walls"};
constexpr std::array response_columns{
    time_name,     volume_name,    "rms, mm/s²",      "5-40 Hz, mm/s²",  "psd top 3",
    "dev max, mm", "dev mean, mm", "contour max, mm", "contour p99, mm", "contour mean, mm",
    "energy, J",   "CO2, g",       "off nominal"};

std::string text_of(const Change& change) {
    if (std::isnan(change.mean)) return "-";
    return fmt::format("{:+.1f}/{:+.1f}", change.mean, change.worst);
}

std::string mean_and_most(const std::vector<ShakingCell>& cells, const ShakingLine& line,
                          const std::string& column) {
    double sum = 0, most = 0;
    int count = 0;
    for (const ShakingCell& cell : cells) {
        if (cell.path != line.path || cell.law != line.law) continue;
        const auto found = std::ranges::find(cell.figures, column, &Figure::name);
        if (found == cell.figures.end()) continue;
        sum += found->value;
        most = std::max(most, found->value);
        ++count;
    }
    return count == 0 ? "-" : fmt::format("{:.1f}/{:.1f}", sum / count, most);
}

template <class Columns>
void print_header(const char* first, const Columns& columns) {
    fmt::print("| {} |", first);
    for (const char* column : columns) fmt::print(" {} |", column);
    fmt::print("\n|---|");
    for (const char* at = first; *at != 0; ++at)
        if (*at == '|') fmt::print("---|");
    for (std::size_t i = 0; i < columns.size(); ++i) fmt::print("---|");
    fmt::print("\n");
}

template <class Columns>
void print_line(const std::string& name, const ShakingTable& table, const ShakingLine& line,
                const Columns& columns) {
    fmt::print("| {} |", name);
    for (const char* column : columns) {
        const auto found = std::ranges::find(table.columns, column);
        const auto at = static_cast<std::size_t>(found - table.columns.begin());
        fmt::print(" {} |", found == table.columns.end() ? "-" : text_of(line.changes[at]));
    }
    fmt::print("\n");
}

}  // namespace

void print_paths(const ShakingTable& table) {
    print_header("path", path_columns);
    std::string last;
    for (const ShakingLine& line : table.lines)
        if (line.path != last) print_line(last = line.path, table, line, path_columns);
}

void print_responses(const std::vector<ShakingCell>& cells, const ShakingTable& table) {
    print_header("path, law | under, mm² | over, mm² | outside, mm²", response_columns);
    for (const ShakingLine& line : table.lines) {
        std::string name = line.path + " " + line.law;
        for (const char* column : {underfill_name, overfill_name, "outside, mm²"})
            name += " | " + mean_and_most(cells, line, column);
        print_line(name, table, line, response_columns);
    }
}

void print_figures(const std::vector<ShakingCell>& cells, const std::string& part,
                   const std::string& law) {
    std::vector<const ShakingCell*> shown;
    for (const ShakingCell& cell : cells)
        if (cell.part == part && cell.law == law) shown.push_back(&cell);
    if (shown.empty()) return;
    fmt::print("| {}, {} |", part, law);
    for (const ShakingCell* cell : shown) fmt::print(" {} |", cell->path);
    fmt::print("\n|---|");
    for (std::size_t i = 0; i < shown.size(); ++i) fmt::print("---|");
    fmt::print("\n");
    for (std::size_t i = 0; i < shown.front()->figures.size(); ++i) {
        fmt::print("| {} |", shown.front()->figures[i].name);
        for (const ShakingCell* cell : shown) fmt::print(" {:.5g} |", cell->figures[i].value);
        fmt::print("\n");
    }
}

}  // namespace bead::shaking
