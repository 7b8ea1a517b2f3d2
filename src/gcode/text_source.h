// Bytes from a stream or from a file, packed (.gz, .gcode.3mf) or not, a piece at a time.
#pragma once
#include <cstddef>
#include <filesystem>
#include <functional>
#include <istream>
#include <span>
#include <string>

namespace bead {

// Fills some of the place from its start and returns how much; 0 at the end.
using TextSource = std::function<std::size_t(std::span<char> place)>;

TextSource stream_source(std::istream& text);  // the stream must outlive the source

struct OpenedText {
    TextSource source;
    std::string part;  // the file within an archive; "" if the file is none
};
// Throws Error here or later when the file cannot be read.
OpenedText open_text(const std::filesystem::path& file);
TextSource file_source(const std::filesystem::path& file);

}  // namespace bead
