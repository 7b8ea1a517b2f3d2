#include "gcode/slicer_notes.h"

#include <algorithm>
#include <fstream>
#include <string_view>
#include <vector>

#include "gcode/number.h"
#include "gcode/text_source.h"
#include "gcode/time_text.h"

namespace bead {
namespace {

constexpr std::size_t top_size = 128 * 1024, end_size = 128 * 1024;  // bytes

struct Ends {
    std::string top, end;  // may overlap in a short file
};

Ends ends_of_stream(const TextSource& source) {
    Ends ends;
    std::vector<char> piece(end_size);
    while (const std::size_t count = source(piece)) {
        const std::size_t wanted = std::min(count, top_size - ends.top.size());
        ends.top.append(piece.data(), wanted);
        ends.end.append(piece.data(), count);
        if (ends.end.size() > end_size) ends.end.erase(0, ends.end.size() - end_size);
    }
    return ends;
}

std::string part(std::ifstream& file, std::size_t from, std::size_t size) {
    std::string text(size, '\0');
    file.seekg(std::streamoff(from));
    file.read(text.data(), std::streamsize(size));
    text.resize(std::size_t(file.gcount()));
    file.clear();
    return text;
}

// Gzipped, an archive or binary G-code: only its source knows where the text ends.
bool is_packed(const std::string& start) {
    return start.starts_with("\x1f\x8b") || start.starts_with("PK") || start.starts_with("GCDE");
}

Ends ends_of(const std::filesystem::path& path) {
    const TextSource source = file_source(path);  // complains if there is no such file
    std::ifstream file(path, std::ios::binary);
    if (!std::filesystem::is_regular_file(path) || is_packed(part(file, 0, 4)))
        return ends_of_stream(source);
    const auto size = std::size_t(std::filesystem::file_size(path));
    const std::size_t end = std::min(size, end_size);
    return {part(file, 0, top_size), part(file, size - end, end)};
}

std::string_view first_line(std::string_view text) {
    return text.substr(0, text.find_first_of("\r\n"));
}

// What follows the key, to the end of its line; the key starts a line.
std::optional<std::string_view> value_of(std::string_view text, std::string_view key) {
    for (auto at = text.find(key); at != std::string_view::npos; at = text.find(key, at + 1))
        if (at == 0 || text[at - 1] == '\n') return first_line(text.substr(at + key.size()));
    return {};
}

bool is_name(std::string_view text) {
    return !text.empty() && std::ranges::all_of(text, [](char c) {
        return (c >= 'a' && c <= 'z') || is_digit(c) || c == '_';
    });
}

// Lines of the form "; name = value"; of several of one name the first counts.
void take_settings(SlicerNotes& notes, std::string_view text) {
    constexpr std::string_view start = "; ", equals = " =";
    while (!text.empty()) {
        const std::string_view line = first_line(text);
        const auto next = text.find('\n');
        text.remove_prefix(next == std::string_view::npos ? text.size() : next + 1);
        const auto middle = line.find(equals);
        if (!line.starts_with(start) || middle == std::string_view::npos) continue;
        const std::string_view name = line.substr(start.size(), middle - start.size());
        if (!is_name(name)) continue;
        std::string_view value = line.substr(middle + equals.size());
        if (value.starts_with(' ')) value.remove_prefix(1);
        notes.settings.emplace(name, value);
    }
}

// Bambu Studio's block of settings; whatever else stands at the top may mean anything.
std::string_view settings_at_top(std::string_view top) {
    const auto begin = top.find("\n; CONFIG_BLOCK_START");
    if (begin == std::string_view::npos) return {};
    top.remove_prefix(begin + 1);
    return top.substr(0, top.find("\n; CONFIG_BLOCK_END"));
}

std::optional<double> first_number(std::string_view text) {
    const Number number = read_number(text.data(), text.data() + text.size(), false);
    if (number.end == text.data() || !(number.value > 0 && number.value < 1e9)) return {};
    return number.value;
}

// "; model printing time: 13m 4s; total estimated time: 19m 33s"
std::optional<double> bambu_estimate(const Ends& ends) {
    constexpr std::string_view total = "total estimated time: ";
    const auto line = value_of(ends.top, "; model printing time: ");
    if (!line || line->find(total) == std::string_view::npos) return {};
    return time_in(line->substr(line->find(total) + total.size()));
}

// Where nobody filled the header in, CuraEngine alone leaves 6666 there; its layers then tell the
// time.
std::optional<double> cura_estimate(const Ends& ends) {
    constexpr double placeholder = 6666;
    constexpr std::string_view elapsed = "\n;TIME_ELAPSED:";
    const auto told = value_of(ends.top, ";TIME:");
    const auto seconds = told ? first_number(*told) : std::nullopt;
    const auto last = ends.end.rfind(elapsed);
    if (seconds != placeholder || last == std::string::npos) return seconds;
    return first_number(std::string_view(ends.end).substr(last + elapsed.size()));
}

std::optional<double> estimate_in(const Ends& ends) {
    if (const auto prusa = value_of(ends.end, "; estimated printing time (normal mode) = "))
        return time_in(*prusa);
    if (const auto bambu = bambu_estimate(ends)) return bambu;
    return cura_estimate(ends);
}

}  // namespace

SlicerNotes slicer_notes(const std::filesystem::path& file) {
    const Ends ends = ends_of(file);
    SlicerNotes notes;
    take_settings(notes, ends.end);
    take_settings(notes, settings_at_top(ends.top));
    notes.estimate = estimate_in(ends);
    return notes;
}

}  // namespace bead
