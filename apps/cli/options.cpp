#include "options.h"

#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <cstdlib>

#include "core/error.h"
#include "job/material_file.h"
#include "job/printer_file.h"
#include "job/sourced_printer.h"

namespace bead::cli {
namespace {

constexpr const char* default_printer = "prusa-mk3s";

// Options that are short for a setting.
struct Short {
    const char* option;
    const char* setting;
    const char* about;
};
constexpr Short shorts[] = {
    {"--layer-height", "layer_height_mm", "mm"},
    {"--first-layer-height", "first_layer_height_mm", "mm"},
    {"--walls", "walls", "number of wall loops"},
    {"--top-layers", "top_layers", "solid layers below what is seen from above"},
    {"--bottom-layers", "bottom_layers", "solid layers above what is seen from below"},
    {"--density", "density", "of the sparse infill, 0.2 or 20%"},
    {"--pattern", "pattern", "of the sparse infill (beadwork patterns)"},
    {"--angle", "angle_deg", "of the lines, degrees from X; they alternate by 90"},
    {"--rotate", "rotate_deg", "the part about the vertical, degrees"},
};

int lookahead_of(const std::string& text) {
    if (text == "unlimited") return 0;
    int value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || value < 4 || value > 1'000'000)
        throw Error("--lookahead: " + text + " is neither a number of blocks from 4 nor unlimited",
                    Fault::usage);
    return value;
}

}  // namespace

void declare(CLI::App& command, OutputOptions& options) {
    command.add_option("--json", options.json, "write the result as JSON; - for standard output")
        ->type_name("FILE");
    command.add_flag("--quiet", options.quiet, "no words, only errors and warnings");
    command.add_option("--progress", options.progress, "auto (a bar on a terminal), json or none")
        ->check(CLI::IsMember({"auto", "json", "none"}));
    command.add_option("--color", options.color, "auto or never")
        ->check(CLI::IsMember({"auto", "never"}));
}

Console console_of(const OutputOptions& options) {
    Console console;
    console.text = options.json == "-" ? stderr : stdout;
    console.quiet = options.quiet;
    console.colour = options.color == "auto" && ::isatty(::fileno(console.text)) != 0 &&
                     std::getenv("NO_COLOR") == nullptr;
    if (options.progress == "json")
        console.progress = ProgressStyle::json;
    else if (options.progress == "auto" && !options.quiet && ::isatty(STDERR_FILENO) != 0)
        console.progress = ProgressStyle::bar;
    return console;
}

void declare(CLI::App& command, MachineOptions& options) {
    command
        .add_option("--printer", options.printer,
                    "built-in printer (beadwork printers), PRINTER.toml, Klipper's printer.cfg or "
                    "Marlin's answer to M503 as .txt")
        ->type_name("NAME|FILE")
        ->default_str(default_printer);
    if (command.get_option_no_throw("--set") == nullptr)
        command
            .add_option("--set", options.set, "any setting of the printer by its name in the TOML")
            ->type_name("KEY=VALUE")
            ->allow_extra_args(false);
    command.add_option("--material", options.material, "built-in material or a MATERIAL.toml")
        ->type_name("NAME|FILE")
        ->capture_default_str();
    command.add_option("--firmware", options.firmware, "whose motion planner is simulated")
        ->check(
            CLI::IsMember(std::vector<std::string>(firmware_names.begin(), firmware_names.end())))
        ->default_str("as printer or file say, else prusa");
    command
        .add_option("--quirks", options.quirks, "faithful to the firmware, or corrected physics")
        ->check(CLI::IsMember({"faithful", "corrected"}))
        ->capture_default_str();
    command
        .add_option("--lookahead", options.lookahead, "blocks in the planner's queue, or unlimited")
        ->capture_default_str();
}

Firmware firmware_of(const MachineOptions& options) {
    if (options.firmware.empty()) return Firmware::prusa;
    const auto name = std::ranges::find(firmware_names, options.firmware);
    return static_cast<Firmware>(name - firmware_names.begin());
}

Machine machine_of(const MachineOptions& options) {
    const std::string name = options.printer.empty() ? default_printer : options.printer;
    Printer printer =
        options.set.empty()
            ? load_printer(name)
            : sourced_printer({.set = options.set, .printer = name, .environment = {}, .notes = {}})
                  .printer;
    return {std::move(printer),
            load_material(options.material),
            {firmware_of(options), options.quirks == "corrected", lookahead_of(options.lookahead)}};
}

std::string printer_label(const MachineOptions& options) {
    if (options.printer.empty()) return std::string("built-in printer ") + default_printer;
    return options.printer.ends_with(".toml") ? options.printer
                                              : "built-in printer " + options.printer;
}

void declare(CLI::App& command, ProcessOptions& options) {
    command.add_option("MODEL", options.model, ".stl, .obj or .3mf, each also gzipped")->required();
    command.add_option("--units", options.units, "of the model's numbers: mm, inch or m")
        ->check(CLI::IsMember({"mm", "inch", "m"}));
    command
        .add_option("--config", options.config, "process settings: .toml, or PrusaSlicer's .ini")
        ->type_name("FILE");
    command.add_option("--set", options.set, "any setting by its name (beadwork config)")
        ->type_name("KEY=VALUE")
        ->allow_extra_args(false);
    for (const Short& row : shorts)
        command.add_option_function<std::string>(
            row.option,
            [&options, row](const std::string& value) { options.by_option[row.setting] = value; },
            row.about);
    command.add_option("--threads", options.threads, "0: as many as there are cores")
        ->check(CLI::Range(0, 1024));
    command.add_option("--seed", options.seed, "accepted for scripts; nothing here is random");
}

Settings settings_of(const ProcessOptions& options, const Console& console) {
    Settings settings;
    if (!options.config.empty())
        for (const std::string& ignored : read_config(settings, options.config))
            console.warn(options.config + ": ignored " + ignored);
    for (const std::string& text : options.set) {
        const std::size_t equals = text.find('=');
        if (equals == std::string::npos)
            throw Error("--set " + text + ": write it as name=value", Fault::usage);
        set(settings, text.substr(0, equals), text.substr(equals + 1), "--set");
    }
    for (const Short& row : shorts)
        if (const auto given = options.by_option.find(row.setting);
            given != options.by_option.end())
            set(settings, row.setting, given->second, row.option);
    check(settings);
    settings.slice.threads = settings.plan.threads = options.threads;
    return settings;
}

}  // namespace bead::cli
