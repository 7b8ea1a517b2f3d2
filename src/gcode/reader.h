// G-code text to commands: what Marlin-like firmware understands, from any slicer. The text is read
// in chunks of bounded size; numbers are read exactly and by no locale. Understood: G0 G1 G4 G20
// G21 G28 G90 G91 G92 M82 M83 M104 M109 M140 M190 M106 M107 M201 M203 M204 M205 M400 and the
// comments by which slicers name features, layers and beads (comments.h). The rest is counted, not
// guessed at; docs/gcode.md says what counts as what.
//
// Throws Error for input that is not G-code at all: a NUL byte, a line longer than 1 MB, nothing
// that moves in the whole file; and for a number that is out of range: X, Y or Z beyond 1e6 mm, any
// other beyond 1e9. A layer in which nothing happens is not told.
#pragma once
#include <filesystem>
#include <istream>
#include <map>
#include <string>

#include "machine/firmware.h"
#include "toolpath/command.h"

namespace bead {

struct ReadOptions {
    std::string name = "G-code";          // what errors call the input
    double first_feed = 25;               // mm/s, before the first F word
    Firmware firmware = Firmware::prusa;  // by whose rules the text is read
};

struct GcodeReport {
    std::int64_t lines = 0;
    std::int64_t bytes = 0;
    std::map<std::string, std::int64_t> ignored;  // command word -> how often, e.g. {"M73", 12}
    std::int64_t malformed = 0;                   // lines with a word that is not a number
    std::int64_t first_malformed = 0;             // its line
    std::string slicer;                           // e.g. "PrusaSlicer", "Cura", "" if unknown
    std::string dialect;                          // whose rules it was read by at last
    std::string part;                             // the file within the archive, "" if none
};

GcodeReport read_gcode(std::istream& text, const ReadOptions& options, const CommandSink& sink);
// Opens the file (also .gcode.gz) and reads it; errors call it by its path.
GcodeReport read_gcode(const std::filesystem::path& file, ReadOptions options,
                       const CommandSink& sink);
GcodeReport read_gcode(const std::filesystem::path& file, const CommandSink& sink);

}  // namespace bead
