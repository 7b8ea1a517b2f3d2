#include "job/published_tables.h"

#include <algorithm>
#include <array>

#include "core/expects.h"
#include "job/embedded_table.h"

namespace bead {
namespace {

// In the order of `patterns`.
constexpr std::array<std::string_view, experiment_patterns> pattern_names{
    "Rectilinear", "Concentric", "Hilbert Curve", "Archimedean Chords", "Octogram Spiral"};

struct Reading {
    const EmbeddedTable& table;
    const EmbeddedTable::Row& row;
    [[nodiscard]] int angle(std::string_view column) const {
        return static_cast<int>(table.number(row, column).value_or(0));
    }
    [[nodiscard]] double joules() const {
        return table.number(row, "energy_mWs").value_or(0) / 1000;
    }
    [[nodiscard]] std::size_t pattern() const {
        const auto name = std::ranges::find(pattern_names, table.text(row, "pattern"));
        BEAD_EXPECTS(name != pattern_names.end());
        return static_cast<std::size_t>(name - pattern_names.begin());
    }
    [[nodiscard]] std::optional<Features> features(
        const std::array<std::string_view, 4>& columns) const {
        std::array<double, 4> values{};
        for (std::size_t i = 0; i < columns.size(); ++i) {
            const std::optional<double> value = table.number(row, columns[i]);
            if (!value) return {};
            values[i] = *value;
        }
        return Features{values[0], values[1], values[2], values[3]};
    }
};

Shape shape_named(std::string_view name) {
    const auto found = std::ranges::find(shape_names, name);
    BEAD_EXPECTS(found != shape_names.end());
    return static_cast<Shape>(found - shape_names.begin());
}

void append_appendix(std::vector<FeatureRow>& rows, std::string_view path, const char* part) {
    const EmbeddedTable table(path);
    for (const EmbeddedTable::Row& cells : table.rows()) {
        const Reading row{table, cells};
        const auto features =
            row.features({"a_mm2_per_s2", "b_mm2_per_s2", "c_mm", "t_hold_total_s"});
        if (!features) continue;
        const ExperimentRun run{Shape::rectangle, row.pattern(), row.angle("infill_angle_deg"),
                                row.angle("geometry_angle_deg")};
        rows.push_back({part, run, *features, row.joules()});
    }
}

}  // namespace

std::vector<PublishedRun> published_runs() {
    const EmbeddedTable table("somade2023/doe300.csv");
    std::vector<PublishedRun> runs;
    for (const EmbeddedTable::Row& cells : table.rows()) {
        const Reading row{table, cells};
        runs.push_back({{shape_named(table.text(cells, "geometry")), row.pattern(),
                         row.angle("infill_angle_deg"), row.angle("geometry_angle_deg")},
                        row.joules(),
                        table.text(cells, "audit_flag") != "ok"});
    }
    return runs;
}

std::vector<FeatureRow> appendix_rows() {
    std::vector<FeatureRow> rows;
    append_appendix(rows, "somade2023/appendix_d_infill.csv", "rectangle");
    append_appendix(rows, "somade2023/appendix_d_geometry.csv", "rectangle");
    append_appendix(rows, "somade2023/appendix_e_infill.csv", "bracket");
    append_appendix(rows, "somade2023/appendix_e_geometry.csv", "bracket");
    const std::vector<PublishedRun> published = published_runs();
    const auto run_of = [](const PublishedRun& other) { return other.run; };
    for (FeatureRow& row : rows) {
        if (row.energy > 0 || row.part != "rectangle") continue;
        const auto same = std::ranges::find(published, row.run, run_of);
        if (same != published.end()) row.energy = same->energy;
    }
    std::erase_if(rows, [](const FeatureRow& row) { return row.energy <= 0; });
    return rows;
}

std::vector<FeatureRow> calibration_rows() {
    const EmbeddedTable table("somade2023/table3_calibration.csv");
    std::vector<FeatureRow> rows;
    for (const EmbeddedTable::Row& cells : table.rows()) {
        const Reading row{table, cells};
        const auto features = row.features({"A_mm2_per_s2", "B_mm2_per_s2", "C_mm", "H_s"});
        BEAD_EXPECTS(features.has_value());
        rows.push_back({std::string(table.text(cells, "geometry")),
                        {Shape::square, row.pattern(), row.angle("infill_angle_deg"), 0},
                        *features,
                        row.joules()});
    }
    return rows;
}

}  // namespace bead
