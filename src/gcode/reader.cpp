#include "gcode/reader.h"

#include "gcode/read_source.h"

namespace bead {

GcodeReport read_source(const TextSource& source, const ReadOptions& options,
                        const LineLimits& limits, const CommandSink& sink) {
    Interpreter interpreter(options, sink);
    const std::int64_t bytes = for_each_line(
        source, options.name, limits, [&](std::string_view line) { interpreter.read(line); });
    GcodeReport report = interpreter.finish();
    report.bytes = bytes;
    return report;
}

GcodeReport read_gcode(std::istream& text, const ReadOptions& options, const CommandSink& sink) {
    return read_source(stream_source(text), options, {}, sink);
}

GcodeReport read_gcode(const std::filesystem::path& file, ReadOptions options,
                       const CommandSink& sink) {
    options.name = file.string();
    return read_source(file_source(file), options, {}, sink);
}

GcodeReport read_gcode(const std::filesystem::path& file, const CommandSink& sink) {
    return read_gcode(file, ReadOptions{}, sink);
}

}  // namespace bead
