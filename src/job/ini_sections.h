// Klipper's form of an .ini file: [sections] of `name: value` or `name = value`. Comments begin
// with '#', or with ';' after a blank; an indented line belongs to the value before it and is
// passed over (it is some macro's G-code). Of two values with one name the later counts.
#pragma once
#include <map>
#include <string>
#include <vector>

#include "job/data_file.h"

namespace bead {

struct IniValue {
    std::string text;
    std::string place;  // "printer.cfg:12"
};

using IniSection = std::map<std::string, IniValue, std::less<>>;

struct IniSections {
    std::map<std::string, IniSection, std::less<>> sections;
    std::vector<std::string> includes;  // the names in [include …]
};

IniSections ini_sections(const DataFile& data);

}  // namespace bead
