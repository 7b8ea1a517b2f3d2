// The bytes of a file, all at once: for files of settings and tables, which are small.
#pragma once
#include <string>

namespace bead {

// Throws an Error that names the file where it cannot be read or is a folder.
std::string whole_text(const std::string& file);

}  // namespace bead
