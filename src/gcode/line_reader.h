// Text from a source to its lines, in bounded memory: the line that a chunk ends in is carried over
// to the next. Lines end in LF or CR LF; the last one may end in nothing.
#pragma once
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

#include "gcode/text_source.h"

namespace bead {

struct LineLimits {
    std::size_t chunk = std::size_t{1} << 20;    // bytes read at a time
    std::size_t longest = std::size_t{1} << 20;  // bytes of a line
};

// Calls on_line for every line, without its end, and returns the number of bytes read. Throws
// Error, with the input's name, for what cannot be G-code text: NUL bytes, a line that is too long.
std::int64_t for_each_line(const TextSource& source, const std::string& name,
                           const LineLimits& limits,
                           const std::function<void(std::string_view)>& on_line);

}  // namespace bead
