#include "gcode/reader.h"

#include "gcode/interpreter.h"
#include "gcode/read_source.h"

namespace bead {

GcodeReport read_source(const TextSource& source, const ReadOptions& options,
                        const LineLimits& limits, const CommandSink& sink) {
    Interpreter interpreter(options, sink);
    LineReader reader(source, options.name, limits);
    while (true) {
        const std::string_view lines = reader.next(interpreter.lines());
        if (lines.empty()) break;
        interpreter.read_lines(lines);
    }
    GcodeReport report = interpreter.finish();
    report.bytes = reader.bytes();
    return report;
}

GcodeReport read_gcode(std::istream& text, const ReadOptions& options, const CommandSink& sink) {
    return read_source(stream_source(text), options, {}, sink);
}

GcodeReport read_gcode(const std::filesystem::path& file, ReadOptions options,
                       const CommandSink& sink) {
    const OpenedText text = open_text(file);
    options.name = file.string();
    if (!text.part.empty()) options.name += " (" + text.part + ")";
    GcodeReport report = read_source(text.source, options, {}, sink);
    report.part = text.part;
    return report;
}

GcodeReport read_gcode(const std::filesystem::path& file, const CommandSink& sink) {
    return read_gcode(file, ReadOptions{}, sink);
}

}  // namespace bead
