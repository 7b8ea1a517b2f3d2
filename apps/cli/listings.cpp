// beadwork printers, patterns and config: what can be named.
#include <memory>

#include "command.h"
#include "job/material_file.h"
#include "job/printer_file.h"
#include "json_result.h"
#include "options.h"

namespace bead::cli {
namespace {

void printers(const OutputOptions& options) {
    const Console console = console_of(options);
    Json result = result_head("printers", {});
    for (const std::string& name : printer_names()) {
        const Printer printer = load_printer(name);
        console.say(
            "{:<16} {:>4.0f} x {:>4.0f} x {:>4.0f} mm, nozzle {:.1f} mm, {:.0f} mm/s², up to "
            "{:.0f} mm/s\n",
            name, printer.bed[0], printer.bed[1], printer.bed[2], printer.nozzle,
            printer.limits.acceleration, printer.limits.max_feedrate[0]);
        result["printers"].push_back(
            {{"name", name}, {"bed_mm", printer.bed}, {"nozzle_mm", printer.nozzle}});
    }
    console.say("\nmaterials:");
    for (const std::string& name : material_names()) {
        console.say(" {}", name);
        result["materials"].push_back(name);
    }
    console.say("\n");
    write_result(options.json, result);
}

void list_patterns(const OutputOptions& options) {
    const Console console = console_of(options);
    Json result = result_head("patterns", {});
    for (const NamedPattern& pattern : patterns) {
        console.say("{:<14} {}\n", pattern.name, pattern.about);
        result["patterns"].push_back({{"name", pattern.name}, {"about", pattern.about}});
    }
    write_result(options.json, result);
}

struct ConfigOptions {
    std::string file;
    OutputOptions output;
};

void config(const ConfigOptions& options) {
    const Console console = console_of(options.output);
    Settings settings;
    Json result = result_head("config", {options.file});
    if (!options.file.empty()) {
        const std::vector<std::string> ignored = read_config(settings, options.file);
        for (const std::string& name : ignored) console.warn("ignored " + name);
        result["ignored"] = ignored;
        check(settings);
    }
    for (const Setting& setting : all_settings()) {
        console.say("{:<32} {:<14} # {}\n", setting.name, "= " + setting.get(settings),
                    setting.about);
        result["settings"][std::string(setting.name)] = setting.get(settings);
    }
    write_result(options.output.json, result);
}

template <class Options>
void add(CLI::App& app, const char* name, const char* about, const char* example,
         void (*run)(const Options&)) {
    const auto options = std::make_shared<Options>();
    CLI::App& command = *app.add_subcommand(name, about);
    command.footer(example);
    if constexpr (std::is_same_v<Options, ConfigOptions>) {
        command.add_option("FILE", options->file, "process settings to check: .toml or .ini");
        declare(command, options->output);
    } else {
        declare(command, *options);
    }
    command.callback([options, run] { run(*options); });
}

}  // namespace

void add_printers(CLI::App& app) {
    add<OutputOptions>(app, "printers", "built-in printers and materials",
                       "Example:\n  beadwork printers --json -", printers);
}

void add_patterns(CLI::App& app) {
    add<OutputOptions>(app, "patterns", "infill patterns", "Example:\n  beadwork patterns",
                       list_patterns);
}

void add_config(CLI::App& app) {
    add<ConfigOptions>(app, "config", "every setting with its value, as a file for --config",
                       "Example: check a PrusaSlicer profile and see what is taken from it\n"
                       "  beadwork config profile.ini",
                       config);
}

}  // namespace bead::cli
