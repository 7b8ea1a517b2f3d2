// The lines of a G-code file that speak of time, and where they are: progress (M73), the slicer's
// estimates, and our own signature in the head, the comments that a file starts with. Found without
// understanding the moves, in bounded memory: what is kept is these lines.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "gcode/text_source.h"

namespace bead {

enum class TimeWord : std::uint8_t {
    progress,          // M73 P0 R8
    total,             // ; estimated printing time (normal mode) = 8m 35s
    first_layer,       // ; estimated first layer printing time (normal mode) = 1m 2s
    with_preparation,  // ; model printing time: 8m 35s; total estimated time: 14m 1s
    cura_total,        // ;TIME:515
    cura_elapsed,      // ;TIME_ELAPSED:51.5
    prepared,          // ; MACHINE_START_GCODE_END
    layer,             // ;LAYER_CHANGE or ; CHANGE_LAYER, only the first two
    signature          // ; processed by beadwork …, ; beadwork: …, only in the head
};

struct TimeMark {
    TimeWord word{};
    std::int64_t line = 0;    // from 1
    std::int64_t offset = 0;  // of the line's first byte
    std::string text;         // the whole line, with its end
};

struct TimeMarks {
    std::vector<TimeMark> marks;  // in order
    std::int64_t head = 0;        // bytes of the comments at the start, up to a thumbnail
    std::string line_end = "\n";  // that of the first line
};

inline constexpr std::string_view signature_start = "; processed by beadwork ";
inline constexpr std::string_view remark_start = "; beadwork: ";

TimeMarks time_marks(const TextSource& source);

// A number of an M73 line that is time's: of P (per cent done) or R (minutes left).
struct ProgressNumber {
    char letter = 0;  // capital
    std::size_t begin = 0, size = 0;
    int decimals = 0;
};
// None for a line that is no M73, or one with a checksum, which must stay as it is.
std::vector<ProgressNumber> progress_numbers(std::string_view line);

}  // namespace bead
