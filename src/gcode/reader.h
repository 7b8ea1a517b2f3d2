// G-code text to commands, from any slicer, each firmware in its dialect: what Marlin, Prusa's
// firmware, Klipper and RepRapFirmware make of the same words. The text is read in chunks of
// bounded size; numbers are read exactly and by no locale. Understood: G0 to G5, G10 and G11, the
// planes, units and modes, heaters, fan, limits, Klipper's SET_VELOCITY_LIMIT, and the comments by
// which slicers name features, layers and beads (comments.h). The rest is counted, not guessed at;
// docs/gcode.md says what counts as what.
//
// Throws Error for input that is not G-code at all: a NUL byte, a line longer than 1 MB (unless a
// comment makes it so), nothing that moves in the whole file; and for a number that is out of
// range: X, Y or Z beyond 1e6 mm, any other beyond 1e9. A layer in which nothing happens is not
// told.
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
    std::map<std::string, std::int64_t> ignored;  // command, why -> how often, {"M117", 12}
    std::int64_t malformed = 0;                   // lines that are not as they should be
    std::int64_t first_malformed = 0;             // its line
    std::string slicer;                           // e.g. "PrusaSlicer", "Cura", "" if unknown
    std::string dialect;  // whose rules it was read by at last, e.g. "klipper", "RepRapFirmware"
    std::string part;     // the file within the archive, "" if none
};

GcodeReport read_gcode(std::istream& text, const ReadOptions& options, const CommandSink& sink);
// Opens the file (also .gcode.gz, .gcode.3mf) and reads it; errors call it by its path.
GcodeReport read_gcode(const std::filesystem::path& file, ReadOptions options,
                       const CommandSink& sink);
GcodeReport read_gcode(const std::filesystem::path& file, const CommandSink& sink);

}  // namespace bead
