#include "job/sourced_printer.h"

#include "job/printer_file.h"

namespace bead {
namespace {

void hear(SourcedPrinter& sourced, const Statement& says) {
    sourced.limits.put(says.limits);
    if (says.firmware) sourced.firmware = *says.firmware;
    const auto append = [](std::vector<std::string>& all, const std::vector<std::string>& more) {
        all.insert(all.end(), more.begin(), more.end());
    };
    append(sourced.warnings, says.warnings);
    append(sourced.notes, says.notes);
}

}  // namespace

SourcedPrinter sourced_printer(const PrinterSources& sources) {
    const Printer usual = load_printer(usual_printer);
    SourcedPrinter sourced{usual,
                           {usual.limits, std::string("default printer ") + usual_printer},
                           {Firmware::prusa, "default"},
                           {},
                           {}};
    hear(sourced, slicer_statement(sources.notes, SlicerPlace::file, "slicer's notes"));
    hear(sourced, slicer_statement(sources.environment, SlicerPlace::environment, "environment"));
    if (!sources.printer.empty()) {
        const PrinterFile file = read_printer_file(sources.printer);
        sourced.printer = file.printer;
        hear(sourced, file.says);
    }
    for (const std::string& setting : sources.set) {
        const PrinterFile changed = with_setting(sourced.printer, setting);
        sourced.printer = changed.printer;
        hear(sourced, changed.says);
    }
    sourced.printer.limits = sourced.limits.limits();
    return sourced;
}

}  // namespace bead
