// The command `beadwork`. Subcommands declare themselves, each in its own file; here errors become
// one line and an exit status.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <exception>
#include <new>

#ifdef __GLIBC__
#include <malloc.h>
#endif

#include "command.h"
#include "core/error.h"

namespace {

constexpr const char* about =
    "Plans the path of every bead of a 3D print and knows, before anything is printed, what it "
    "costs in\n"
    "time and energy.\n\n"
    "  beadwork optimize bracket.stl -o bracket.gcode     the print that costs least\n"
    "  beadwork energy anybodys.gcode                     what a print will draw, by consumer";

std::string one_line(std::string text) {
    std::ranges::replace(text, '\n', ' ');
    while (!text.empty() && text.back() == ' ') text.pop_back();
    return text;
}

int fail(const std::string& message, bead::Fault fault) {
    fmt::print(stderr, "beadwork: {}\n", one_line(message));
    return static_cast<int>(fault);
}

// CLI11's ranges let nan through.
const CLI::Validator finite(
    [](const std::string& text) {
        double value = 0;
        const bool read = CLI::detail::lexical_cast(text, value);
        return read && !std::isfinite(value) ? text + " is not finite; give a number" : "";
    },
    "");

void expect_finite_numbers(CLI::App& app) {
    for (CLI::Option* option : app.get_options())
        if (option->get_type_name().find("FLOAT") != std::string::npos) option->check(finite);
    for (CLI::App* command : app.get_subcommands({})) expect_finite_numbers(*command);
}

int run(CLI::App& app, int argc, char** argv) {
    try {
        app.parse(argc, argv);
        return 0;
    } catch (const CLI::Success& help) {
        return app.exit(help);
    } catch (const CLI::ParseError& error) {
        return fail(std::string(error.what()) + " (beadwork --help shows what there is)",
                    bead::Fault::usage);
    } catch (const bead::Error& error) {
        return fail(error.what(), error.fault());
    } catch (const std::bad_alloc&) {
        return fail("not enough memory for this job", bead::Fault::other);
    } catch (const std::exception& error) {
        return fail(error.what(), bead::Fault::other);
    }
}

// Memory that is given back goes to the next that asks: solvers take and leave tens of megabytes
// hundreds of times, and the system would clear them anew each time.
void keep_freed_memory() {
#ifdef __GLIBC__
    constexpr int a_gigabyte = 1 << 30;
    mallopt(M_MMAP_THRESHOLD, a_gigabyte);
    mallopt(M_TRIM_THRESHOLD, a_gigabyte);
#endif
}

}  // namespace

int main(int argc, char** argv) {
    std::signal(SIGPIPE, SIG_IGN);  // a closed pipe is an error of the write, not the end of us
    keep_freed_memory();
    CLI::App app{about, "beadwork"};
    app.set_version_flag("--version", BEAD_VERSION);
    app.require_subcommand(1);
    bead::cli::add_slice(app);
    bead::cli::add_optimize(app);
    bead::cli::add_simulate(app);
    bead::cli::add_energy(app);
    bead::cli::add_smooth(app);
    bead::cli::add_post_process(app);
    bead::cli::add_stress(app);
    bead::cli::add_reinforce(app);
    bead::cli::add_strength(app);
    bead::cli::add_calibrate(app);
    bead::cli::add_replay(app);
    bead::cli::add_vibration(app);
    bead::cli::add_printers(app);
    bead::cli::add_patterns(app);
    bead::cli::add_config(app);
    expect_finite_numbers(app);
    return run(app, argc, argv);
}
