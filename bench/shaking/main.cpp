// Paths times time laws, before and after smoothing (docs/w16.md, docs/vibration.md):
//
//     shaking PART [MODELS]
//
// PART: w16 (four sections of the engine block's stand-in on three machines), detuned (shaper and
// feed-forward 10 and 20 % off), fast (feeds times 1.15), parts (what nothing was tuned on; meshes
// of the folder MODELS too). Every table says volume, coverage, time and law.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <string>

#include "core/error.h"
#include "parts.h"
#include "study/printing_ways.h"
#include "table.h"

namespace bead::shaking {
namespace {

using Modes = std::array<double, 2>;  // Hz
constexpr std::array<Modes, 3> machines{Modes{14, 22}, Modes{9, 13}, Modes{25, 35}};

std::vector<ShakenPath> ways_of(const std::vector<Part>& parts, Modes modes) {
    std::vector<ShakenPath> ways;
    for (const Part& part : parts) {
        WaysOptions options;
        options.smooth.modes = modes;
        for (ShakenPath& way : printing_ways(part.name, part.section, options))
            ways.push_back(std::move(way));
    }
    return ways;
}

void print_tables(const std::vector<ShakenPath>& ways, std::span<const NamedLaw> laws, Modes modes,
                  bool with_paths) {
    const auto cells = shaken(ways, laws, example_machine(modes[0], modes[1]));
    const ShakingTable table = changes(cells, {"B1", "K0"});
    if (with_paths) {
        fmt::print("\nPaths, modes {} and {} Hz; % against B1, mean/worst\n\n", modes[0], modes[1]);
        print_paths(table);
        for (const std::string& part : table.parts) {
            fmt::print("\n");
            print_figures(cells, part, "K0");
        }
    }
    fmt::print("\nResponses, modes {} and {} Hz; % against B1 by K0, mean/worst\n\n", modes[0],
               modes[1]);
    print_responses(cells, table);
    std::fflush(stdout);
}

void print_w16() {
    const std::vector<Part> parts = engine_block_sections();
    for (const Modes modes : machines) print_tables(ways_of(parts, modes), named_laws, modes, true);
}

// K0, then the quiet laws with modes taken for something else than they are; those of limited jerk
// also with a ramp of acceleration that lasts a period of the slower mode.
void print_detuned_on(const std::vector<Part>& parts, Modes modes) {
    std::vector<std::string> names;
    std::vector<NamedLaw> laws{named_laws[0]};
    names.reserve(100);
    const auto add = [&](const TimeLaw& law, std::string_view name) {
        for (const double tuning : {0.8, 0.9, 1.0, 1.1, 1.2}) {
            NamedLaw row{names.emplace_back(fmt::format("{} x{}", name, tuning)), law};
            row.law.tuning = tuning;
            laws.push_back(row);
        }
    };
    for (const NamedLaw& named : {named_laws[2], named_laws[4], named_laws[6]}) {
        add(named.law, named.name);
        if (named.law.profile != SpeedProfile::jerk_limited) continue;
        TimeLaw slow = named.law;
        slow.jerk = slow.acceleration * std::min(modes[0], modes[1]);
        add(slow, fmt::format("{} J=Af", named.name));
    }
    print_tables(ways_of(parts, modes), laws, modes, false);
}

void print_detuned() {
    const std::vector<Part> parts = engine_block_sections();
    for (const Modes modes : machines) print_detuned_on(parts, modes);
}

void print_fast() {
    std::vector<NamedLaw> laws(named_laws.begin(), named_laws.end());
    const std::array<std::string, 2> names{"K1f x1.15", "K1Mf x1.15"};
    for (std::size_t i = 0; i < 2; ++i) {
        NamedLaw law = named_laws[i == 0 ? 2 : 6];
        law.law.feed_factor = 1.15;
        law.name = names[i];
        laws.push_back(law);
    }
    print_tables(ways_of(engine_block_sections(), machines[0]), laws, machines[0], false);
}

void print_parts(const std::string& models) {
    std::vector<Part> parts = drawn_parts();
    const auto add = [&](const char* name, const std::string& file, double share) {
        if (auto part = section_of(name, file, share)) parts.push_back(std::move(*part));
    };
    add("bracket", BEAD_SOURCE_DIR "/examples/parts/bracket.stl", 0.5);
    add("x-carriage", models + "/mk3_x_carriage.stl", 0.5);
    add("plate with holes", models + "/plate_holes.stl", 0.5);
    add("Benchy", models + "/3dbenchy.3mf", 0.2);
    add("ringing tower", models + "/klipper_ringing_tower.stl", 0.5);
    for (const Modes modes : machines)
        print_tables(ways_of(parts, modes), named_laws, modes, modes == machines[0]);
}

void run(const std::string& what, const std::string& models) {
    if (what == "w16") return print_w16();
    if (what == "detuned") return print_detuned();
    if (what == "fast") return print_fast();
    if (what == "parts") return print_parts(models);
    throw Error(fmt::format("{}: is none of w16, detuned, fast, parts", what));
}

}  // namespace
}  // namespace bead::shaking

int main(int argc, char** argv) {
    try {
        bead::shaking::run(argc > 1 ? argv[1] : "w16", argc > 2 ? argv[2] : ".");
    } catch (const bead::Error& error) {
        fmt::print(stderr, "{}\n", error.what());
        return 2;
    }
}
