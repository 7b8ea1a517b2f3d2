#include "job/resonance_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "core/error.h"
#include "job/csv_table.h"
#include "job/vibration_table.h"
#include "vibration/resonance.h"

namespace bead {
namespace {

constexpr double lowest = 5;  // Hz: what is below is the machine's way through the room

std::size_t column(const CsvTable& table, const std::string& name) {
    const std::vector<std::string>& head = table.rows.front().cells;
    const auto found = std::ranges::find(head, name);
    if (found == head.end())
        throw Error(fmt::format("{}: has no column {}; take the .csv that TEST_RESONANCES writes",
                                place_of(table, table.rows.front()), name));
    return std::size_t(found - head.begin());
}

double cell(const CsvTable& table, const CsvRow& row, std::size_t column) {
    const auto value = column < row.cells.size() ? number_in(row.cells[column]) : std::nullopt;
    if (!value)
        throw Error(fmt::format("{}: column {} is no number", place_of(table, row), column + 1));
    return *value;
}

}  // namespace

DriveMode resonance_of(const std::string& file, std::size_t axis) {
    const CsvTable table = read_csv(file);
    if (table.rows.empty()) throw Error(file + ": is empty; is it what TEST_RESONANCES wrote?");
    const std::size_t f = column(table, "freq"), p = column(table, axis == 0 ? "psd_x" : "psd_y");
    std::vector<double> frequency, power;
    for (std::size_t i = 1; i < table.rows.size(); ++i) {
        const double at = cell(table, table.rows[i], f);
        if (!frequency.empty() && at <= frequency.back())
            throw Error(place_of(table, table.rows[i]) + ": freq must grow from row to row");
        if (at < lowest || at > 2 * highest_mode) continue;
        frequency.push_back(at);
        power.push_back(cell(table, table.rows[i], p));
    }
    const auto mode = fitted_mode(frequency, power);
    if (!mode || mode->frequency > highest_mode || mode->damping >= 0.5)
        throw Error(
            fmt::format("{}: has no clear peak of {} between {:g} and {:g} Hz; say "
                        "--set vibration.frequency_hz=[…, …] instead",
                        file, "XY"[axis], lowest, highest_mode));
    return *mode;
}

}  // namespace bead
