#include "machine_choice.h"

#include <unistd.h>

namespace bead::cli {

MachineChoice machine_choice(const MachineOptions& options, const SlicerNotes& notes) {
    SourcedPrinter sourced = sourced_printer({.set = options.set,
                                              .printer = options.printer,
                                              .environment = slicer_environment(environ),
                                              .notes = notes.settings});
    if (!options.firmware.empty()) sourced.firmware = {firmware_of(options), "--firmware"};
    Machine machine = machine_of(options);
    machine.printer = std::move(sourced.printer);
    machine.motion.firmware = sourced.firmware.firmware;
    return {std::move(machine), std::move(sourced.limits), std::move(sourced.firmware),
            std::move(sourced.warnings), std::move(sourced.notes)};
}

}  // namespace bead::cli
