// What `replay` has to say of the published experiment: agreement, tables, claims.
#pragma once
#include <string>
#include <vector>

#include "console.h"
#include "job/published_tables.h"
#include "json_result.h"
#include "study/angle_scan.h"
#include "study/case_study.h"
#include "study/claims.h"

namespace bead::cli {

// A published strategy put to the test. Texts start with the verdict.
struct ClaimResult {
    std::string claim, published_data, our_runs;
    Tally published, ours;  // 0 of 0 where nothing was counted
};

// A print of the case study; ours is of a stand-in.
struct BracketRow {
    ExperimentRun run;
    double published = 0, ours = 0;  // J
};
std::vector<BracketRow> bracket_rows(int threads);

struct Replay {
    bool all = false;  // rows that cannot be right count too
    std::vector<ReplayedRun> runs;
    std::vector<BracketRow> bracket;
    std::vector<SpeedPoint> speeds;
    [[nodiscard]] Agreement agreed() const;
};

std::vector<ClaimResult> claim_results(const Replay& replay);

// Eq. 28 on the features that the appendices print, beside the energies that they print.
struct AppendixCheck {
    int rows = 0;
    double worst = 0;  // largest |ours / printed - 1|
};
AppendixCheck appendix_check();

Json replay_json(const Replay& replay);
void write_rows(std::ostream& out, const Replay& replay);  // .csv
void print_replay(const Console& console, const Replay& replay);

// "Rectilinear": a published row's pattern by our name for it.
std::string_view pattern_of(const ExperimentRun& run);

}  // namespace bead::cli
