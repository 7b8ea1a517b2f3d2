// Any bytes read as G-code end in commands or an Error, by every firmware's rules, the same for
// small and large chunks; and what was read can be written. The first byte says whose rules.
#include <cstdint>
#include <cstdlib>
#include <sstream>
#include <string>
#include <vector>

#include "core/error.h"
#include "gcode/read_source.h"
#include "gcode/writer.h"

namespace {

std::vector<bead::Command> commands_in(const std::string& bytes, bead::Firmware firmware,
                                       std::size_t chunk) {
    std::istringstream text(bytes);
    std::vector<bead::Command> commands;
    try {
        bead::read_source(bead::stream_source(text), {.firmware = firmware},
                          {.chunk = chunk, .longest = 1 << 16},
                          [&](const bead::Command& command) { commands.push_back(command); });
    } catch (const bead::Error&) {
        commands.clear();
    }
    return commands;
}

}  // namespace

// NOLINTNEXTLINE(readability-identifier-naming): libFuzzer's name
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0) return 0;
    const auto firmware = bead::Firmware(data[0] % bead::firmware_names.size());
    const std::string bytes(reinterpret_cast<const char*>(data) + 1, size - 1);
    const std::vector<bead::Command> commands = commands_in(bytes, firmware, 1 << 16);
    if (commands_in(bytes, firmware, 7).size() != commands.size()) std::abort();
    for (const bool relative : {false, true}) {
        std::ostringstream text;
        bead::GcodeWriter writer(text, {.relative_e = relative});
        for (const bead::Command& command : commands) writer.write(command);
        if (commands_in(text.str(), firmware, 1 << 16).size() > commands.size()) std::abort();
    }
    return 0;
}
