#include "replay_report.h"

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <algorithm>
#include <cmath>

namespace bead::cli {
namespace {

bool any(const PublishedRun& /*unused*/) { return true; }
bool is_usable(const PublishedRun& run) { return usable(run.run); }
bool is_clean(const PublishedRun& run) { return usable(run.run) && !run.suspect; }

Json agreement_json(const Agreement& agreed) {
    Json by_shape;
    for (std::size_t i = 0; i < shape_names.size(); ++i)
        by_shape[std::string(shape_names[i])] = agreed.by_shape[i];
    return {{"rows", agreed.rows},
            {"mape_percent", 100 * agreed.mape},
            {"worst_percent", 100 * agreed.worst},
            {"spearman", agreed.spearman},
            {"spearman_by_shape", by_shape}};
}

Json row_json(const ReplayedRun& row) {
    const ExperimentRun& run = row.published.run;
    return {{"geometry", shape_names[static_cast<std::size_t>(run.shape)]},
            {"pattern", pattern_of(run)},
            {"infill_angle_deg", run.infill_angle},
            {"geometry_angle_deg", run.part_angle},
            {"published_mj", 1000 * row.published.energy},
            {"ours_mj", 1000 * row.ours.energy},
            {"standing_form_mj", 1000 * row.ours.standing},
            {"duration_s", row.ours.duration},
            {"usable", usable(run)},
            {"suspect", row.published.suspect}};
}

Json features_json(const Features& f, double energy) {
    return {{"a_mm2_per_s2", f.A},
            {"b_mm2_per_s2", f.B},
            {"c_mm", f.C},
            {"h_s", f.H},
            {"energy_mj", 1000 * energy}};
}

// Of appendix D, whose rectangle is among the prints made here; the bracket of E is not published.
Json appendix_json(const Replay& replay) {
    Json rows = Json::array();
    for (const FeatureRow& row : appendix_rows()) {
        if (row.part != "rectangle") continue;
        const auto made = std::ranges::find(
            replay.runs, row.run, [](const ReplayedRun& run) { return run.published.run; });
        if (made == replay.runs.end()) continue;
        rows.push_back({{"pattern", pattern_of(row.run)},
                        {"infill_angle_deg", row.run.infill_angle},
                        {"geometry_angle_deg", row.run.part_angle},
                        {"published", features_json(row.features, row.energy)},
                        {"ours", features_json(made->ours.features, made->ours.energy)}});
    }
    return rows;
}

Json bracket_json(const std::vector<BracketRow>& bracket) {
    Json rows = Json::array();
    for (const BracketRow& row : bracket)
        rows.push_back({{"pattern", pattern_of(row.run)},
                        {"infill_angle_deg", row.run.infill_angle},
                        {"geometry_angle_deg", row.run.part_angle},
                        {"published_mj", 1000 * row.published},
                        {"stand_in_mj", 1000 * row.ours}});
    return rows;
}

Json tally_json(const Tally& tally) { return {{"holds", tally.holds}, {"of", tally.of}}; }

Json claims_json(const Replay& replay) {
    Json claims = Json::array();
    for (const ClaimResult& result : claim_results(replay)) {
        Json claim{{"claim", result.claim},
                   {"published_data", result.published_data},
                   {"our_runs", result.our_runs}};
        if (result.published.of > 0) claim["published_count"] = tally_json(result.published);
        if (result.ours.of > 0) claim["our_count"] = tally_json(result.ours);
        claims.push_back(std::move(claim));
    }
    return claims;
}

Json energies_json(const ModelEnergies& energies) {
    return {{"published_j", energies.published},
            {"standing_form_j", energies.standing},
            {"xy_motors_j", energies.xy_motors},
            {"machine_j", energies.machine},
            {"time_s", energies.duration}};
}

Json speeds_json(const std::vector<SpeedPoint>& speeds) {
    Json rows = Json::array();
    for (const SpeedPoint& point : speeds)
        rows.push_back({{"speed_mm_s", point.speed},
                        {"infill_0", energies_json(point.straight)},
                        {"infill_45", energies_json(point.diagonal)}});
    return rows;
}

void print_agreement(const Console& console, const std::string& name, const Agreement& agreed) {
    console.say("  {:<36} {:>4}  {:>6.2f} %  {:>6.1f} %   {:.4f}  ", name, agreed.rows,
                100 * agreed.mape, 100 * agreed.worst, agreed.spearman);
    for (const double value : agreed.by_shape) console.say("  {:.3f}", value);
    console.say("\n");
}

void print_speeds(const Console& console, const std::vector<SpeedPoint>& speeds) {
    const auto more = [](double diagonal, double straight) {
        return 100 * (diagonal / straight - 1);
    };
    console.say("\nThe square's infill at 45° against 0°, everything printed at one speed:\n");
    console.say("       mm/s     Eq. 28   standing form   X, Y motors   machine (physics)\n");
    for (const SpeedPoint& p : speeds)
        console.say(
            "       {:>4.0f}   {:>+6.1f} %        {:>+6.1f} %      {:>+6.1f} %      "
            "{:>+6.1f} %\n",
            p.speed, more(p.diagonal.published, p.straight.published),
            more(p.diagonal.standing, p.straight.standing),
            more(p.diagonal.xy_motors, p.straight.xy_motors),
            more(p.diagonal.machine, p.straight.machine));
}

}  // namespace

std::string_view pattern_of(const ExperimentRun& run) { return patterns.at(run.pattern).name; }

Agreement Replay::agreed() const { return agreement(runs, all ? any : is_usable); }

std::vector<BracketRow> bracket_rows(int threads) {
    std::vector<BracketRow> rows;
    std::vector<ExperimentRun> runs;
    for (const FeatureRow& row : appendix_rows()) {
        if (row.part != "bracket" || std::ranges::count(runs, row.run) > 0) continue;
        runs.push_back(row.run);
        rows.push_back({row.run, row.energy, 0});
    }
    const std::vector<double> energies = bracket_energies(runs, threads);
    for (std::size_t i = 0; i < rows.size(); ++i) rows[i].ours = energies[i];
    return rows;
}

AppendixCheck appendix_check() {
    AppendixCheck check;
    for (const FeatureRow& row : appendix_rows()) {
        ++check.rows;
        const double off = std::abs(published_energy(row.features) / row.energy - 1);
        check.worst = std::max(check.worst, off);
    }
    return check;
}

Json replay_json(const Replay& replay) {
    const Agreement agreed = replay.agreed();
    const Json words = agreement_json(agreed);
    const AppendixCheck appendix = appendix_check();
    Json result{{"model", "published"},
                {"rows_counted", replay.all ? "all" : "usable"},
                {"mape_percent", words["mape_percent"]},
                {"spearman", words["spearman"]},
                {"spearman_by_shape", words["spearman_by_shape"]},
                {"agreement",
                 {{"usable", agreement_json(agreement(replay.runs, is_usable))},
                  {"usable_not_suspect", agreement_json(agreement(replay.runs, is_clean))},
                  {"all", agreement_json(agreement(replay.runs, any))}}},
                {"appendix", {{"rows", appendix.rows}, {"worst_relative", appendix.worst}}},
                {"appendix_d", appendix_json(replay)},
                {"bracket", bracket_json(replay.bracket)},
                {"claims", claims_json(replay)},
                {"speeds", speeds_json(replay.speeds)},
                {"break_even_mm_s", break_even_speed()}};
    result["rows"] = Json::array();
    for (const ReplayedRun& run : replay.runs) result["rows"].push_back(row_json(run));
    return result;
}

void write_rows(std::ostream& out, const Replay& replay) {
    out << "geometry,pattern,infill_angle_deg,geometry_angle_deg,published_mj,ours_mj,"
           "standing_form_mj,duration_s,usable,suspect,a_mm2_per_s2,b_mm2_per_s2,c_mm,h_s\n";
    for (const ReplayedRun& row : replay.runs) {
        const ExperimentRun& run = row.published.run;
        const Features& f = row.ours.features;
        fmt::print(out,
                   "{},{},{},{},{:.2f},{:.2f},{:.2f},{:.3f},{},{},{:.1f},{:.1f},{:.3f},{:.3f}\n",
                   shape_names[static_cast<std::size_t>(run.shape)], pattern_of(run),
                   run.infill_angle, run.part_angle, 1000 * row.published.energy,
                   1000 * row.ours.energy, 1000 * row.ours.standing, row.ours.duration,
                   usable(run) ? 1 : 0, row.published.suspect ? 1 : 0, f.A, f.B, f.C, f.H);
    }
}

void print_replay(const Console& console, const Replay& replay) {
    console.say("Somade (2023): {} prints made and charged by Eq. 28 (X and Y motors only)\n\n",
                replay.runs.size());
    console.say(
        "  published rows                       rows  off, mean  worst   Spearman  by shape:");
    for (const std::string_view name : shape_names) console.say(" {}", name);
    console.say("\n");
    print_agreement(console, "all but 42 that cannot be right", agreement(replay.runs, is_usable));
    print_agreement(console, "and without the other suspect ones",
                    agreement(replay.runs, is_clean));
    print_agreement(console, "all, suspect or not", agreement(replay.runs, any));
    const AppendixCheck appendix = appendix_check();
    console.say("\nAppendices D and E: Eq. 28 on {} rows of features, worst difference {:.1e}\n",
                appendix.rows, appendix.worst);
    console.say("\nClaims, against {} of the published rows and against our runs:\n",
                replay.all ? "all" : "the unsuspected ones");
    for (const ClaimResult& result : claim_results(replay))
        console.say("\n* {}\n  published: {}\n  our runs:  {}\n", console.strong(result.claim),
                    result.published_data, result.our_runs);
    print_speeds(console, replay.speeds);
}

}  // namespace bead::cli
