// The files of data/ inside the program, so that it needs none beside itself (made by
// cmake/modules.cmake).
#pragma once
#include <span>

namespace bead {

struct EmbeddedFile {
    const char* path;  // in data/, e.g. "printers/ender3.toml"
    const char* text;
};

std::span<const EmbeddedFile> embedded_files();

}  // namespace bead
