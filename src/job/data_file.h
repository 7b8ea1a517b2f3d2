// Printers and materials can be named or be somebody's own file; this finds the text of either.
#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace bead {

struct DataFile {
    std::string place;  // for messages: the file, or the built-in name
    std::string text;
};

// `kind` is "printer" or "material". What ends in .toml is a file, anything else a built-in name.
// Throws Error: usage if there is no such name (it lists those there are), input if the file is
// unreadable.
DataFile data_file(std::string_view kind, const std::string& name_or_file);

// Throws Error if it cannot be read.
DataFile file_on_disk(std::string_view kind, const std::string& path);

// Built-in names, in the alphabet's order.
std::vector<std::string> data_names(std::string_view kind);

}  // namespace bead
