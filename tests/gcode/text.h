// Text in, commands out, for the tests of this folder.
#pragma once
#include <sstream>
#include <string>
#include <vector>

#include "gcode/reader.h"

namespace bead {

struct Reading {
    std::vector<Command> commands;
    GcodeReport report;

    template <class What>
    [[nodiscard]] std::vector<What> all() const {
        std::vector<What> found;
        for (const Command& command : commands)
            if (const What* const what = std::get_if<What>(&command.what)) found.push_back(*what);
        return found;
    }
    template <class What>
    [[nodiscard]] What last() const {
        return all<What>().back();
    }
};

inline Reading reading_of(const std::string& text, Firmware firmware = Firmware::prusa) {
    Reading reading;
    std::istringstream stream(text);
    reading.report =
        read_gcode(stream, {.name = "part.gcode", .firmware = firmware},
                   [&](const Command& command) { reading.commands.push_back(command); });
    return reading;
}

}  // namespace bead
