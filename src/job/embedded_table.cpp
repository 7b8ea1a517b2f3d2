#include "job/embedded_table.h"

#include <algorithm>
#include <charconv>

#include "core/expects.h"
#include "job/embedded_files.h"

namespace bead {
namespace {

std::vector<std::string_view> split(std::string_view text, char at) {
    std::vector<std::string_view> parts;
    for (;;) {
        const std::size_t end = text.find(at);
        parts.push_back(text.substr(0, end));
        if (end == std::string_view::npos) return parts;
        text.remove_prefix(end + 1);
    }
}

}  // namespace

EmbeddedTable::EmbeddedTable(std::string_view path) {
    const auto files = embedded_files();
    const auto file = std::ranges::find(files, path, &EmbeddedFile::path);
    BEAD_EXPECTS(file != files.end());
    for (std::string_view line : split(file->text, '\n')) {
        if (line.ends_with('\r')) line.remove_suffix(1);
        if (line.empty()) continue;
        Row cells = split(line, ',');
        if (names_.empty()) {
            names_ = std::move(cells);
            continue;
        }
        BEAD_EXPECTS(cells.size() == names_.size());
        rows_.push_back(std::move(cells));
    }
}

std::string_view EmbeddedTable::text(const Row& row, std::string_view column) const {
    const auto name = std::ranges::find(names_, column);
    BEAD_EXPECTS(name != names_.end());
    return row[static_cast<std::size_t>(name - names_.begin())];
}

std::optional<double> EmbeddedTable::number(const Row& row, std::string_view column) const {
    const std::string_view cell = text(row, column);
    if (cell.empty()) return {};
    double value = 0;
    const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
    BEAD_EXPECTS(error == std::errc{} && end == cell.data() + cell.size());
    return value;
}

}  // namespace bead
