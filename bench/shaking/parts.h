// Sections to print: the engine block's, on which the ways of printing were tried, and those of
// other parts, on which nothing was.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "geom/polygon.h"

namespace bead::shaking {

struct Part {
    std::string name;
    Region section;
};

std::vector<Part> engine_block_sections();

// A gear, letters, two blobs: outlines made here.
std::vector<Part> drawn_parts();

// One section of a mesh at `share` of its height, put on 0; nothing, said on stderr, without the
// file.
std::optional<Part> section_of(const std::string& name, const std::string& file, double share);

}  // namespace bead::shaking
