// Every setting of a print job by its name, in one table: the only place where a setting's name is
// read. The same names serve `--set name=value`, the TOML of `--config` and `beadwork config`.
//
//     Settings settings;
//     set(settings, "layer_height_mm", "0.1");
//     const PlanOptions plan = settings.plan;
#pragma once
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "plan/options.h"
#include "slice/slice.h"

namespace bead {

struct Retraction {
    double length = 0.8;  // mm of filament
    double speed = 35;    // mm/s
};

struct Settings {
    SliceOptions slice;
    PlanOptions plan;
    Retraction retraction;
    double rotate = 0;  // rad, of the part about the vertical
    double fan = 1;     // duty from the second layer on
    bool relative_e = true;
};

struct Setting {
    std::string_view name;   // e.g. "layer_height_mm"; the unit is part of the name
    std::string_view about;  // for people, one line
    std::string allowed;     // for people, e.g. "a number in 0.01 … 10"
    std::function<bool(Settings&, std::string_view value)> set;  // false: not an allowed value
    std::function<std::string(const Settings&)> get;             // as `set` takes it
};

std::span<const Setting> all_settings();

// Throws Error naming the setting, the value and what is allowed; for an unknown name, the nearest
// known one. `where` says where it was read ("--set", "fast.toml:3") and starts the message; an
// option ("--…") makes it a fault of usage, anything else one of input.
void set(Settings& settings, std::string_view name, std::string_view value,
         std::string_view where = "--set");

std::string get(const Settings& settings, std::string_view name);

// Throws Error{usage} where settings, each allowed by itself, do not go together.
void check(const Settings& settings);

// Reads a process file: TOML with the names above, or a PrusaSlicer .ini, of which the known part
// is taken. Returns the names in the file that were ignored. Throws Error.
std::vector<std::string> read_config(Settings& settings, const std::string& file);

}  // namespace bead
