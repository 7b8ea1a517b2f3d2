// The published strategies in words, with the counts that they rest on.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "numeric/least_squares.h"
#include "replay_report.h"

namespace bead::cli {
namespace {

std::string judged_by(const Tally& tally, std::string_view cells) {
    constexpr double nearly_all = 0.95, most = 0.5;
    const double part = tally.of > 0 ? static_cast<double>(tally.holds) / tally.of : 0;
    const std::string_view verdict = part >= nearly_all ? "holds"
                                     : part > most      ? "holds mostly"
                                                        : "fails";
    return fmt::format("{}: {} of {} {}", verdict, tally.holds, tally.of, cells);
}

struct BothSides {
    RunEnergies published, ours;
};

// Suspect rows are left out of the published side.
BothSides energies_of(const Replay& replay, bool suspect_too) {
    BothSides sides;
    for (const ReplayedRun& run : replay.runs) {
        if (suspect_too || !run.published.suspect)
            sides.published.add(run.published.run, run.published.energy);
        sides.ours.add(run.published.run, run.ours.energy);
    }
    return sides;
}

ClaimResult coasting(const Replay& replay) {
    Tally published, ours;
    for (const std::string part : {"rectangle", "bracket"}) {
        std::vector<ChargedFeatures> rows;
        for (const FeatureRow& row : appendix_rows())
            if (row.part == part) rows.push_back({row.features, row.energy});
        published = published + coasting_pays(rows);
    }
    for (std::size_t shape = 0; shape < shape_names.size(); ++shape) {
        std::vector<ChargedFeatures> rows;
        for (const ReplayedRun& run : replay.runs)
            if (run.published.run.shape == static_cast<Shape>(shape))
                rows.push_back({run.ours.features, run.ours.energy});
        ours = ours + coasting_pays(rows);
    }
    const char* const pairs = "pairs of prints, of which one coasts farther and speeds up less";
    return {"coasting more and accelerating less saves energy", judged_by(published, pairs),
            judged_by(ours, pairs), published, ours};
}

// "diagonal +12.6 % at 80 mm/s"
std::string diagonal_by_speed(const std::vector<SpeedPoint>& speeds) {
    std::string text;
    for (const SpeedPoint& point : speeds)
        text += fmt::format("{}{:+.1f} % at {:.0f} mm/s", text.empty() ? "" : ", ",
                            100 * (point.diagonal.published / point.straight.published - 1),
                            point.speed);
    return text;
}

ClaimResult diagonal(const Replay& replay, const Tally& published, const Tally& ours) {
    return {"infill at 45° is the worst angle", judged_by(published, "cells, at one set of speeds"),
            fmt::format("depends on speed: {} of {} cells as set up; the square at 45° against 0°, "
                        "all at one speed: {}; coasting alone breaks even at {:.1f} mm/s",
                        ours.holds, ours.of, diagonal_by_speed(replay.speeds), break_even_speed()),
            published, ours};
}

ClaimResult lowest(const Tallies& published, const Tallies& ours) {
    const auto words = [](const Tallies& counts) {
        return judged_by(counts.rectilinear_lowest, "cells have rectilinear lowest") +
               fmt::format("; 0° or 90° is the best infill angle in {} of {}, 90° in {}",
                           counts.diagonal_worst.holds, counts.diagonal_worst.of,
                           counts.ninety_best.holds);
    };
    return {"0° and 90° are the best infill angles, rectilinear the lowest of the five patterns",
            words(published), words(ours), published.rectilinear_lowest, ours.rectilinear_lowest};
}

ClaimResult asymmetry(const BothSides& sides) {
    Rows rows;
    std::vector<double> energies;
    for (const FeatureRow& row : calibration_rows()) {
        rows.push_back({row.features.A, row.features.B, row.features.C, row.features.H});
        energies.push_back(row.energy);
    }
    const LinearFit fit = fit_linear(rows, energies);
    const double more = fit.coefficients[1] - fit.coefficients[0];
    const double error =
        std::sqrt(fit.covariance[0][0] + fit.covariance[1][1] - 2 * fit.covariance[0][1]);
    return {"Y is dearer to move than X (m_y > m_x)",
            fmt::format("fails: the fit gives Y less X {:.4f} ± {:.4f} mJ/(mm/s)², nothing that 10 "
                        "prints could show; with X and Y exchanged runs cost {:+.2f} %",
                        1000 * more, 1000 * error, 100 * exchange_effect(sides.published)),
            fmt::format("fails: with X and Y exchanged our runs cost {:+.2f} %, by the same "
                        "coefficients",
                        100 * exchange_effect(sides.ours)),
            {},
            {}};
}

ClaimResult part_angle(const Tallies& clean, const Tallies& raw, const Tallies& ours) {
    const auto words = [](const Tally& cells, const Tallies& shapes) {
        return judged_by(cells, "cells have part angle 0 lowest") +
               fmt::format(
                   "; the infill angle matters more than the part angle for {} of {} "
                   "shapes, the pattern for {} of {}",
                   shapes.infill_outweighs_part.holds, shapes.infill_outweighs_part.of,
                   shapes.pattern_outweighs_part.holds, shapes.pattern_outweighs_part.of);
    };
    return {"part angle 0 is the lowest; pattern and infill angle matter more than part angle",
            words(clean.part_0_lowest, raw), words(ours.part_0_lowest, ours), clean.part_0_lowest,
            ours.part_0_lowest};
}

std::string case_words(const BracketFindings& found) {
    const auto name = [](const ExperimentRun& run) {
        return fmt::format("{} {}°", pattern_of(run), run.infill_angle);
    };
    return fmt::format(
        "best {} is {:.1f} % below the worst ({}), {:.1f} % below rectilinear 45°; infill at 45° "
        "is "
        "worse for {} of {} patterns, 90° better than 0° for {}, part angle 0 lowest for {}; "
        "rectilinear is lowest in {} of {} set-ups",
        name(found.best), 100 * found.below_worst, name(found.worst), 100 * found.below_usual,
        found.diagonal_worse, found.patterns, found.ninety_better, found.part_0_lowest,
        found.rectilinear_lowest, found.set_ups);
}

ClaimResult case_study(const std::vector<BracketRow>& rows) {
    std::vector<BracketRun> published, ours;
    for (const BracketRow& row : rows) {
        published.push_back({row.run, row.published});
        ours.push_back({row.run, row.ours});
    }
    const BracketFindings theirs = bracket_findings(published), found = bracket_findings(ours);
    constexpr double claimed = 0.37, near = 0.05;
    const std::string_view verdict = found.below_worst > claimed - near ? "holds" : "fails in size";
    return {"case study, a bracket: 37 % below the worst, 21.9 % below rectilinear at 45°",
            fmt::format("holds as arithmetic on its tables: {}", case_words(theirs)),
            fmt::format("{} on a stand-in bracket (theirs is not published): {}", verdict,
                        case_words(found)),
            {theirs.diagonal_worse, theirs.patterns},
            {found.diagonal_worse, found.patterns}};
}

}  // namespace

std::vector<ClaimResult> claim_results(const Replay& replay) {
    const BothSides clean = energies_of(replay, replay.all), raw = energies_of(replay, true);
    const Tallies published = tallies(clean.published), ours = tallies(clean.ours);
    return {coasting(replay),
            diagonal(replay, published.diagonal_worst, ours.diagonal_worst),
            lowest(published, ours),
            asymmetry(clean),
            part_angle(published, tallies(raw.published), ours),
            case_study(replay.bracket)};
}

}  // namespace bead::cli
