// A G-code file layer by layer, each with its text as it stands there and with what the text comes
// to: for whoever writes the layer's motion anew and everything else as it was. Memory is bounded
// by the largest layer. A layer begins with the comment that announces it; in a file without such
// comments, with its first bead at a new height. What comes before the first one is a piece of its
// own, of no layer; the end code belongs to the last.
//
//     LayerReader reader(open_text(file).source, {.name = file});
//     while (const auto layer = reader.next()) out << layer->text;      // the file, byte for byte
#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "gcode/file_state.h"
#include "gcode/reader.h"
#include "gcode/text_source.h"

namespace bead {

enum class LineUse : std::uint8_t {
    motion,   // moves, also of the filament alone; G92 E
    recoil,   // G10, G11
    remark,   // blank or comment
    feature,  // comment that names feature or bead
    limits,   // acceleration and the like
    fan,
    aside,  // for the display: nothing waits for it, it changes nothing
    other,  // whatever must stay in its place: heat, pauses, tools, macros, …
};

struct FileLine {
    std::uint32_t text_end = 0;   // behind its line end
    std::uint32_t moves_end = 0;  // behind its moves
    LineUse use = LineUse::other;
    bool odd_arc = false;  // not in the plane of X and Y, or of more than one turn
    double value = 0;      // duty of a fan; acceleration (mm/s²) of limits, 0 if they name none
};

struct FileMove {
    Position to{};        // mm, as the file counts
    double filament = 0;  // mm that it feeds
    double feed = 0;      // mm/s
    Role role = Role::travel;
    Bead bead;  // as far as it is known
};

struct FileLayer {
    std::string text;
    std::vector<FileLine> lines;
    std::vector<FileMove> moves;  // arcs as chords within 5 µm
    FileState before, after;
    double fan = 0;               // duty before
    std::int64_t first_line = 1;  // of the file
    std::optional<LayerStart> layer;
};

std::string_view text_of(const FileLayer& layer, std::size_t line);

class LayerReader {
  public:
    // Throws Error as read_gcode does, now or while reading; also for an arc whose radius is beyond
    // 100 m or whose end is not on its circle.
    LayerReader(TextSource source, const ReadOptions& options);
    ~LayerReader();
    LayerReader(const LayerReader&) = delete;
    LayerReader& operator=(const LayerReader&) = delete;

    // Nothing after the last one.
    std::optional<FileLayer> next();
    [[nodiscard]] std::int64_t bytes() const;  // read so far
    GcodeReport finish();                      // after the last one

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace bead
