// What every subcommand offers to main: how to declare its options and what to do when it is
// called.
#pragma once
#include <CLI/CLI.hpp>

namespace bead::cli {

void add_slice(CLI::App& app);
void add_optimize(CLI::App& app);
void add_simulate(CLI::App& app);
void add_energy(CLI::App& app);
void add_smooth(CLI::App& app);
void add_post_process(CLI::App& app);
void add_stress(CLI::App& app);
void add_reinforce(CLI::App& app);
void add_strength(CLI::App& app);
void add_calibrate(CLI::App& app);
void add_replay(CLI::App& app);
void add_vibration(CLI::App& app);
void add_printers(CLI::App& app);
void add_patterns(CLI::App& app);
void add_config(CLI::App& app);

}  // namespace bead::cli
