#include "gcode/slicer_limits.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "gcode/number.h"
#include "gcode/text_source.h"

namespace bead {
namespace {

constexpr std::size_t top_size = 16 * 1024, end_size = 128 * 1024;  // bytes

struct Ends {
    std::string top, end;  // may overlap in a short file
};

Ends ends_of_stream(const TextSource& source) {
    Ends ends;
    std::vector<char> piece(end_size);
    while (const std::size_t count = source(piece)) {
        ends.end.append(piece.data(), count);
        if (ends.top.size() < top_size) ends.top += ends.end.substr(0, top_size);
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

Ends ends_of(const std::filesystem::path& path) {
    const TextSource source = file_source(path);  // complains if there is no such file
    std::ifstream file(path, std::ios::binary);
    if (part(file, 0, 2) == "\x1f\x8b" || !std::filesystem::is_regular_file(path))
        return ends_of_stream(source);
    const auto size = std::size_t(std::filesystem::file_size(path));
    const std::size_t end = std::min(size, end_size);
    return {part(file, 0, top_size), part(file, size - end, end)};
}

// What follows the key, to the end of its line; the key starts a line.
std::optional<std::string_view> value_of(std::string_view text, std::string_view key) {
    for (auto at = text.find(key); at != std::string_view::npos; at = text.find(key, at + 1)) {
        if (at > 0 && text[at - 1] != '\n') continue;
        const std::string_view rest = text.substr(at + key.size());
        return rest.substr(0, rest.find_first_of("\r\n"));
    }
    return {};
}

std::optional<double> first_number(std::string_view text) {
    const Number number = read_number(text.data(), text.data() + text.size(), false);
    if (number.end == text.data() || !(number.value > 0 && number.value < 1e9)) return {};
    return number.value;
}

std::optional<double> setting(const Ends& ends, const std::string& name) {
    const auto value = value_of(ends.end, "; " + name + " = ");
    return value ? first_number(*value) : std::nullopt;
}

PerAxis<std::optional<double>> axis_settings(const Ends& ends, const std::string& name) {
    return {setting(ends, name + "_x"), setting(ends, name + "_y"), setting(ends, name + "_z"),
            setting(ends, name + "_e")};
}

bool names_any(const SetLimits& limits) {
    using Values = PerAxis<std::optional<double>>;
    return limits.max_acceleration != Values{} || limits.max_feedrate != Values{} ||
           limits.jerk != Values{} || limits.acceleration || limits.retract_acceleration ||
           limits.travel_acceleration;
}

// "1d 2h 3m 4s" in s.
std::optional<double> duration_in(std::string_view text) {
    constexpr std::array<std::pair<char, double>, 4> units{
        {{'d', 86400}, {'h', 3600}, {'m', 60}, {'s', 1}}};
    std::optional<double> seconds;
    const char* at = text.data();
    const char* const end = at + text.size();
    while (at != end) {
        const Number number = read_number(at, end, false);
        if (number.end == at) {
            ++at;
            continue;
        }
        at = number.end;
        for (const auto& [letter, unit] : units)
            if (at != end && *at == letter) seconds = seconds.value_or(0) + number.value * unit;
    }
    return seconds;
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

}  // namespace

std::optional<SetLimits> slicer_limits(const std::filesystem::path& file) {
    const Ends ends = ends_of(file);
    if (value_of(ends.end, "; machine_limits_usage = ") == "ignore") return {};
    SetLimits limits;
    limits.max_acceleration = axis_settings(ends, "machine_max_acceleration");
    limits.max_feedrate = axis_settings(ends, "machine_max_feedrate");
    limits.jerk = axis_settings(ends, "machine_max_jerk");
    limits.acceleration = setting(ends, "machine_max_acceleration_extruding");
    limits.retract_acceleration = setting(ends, "machine_max_acceleration_retracting");
    limits.travel_acceleration = setting(ends, "machine_max_acceleration_travel");
    if (!names_any(limits)) return {};
    return limits;
}

std::optional<double> slicer_estimate(const std::filesystem::path& file) {
    const Ends ends = ends_of(file);
    if (const auto prusa = value_of(ends.end, "; estimated printing time (normal mode) = "))
        return duration_in(*prusa);
    return cura_estimate(ends);
}

}  // namespace bead
