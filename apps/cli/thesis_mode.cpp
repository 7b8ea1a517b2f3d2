#include "thesis_mode.h"

#include <fmt/format.h>

#include "core/error.h"
#include "geom/polygon.h"

namespace bead::cli {

void declare(CLI::App& command, ThesisModeOptions& options) {
    command
        .add_option("--line-seeds", options.seeds,
                    "thesis mode: where lines begin: on edges, evenly all over, or by stress")
        ->check(CLI::IsMember({"edges", "even", "stress"}))
        ->capture_default_str();
    command
        .add_option("--seed-distance", options.lines.apart,
                    "thesis mode: mm between seeds; 0: by the volume")
        ->check(CLI::Range(0.0, 1000.0));
    command
        .add_option("--copies", options.lines.copies,
                    "thesis mode: beads laid beside a line on either side, at most")
        ->check(CLI::Range(0, 20))
        ->capture_default_str();
    command
        .add_option("--crossing-flow", options.crossing_flow,
                    "thesis mode: share of its plastic that a bead in compression has within a "
                    "bead's width of where it crosses one in tension")
        ->check(CLI::Range(0.1, 1.0))
        ->capture_default_str();
}

Reinforced thesis_design(const LoadCase& load_case, const ThesisModeOptions& options,
                         const std::string& file) {
    if (load_case.situations.size() > 1)
        throw Error(
            fmt::format("{}: has {} load cases; thesis mode lays lines for one, "
                        "--mode strongest for all of them",
                        file, load_case.situations.size()));
    ThesisOptions how = options.lines;
    if (options.seeds == "even") how.seeds = ThesisSeeds::even;
    if (options.seeds == "stress") how.seeds = ThesisSeeds::stress;
    std::optional<ThesisLines> lines = thesis_lines(load_case, how);
    if (!lines)
        throw Error(
            fmt::format("{}: fill {:.3g} cannot be reached: walls and pads alone take "
                        "{:.3g}; ask for more or for fewer walls",
                        file, load_case.print.fill, least_area(load_case) / area(load_case.part)),
            Fault::infeasible);
    const Toolpath layer = layer_of(lines->layout, load_case.print);
    const std::string copies = lines->threshold > 0
                                   ? fmt::format("copies from {:.3g} MPa", lines->threshold)
                                   : "single lines";
    Reinforced found;
    found.candidates.push_back({fmt::format("thesis mode, seeds {:.3g} and {:.3g} mm apart, {}",
                                            lines->apart[0], lines->apart[1], copies),
                                std::move(lines->layout),
                                strength_of({&layer, 1}, load_case, {}),
                                {}});
    return found;
}

}  // namespace bead::cli
