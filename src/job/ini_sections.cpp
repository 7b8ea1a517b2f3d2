#include "job/ini_sections.h"

#include <fmt/format.h>

#include <algorithm>

#include "job/one_line.h"

namespace bead {
namespace {

constexpr std::string_view blanks = " \t";

std::string_view without_comment(std::string_view line) {
    line = line.substr(0, line.find('#'));
    for (auto at = line.find(';'); at != std::string_view::npos; at = line.find(';', at + 1))
        if (at == 0 || blanks.find(line[at - 1]) != std::string_view::npos)
            return line.substr(0, at);
    return line;
}

std::string small(std::string_view text) {
    std::string name(trimmed(text));
    for (char& c : name)
        if (c >= 'A' && c <= 'Z') c = char(c - 'A' + 'a');
    return name;
}

// The section that a line [name] opens, nothing for one that only includes a file.
IniSection* opened(IniSections& found, std::string_view line) {
    constexpr std::string_view include = "include ";
    const std::string_view name = trimmed(line.substr(1, line.find(']') - 1));
    if (!name.starts_with(include)) return &found.sections[std::string(name)];
    found.includes.emplace_back(trimmed(name.substr(include.size())));
    return nullptr;
}

}  // namespace

IniSections ini_sections(const DataFile& data) {
    IniSections found;
    IniSection* section = nullptr;
    std::string_view text = data.text;
    if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
    for (int number = 1; !text.empty(); ++number) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        const std::string_view line = without_comment(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
        if (trimmed(line).empty() || blanks.find(line[0]) != std::string_view::npos) continue;
        if (line[0] == '[') {
            section = opened(found, line);
            continue;
        }
        const std::size_t middle = line.find_first_of(":=");
        if (section == nullptr || middle == std::string_view::npos) continue;
        (*section)[small(line.substr(0, middle))] = {std::string(trimmed(line.substr(middle + 1))),
                                                     fmt::format("{}:{}", data.place, number)};
    }
    return found;
}

}  // namespace bead
