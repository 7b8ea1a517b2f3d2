#include "job/power_log.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <chrono>

#include "core/error.h"
#include "job/csv_table.h"
#include "job/one_line.h"

namespace bead {
namespace {

constexpr std::size_t fewest = 10;
constexpr double most_watts = 1e5;

// Reads ISO 8601 from left to right.
class Letters {
  public:
    explicit Letters(std::string_view text) : text_(text) {}
    std::optional<int> digits(std::size_t count) {
        if (text_.size() < count) return std::nullopt;
        int value = 0;
        for (std::size_t i = 0; i < count; ++i) {
            if (std::isdigit(static_cast<unsigned char>(text_[i])) == 0) return std::nullopt;
            value = value * 10 + (text_[i] - '0');
        }
        text_.remove_prefix(count);
        return value;
    }
    bool next(std::string_view any_of) {
        if (text_.empty() || any_of.find(text_.front()) == std::string_view::npos) return false;
        last_ = text_.front();
        text_.remove_prefix(1);
        return true;
    }
    [[nodiscard]] char last() const { return last_; }
    [[nodiscard]] bool at_end() const { return text_.empty(); }

  private:
    std::string_view text_;
    char last_ = 0;
};

std::optional<double> days_as_seconds(Letters& text) {
    const auto year = text.digits(4);
    if (!year || !text.next("-")) return std::nullopt;
    const auto month = text.digits(2);
    if (!month || !text.next("-")) return std::nullopt;
    const auto day = text.digits(2);
    if (!day) return std::nullopt;
    const std::chrono::year_month_day date{std::chrono::year(*year),
                                           std::chrono::month(unsigned(*month)),
                                           std::chrono::day(unsigned(*day))};
    if (!date.ok()) return std::nullopt;
    return 86400 * double(std::chrono::sys_days(date).time_since_epoch().count());
}

std::optional<double> clock_as_seconds(Letters& text) {
    const auto hour = text.digits(2);
    if (!hour || *hour > 23 || !text.next(":")) return std::nullopt;
    const auto minute = text.digits(2);
    if (!minute || *minute > 59) return std::nullopt;
    double seconds = 3600.0 * *hour + 60.0 * *minute;
    if (!text.next(":")) return seconds;
    const auto second = text.digits(2);
    if (!second || *second > 60) return std::nullopt;
    seconds += *second;
    if (!text.next(".,")) return seconds;
    for (double unit = 0.1;; unit /= 10) {
        const auto digit = text.digits(1);
        if (!digit) return seconds;
        seconds += *digit * unit;
    }
}

// Of the offset from UTC, to be taken off; local time without one is as good, as only differences
// count.
std::optional<double> offset_as_seconds(Letters& text) {
    if (text.at_end() || text.next("Zz")) return 0;
    if (!text.next("+-")) return std::nullopt;
    const double sign = text.last() == '-' ? -1 : 1;
    const auto hours = text.digits(2);
    if (!hours) return std::nullopt;
    text.next(":");
    const auto minutes = text.at_end() ? std::optional(0) : text.digits(2);
    if (!minutes) return std::nullopt;
    return sign * (3600.0 * *hours + 60.0 * *minutes);
}

std::optional<double> time_in(std::string_view cell) {
    if (const auto seconds = number_in(cell)) return seconds;
    Letters text(cell);
    const auto days = days_as_seconds(text);
    if (!days || !text.next("Tt ")) return std::nullopt;
    const auto clock = clock_as_seconds(text);
    if (!clock) return std::nullopt;
    const auto offset = offset_as_seconds(text);
    if (!offset || !text.at_end()) return std::nullopt;
    return *days + *clock - *offset;
}

bool says_nothing(std::string_view cell) {
    return cell.empty() || cell == "unavailable" || cell == "unknown" || cell == "nan" ||
           cell == "NaN";
}

double watts_in(const CsvTable& table, const CsvRow& row) {
    const std::string& cell = row.cells[1];
    const auto watts = number_in(cell);
    if (!watts)
        throw Error(fmt::format("{}: {} is no power in watts (decimals take a point)",
                                place_of(table, row), one_line(cell)));
    if (*watts < 0 || *watts > most_watts)
        throw Error(fmt::format("{}: {} W is not what a printer draws; is the column in watts?",
                                place_of(table, row), one_line(cell)));
    return *watts;
}

PowerSample sample_in(const CsvTable& table, const CsvRow& row) {
    const auto time = time_in(row.cells[0]);
    if (!time)
        throw Error(fmt::format("{}: {} is no time; write seconds or 2026-03-01T12:00:00Z",
                                place_of(table, row), one_line(row.cells[0])));
    return {*time, says_nothing(row.cells[1]) ? -1 : watts_in(table, row)};
}

void check_clock(const CsvTable& table, const CsvRow& row, double time, double last) {
    if (time >= last) return;
    throw Error(
        fmt::format("{}: the clock goes back by {:.3g} s (was it set, or did summer time "
                    "end?); cut the log there or correct the times",
                    place_of(table, row), last - time));
}

PowerLog log_in(const CsvTable& table) {
    PowerLog log;
    std::vector<PowerSample> samples;
    double last = 0;
    for (std::size_t i = 0; i < table.rows.size(); ++i) {
        const CsvRow& row = table.rows[i];
        if (row.cells.size() != 2)
            throw Error(fmt::format("{}: has {} columns; a power log has two, time and watts",
                                    place_of(table, row), row.cells.size()));
        if (i == 0 && !time_in(row.cells[0])) continue;  // the header
        const PowerSample sample = sample_in(table, row);
        if (!samples.empty() || log.missing > 0) check_clock(table, row, sample.time, last);
        last = sample.time;
        if (sample.watts < 0)
            ++log.missing;
        else
            samples.push_back(sample);
    }
    if (samples.size() < fewest || samples.front().time == samples.back().time)
        throw Error(
            fmt::format("{}: has {} samples of power at different times; at least {} are "
                        "needed, better one every few seconds",
                        table.name, samples.size(), fewest));
    log.trace = power_trace(std::move(samples));
    return log;
}

}  // namespace

PowerLog read_power_log(const std::string& file) { return log_in(read_csv(file)); }

PowerLog parsed_power_log(std::string_view text, const std::string& name) {
    return log_in(parsed_csv(text, name));
}

}  // namespace bead
