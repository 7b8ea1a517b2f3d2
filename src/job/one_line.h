// Text from a file or the command line, made fit to stand in a message of one line.
#pragma once
#include <string>
#include <string_view>

namespace bead {

// Without spaces, tabs and line ends around it.
std::string_view trimmed(std::string_view text);

// Control characters become '?', what is longer than 120 bytes is cut, nothing becomes "(nothing)".
std::string one_line(std::string_view text);

}  // namespace bead
