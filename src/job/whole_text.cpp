#include "job/whole_text.h"

#include <filesystem>
#include <fstream>
#include <sstream>

#include "core/error.h"

namespace bead {

std::string whole_text(const std::string& file) {
    std::error_code fault;
    std::ifstream stream(file, std::ios::binary);
    if (!stream || std::filesystem::is_directory(file, fault))
        throw Error(file + ": cannot be read; is the path right?");
    std::ostringstream text;
    text << stream.rdbuf();
    return std::move(text).str();
}

}  // namespace bead
