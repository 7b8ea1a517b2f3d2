// Any bytes read as G-code end in commands or an Error, the same for small and large chunks; and
// what was read can be written.
#include <cstdint>
#include <cstdlib>
#include <sstream>
#include <string>
#include <vector>

#include "core/error.h"
#include "gcode/read_source.h"
#include "gcode/writer.h"

namespace {

std::vector<bead::Command> commands_in(const std::string& bytes, std::size_t chunk) {
    std::istringstream text(bytes);
    std::vector<bead::Command> commands;
    try {
        bead::read_source(bead::stream_source(text), {}, {.chunk = chunk},
                          [&](const bead::Command& command) { commands.push_back(command); });
    } catch (const bead::Error&) {
        commands.clear();
    }
    return commands;
}

}  // namespace

// NOLINTNEXTLINE(readability-identifier-naming): libFuzzer's name
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string bytes(reinterpret_cast<const char*>(data), size);
    const std::vector<bead::Command> commands = commands_in(bytes, 1 << 16);
    if (commands_in(bytes, 7).size() != commands.size()) std::abort();
    for (const bool relative : {false, true}) {
        std::ostringstream text;
        bead::GcodeWriter writer(text, {.relative_e = relative});
        for (const bead::Command& command : commands) writer.write(command);
        if (commands_in(text.str(), 1 << 16).size() > commands.size()) std::abort();
    }
    return 0;
}
