#include "job/csv_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "core/error.h"
#include "job/one_line.h"
#include "job/whole_text.h"

namespace bead {
namespace {

// The one of , ; and tab that the first row has most of.
char separator_in(std::string_view line) {
    char best = ',';
    std::ptrdiff_t most = 0;
    for (const char c : {',', ';', '\t'})
        if (const auto count = std::count(line.begin(), line.end(), c); count > most) {
            most = count;
            best = c;
        }
    return best;
}

std::vector<std::string> cells_of(std::string_view line, char separator) {
    std::vector<std::string> cells(1);
    bool quoted = false, was_quoted = false;
    const auto close = [&] {
        if (!was_quoted) cells.back() = std::string(trimmed(cells.back()));
        was_quoted = false;
    };
    for (std::size_t i = 0; i < line.size(); ++i) {
        const char c = line[i];
        if (c == '"') {
            if (quoted && i + 1 < line.size() && line[i + 1] == '"')
                cells.back() += line[i++];
            else if (quoted || trimmed(cells.back()).empty()) {
                if (!quoted) cells.back().clear();
                quoted = !quoted;
                was_quoted = true;
            } else
                cells.back() += c;
        } else if (c == separator && !quoted) {
            close();
            cells.emplace_back();
        } else if (quoted || !was_quoted) {
            cells.back() += c;
        }
    }
    close();
    return cells;
}

}  // namespace

CsvTable parsed_csv(std::string_view text, const std::string& name) {
    if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
    if (text.find('\0') != std::string_view::npos)
        throw Error(name + ": is not a text file; export the table as CSV in UTF-8");
    CsvTable table{name, {}};
    char separator = 0;
    for (std::size_t line = 1; !text.empty(); ++line) {
        const std::size_t end = text.find_first_of("\r\n");
        const std::string_view content = trimmed(text.substr(0, end));
        const std::string_view raw = text.substr(0, end);
        const bool two = end != std::string_view::npos && text.substr(end, 2) == "\r\n";
        text.remove_prefix(end == std::string_view::npos ? text.size() : end + (two ? 2 : 1));
        if (content.empty() || content.front() == '#') continue;
        if (separator == 0) separator = separator_in(raw);
        table.rows.push_back({line, cells_of(raw, separator)});
    }
    return table;
}

CsvTable read_csv(const std::string& file) { return parsed_csv(whole_text(file), file); }

std::string place_of(const CsvTable& table, const CsvRow& row) {
    return fmt::format("{}:{}", table.name, row.line);
}

std::optional<double> number_in(std::string_view cell) {
    if (cell.starts_with('+')) cell.remove_prefix(1);
    double value = 0;
    const auto [end, fault] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
    constexpr double most = 1e15;
    if (fault != std::errc() || end != cell.data() + cell.size() || !(std::abs(value) < most))
        return std::nullopt;
    return value;
}

}  // namespace bead
