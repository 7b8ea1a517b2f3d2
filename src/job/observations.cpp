#include "job/observations.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <map>
#include <span>

#include "core/error.h"
#include "job/csv_table.h"
#include "job/one_line.h"

namespace bead {
namespace {

struct EnergyColumn {
    std::string_view name;
    double joules;  // of one
};
constexpr std::array energy_columns{
    EnergyColumn{"energy_mj", 1e-3}, EnergyColumn{"energy_mws", 1e-3},  EnergyColumn{"energy_j", 1},
    EnergyColumn{"energy_wh", 3600}, EnergyColumn{"energy_kwh", 3.6e6},
};
constexpr std::array<std::string_view, 4> feature_columns{"a_mm2_per_s2", "b_mm2_per_s2", "c_mm",
                                                          "h_s"};
constexpr std::array<std::string_view, 3> group_columns{"group", "geometry", "shape"};

std::string lower(std::string text) {
    std::ranges::transform(text, text.begin(), [](unsigned char c) { return std::tolower(c); });
    return text;
}

// Where each column stands.
class Header {
  public:
    explicit Header(const CsvTable& table) : table_(table) {
        if (table.rows.empty())
            throw Error(table.name +
                        ": is empty; the first line names the columns (docs/calibrate.md)");
        const CsvRow& head = table.rows.front();
        for (std::size_t i = 0; i < head.cells.size(); ++i)
            if (!places_.emplace(lower(head.cells[i]), i).second && !head.cells[i].empty())
                throw Error(fmt::format("{}: has two columns {}; keep one", place_of(table, head),
                                        one_line(head.cells[i])));
    }
    [[nodiscard]] bool has(std::string_view column) const { return places_.contains(column); }
    void require(std::string_view column) const {
        if (!has(column))
            throw Error(fmt::format(
                "{}: has no column {}; needed are {} and an energy, or gcode "
                "and an energy",
                place_of(table_, table_.rows.front()), column, fmt::join(feature_columns, ", ")));
    }
    [[nodiscard]] const std::string& cell(const CsvRow& row, std::string_view column) const {
        const std::string& text = row.cells[places_.find(column)->second];
        if (text.empty())
            throw Error(fmt::format("{}: {} is empty; fill it in or leave the row out",
                                    place_of(table_, row), column));
        return text;
    }
    [[nodiscard]] double number(const CsvRow& row, std::string_view column, bool zero) const {
        const std::string& text = cell(row, column);
        const std::optional<double> value = number_in(text);
        if (!value)
            throw Error(fmt::format(
                "{}: {} is {}, which is no number that can be meant (decimals take a point)",
                place_of(table_, row), column, one_line(text)));
        if (*value < 0 || (*value == 0 && !zero))
            throw Error(fmt::format("{}: {} is {}, but must {}; correct it or leave the row out",
                                    place_of(table_, row), column, one_line(text),
                                    zero ? "not be negative" : "be above 0"));
        return *value;
    }
    [[nodiscard]] std::optional<double> optional(const CsvRow& row, std::string_view column,
                                                 bool zero) const {
        return has(column) ? std::optional(number(row, column, zero)) : std::nullopt;
    }

  private:
    const CsvTable& table_;
    std::map<std::string, std::size_t, std::less<>> places_;
};

EnergyColumn energy_column(const CsvTable& table, const Header& header) {
    const EnergyColumn* found = nullptr;
    for (const EnergyColumn& column : energy_columns)
        if (header.has(column.name)) {
            if (found != nullptr)
                throw Error(fmt::format("{}: columns {} and {} both give the energy; keep one",
                                        place_of(table, table.rows.front()), found->name,
                                        column.name));
            found = &column;
        }
    if (found == nullptr) header.require("energy_mj");
    return *found;
}

Features features_in(const Header& header, const CsvRow& row) {
    Features f;
    const std::array<double*, 4> values{&f.A, &f.B, &f.C, &f.H};
    for (std::size_t i = 0; i < values.size(); ++i)
        *values[i] = header.number(row, feature_columns[i], true);
    return f;
}

void check_times(const Observation& seen) {
    if (!seen.duration || seen.features->H <= 2 * *seen.duration * (1 + 1e-6)) return;
    throw Error(
        fmt::format("{}: h_s {} is more than both axes have in duration_s {}; one of them "
                    "is wrong",
                    seen.name, seen.features->H, *seen.duration));
}

std::string group_in(const Header& header, const CsvRow& row) {
    for (const std::string_view column : group_columns)
        if (header.has(column)) return header.cell(row, column);
    return "";
}

ObservedPrint print_in(const CsvTable& table, const Header& header, const CsvRow& row,
                       const EnergyColumn& energy) {
    if (row.cells.size() != table.rows.front().cells.size())
        throw Error(
            fmt::format("{}: has {} cells where the header has {}; is one missing, or a "
                        "number written with a comma?",
                        place_of(table, row), row.cells.size(), table.rows.front().cells.size()));
    ObservedPrint print;
    print.seen.name = place_of(table, row);
    print.seen.group = group_in(header, row);
    print.seen.energy = header.number(row, energy.name, false) * energy.joules;
    print.seen.duration = header.optional(row, "duration_s", false);
    print.seen.filament = header.optional(row, "filament_g", true);
    print.seen.heat_ups = header.optional(row, "heat_ups", true);
    if (header.has("gcode")) {
        const auto folder = std::filesystem::path(table.name).parent_path();
        print.gcode = (folder / header.cell(row, "gcode")).string();
        return print;
    }
    if (!header.has(feature_columns.front())) return print;
    print.seen.features = features_in(header, row);
    if (print.seen.duration) print.seen.features->axis_time = 2 * *print.seen.duration;
    check_times(print.seen);
    return print;
}

ObservationTable observations_in(const CsvTable& table) {
    const Header header(table);
    ObservationTable result;
    result.of_files = header.has("gcode");
    const bool timed = header.has("duration_s") && header.has("filament_g");
    const bool any_feature =
        std::ranges::any_of(feature_columns, [&](auto column) { return header.has(column); });
    const bool featured = any_feature || !timed;
    if (!result.of_files && featured)
        for (const std::string_view column : feature_columns) header.require(column);
    const EnergyColumn energy = energy_column(table, header);
    result.kind = fmt::format("{}, energy by column {}",
                              result.of_files ? "G-code files, by column gcode"
                              : featured      ? "features, by columns a_mm2_per_s2 …"
                                              : "times and filament, by column duration_s",
                              energy.name);
    if (table.rows.size() == 1)
        throw Error(table.name + ": has a header but no rows; add a row per measured print");
    for (std::size_t i = 1; i < table.rows.size(); ++i)
        result.prints.push_back(print_in(table, header, table.rows[i], energy));
    return result;
}

}  // namespace

ObservationTable read_observations(const std::string& file) {
    return observations_in(read_csv(file));
}

ObservationTable parsed_observations(std::string_view text, const std::string& name) {
    return observations_in(parsed_csv(text, name));
}

}  // namespace bead
