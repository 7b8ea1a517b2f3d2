// Options that several subcommands share, declared once and turned into what the library takes.
#pragma once
#include <CLI/CLI.hpp>

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "console.h"
#include "job/settings.h"
#include "study/judge.h"

namespace bead::cli {

struct OutputOptions {
    std::string json;
    bool quiet = false;
    std::string progress = "auto";
    std::string color = "auto";
};
void declare(CLI::App& command, OutputOptions& options);
Console console_of(const OutputOptions& options);

struct MachineOptions {
    std::string printer;           // empty: the default one
    std::vector<std::string> set;  // of the printer; of commands that plan no print
    std::string material = "pla";
    std::string firmware;  // empty: as the printer or the file says, else Prusa's
    std::string quirks = "faithful";
    std::string lookahead = "16";
};
void declare(CLI::App& command, MachineOptions& options);
Firmware firmware_of(const MachineOptions& options);  // Prusa's if none is named
Machine machine_of(const MachineOptions& options);
// "prusa-mk3s (built in)" or the file's name.
std::string printer_label(const MachineOptions& options);

struct ProcessOptions {
    std::string model;
    std::string units;
    std::string config;
    std::vector<std::string> set;
    std::map<std::string, std::string> by_option;  // setting's name -> value
    int threads = 0;
    long seed = 0;
};
void declare(CLI::App& command, ProcessOptions& options);
Settings settings_of(const ProcessOptions& options, const Console& console);

}  // namespace bead::cli
