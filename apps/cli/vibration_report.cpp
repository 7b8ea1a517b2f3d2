#include "vibration_report.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "scene/chart.h"

namespace bead::cli {
namespace {

constexpr double seen_to = 60;  // Hz, of the picture

struct ReportRow {
    const char* label;
    std::function<std::string(const Response&)> value;
};

std::string share(const Response& r, double part) {
    return fmt::format("{:.0f} J ({:.1f} %)", part, 100 * part / total(r.energy));
}

const std::vector<ReportRow>& report_rows() {
    using R = const Response&;
    static const std::vector<ReportRow> table{
        {"time", [](R r) { return spoken_time(r.time); }},
        {"rms acceleration, mm/s²", [](R r) { return fmt::format("{:.0f}", r.rms_acceleration); }},
        {"  of it 5-40 Hz", [](R r) { return fmt::format("{:.0f}", r.rms_5_40hz); }},
        {"peak, Hz", [](R r) { return fmt::format("{:.1f}", r.peak_frequency); }},
        {"deviation mean, mm", [](R r) { return fmt::format("{:.3f}", r.deviation.mean); }},
        {"  largest", [](R r) { return fmt::format("{:.3f}", r.deviation.max); }},
        {"contour error mean, mm", [](R r) { return fmt::format("{:.3f}", r.contour.mean); }},
        {"  99 % below", [](R r) { return fmt::format("{:.3f}", r.contour.p99); }},
        {"  largest", [](R r) { return fmt::format("{:.3f}", r.contour.max); }},
        {"off nominal speed, %", [](R r) { return fmt::format("{:.0f}", 100 * r.off_nominal); }},
        {"motors' work", [](R r) { return share(r, r.energy.servo); }},
        {"motors' windings", [](R r) { return share(r, r.energy.copper); }},
        {"melting", [](R r) { return share(r, r.energy.melt); }},
        {"all else, by time", [](R r) { return share(r, r.energy.base); }},
        {"CO2, g", [](R r) { return fmt::format("{:.1f}", r.co2); }}};
    return table;
}

Json law_json(const LawResponse& row) {
    const TimeLaw& law = row.law;
    Json json{{"name", row.name},
              {"profile", profile_names[std::size_t(law.profile)]},
              {"shaper", law.shaper ? Json(shaper_names[std::size_t(*law.shaper)]) : Json()},
              {"tuning", law.tuning},
              {"feed_forward", law.feed_forward}};
    if (law.profile == SpeedProfile::jerk_limited) {
        json["jerk_mm_s3"] = law.jerk;
        json["velocity_step_mm_s"] = law.velocity_step;
    }
    return json;
}

Json response_json(const LawResponse& row) {
    const Response& r = row.response;
    return {{"law", law_json(row)},
            {"time_s", r.time},
            {"rms_acceleration_mm_s2", r.rms_acceleration},
            {"rms_5_40hz", r.rms_5_40hz},
            {"psd_top3", r.psd_top3},
            {"peak_frequency_hz", r.peak_frequency},
            {"deviation_mm",
             {{"min", r.deviation.min}, {"mean", r.deviation.mean}, {"max", r.deviation.max}}},
            {"contour_error_mm",
             {{"mean", r.contour.mean}, {"p99", r.contour.p99}, {"max", r.contour.max}}},
            {"off_nominal", r.off_nominal},
            {"energy_j",
             {{"total", total(r.energy)},
              {"servo", r.energy.servo},
              {"copper", r.energy.copper},
              {"melt", r.energy.melt},
              {"base", r.energy.base}}},
            {"volume_mm3", r.volume},
            {"material_g", r.material},
            {"co2_g", r.co2}};
}

}  // namespace

void print_vibration(const Console& console, const VibrationResult& result) {
    console.say("{:<26}{:>20}{:>20}\n", "first modes, Hz",
                fmt::format("X {:.1f}", result.modes[0].frequency),
                fmt::format("Y {:.1f}", result.modes[1].frequency));
    console.say("{:<26}{:>20}{:>20}\n\n", "  damping ratio",
                fmt::format("{:.3f}", result.modes[0].damping),
                fmt::format("{:.3f}", result.modes[1].damping));
    console.say("{:<26}", "time law");
    for (const LawResponse& law : result.laws) console.say("{:>20}", law.name);
    console.say("\n");
    for (const ReportRow& row : report_rows()) {
        // By hand: columns are counted in letters, of which some are longer than a byte.
        const std::string label = row.label;
        const auto letters =
            std::ranges::count_if(label, [](char c) { return (c & 0xC0) != 0x80; });
        console.say("{}{:>{}}", label, "", std::max<std::ptrdiff_t>(1, 26 - letters));
        for (const LawResponse& law : result.laws) console.say("{:>20}", row.value(law.response));
        console.say("\n");
    }
}

Json vibration_json(const VibrationResult& result) {
    Json json = response_json(result.laws.front());
    json["modes"] = Json::array();
    for (std::size_t k = 0; k < 2; ++k)
        json["modes"].push_back({{"axis", std::string(1, "xy"[k])},
                                 {"frequency_hz", result.modes[k].frequency},
                                 {"damping_ratio", result.modes[k].damping}});
    json["laws"] = Json::array();
    for (const LawResponse& law : result.laws) json["laws"].push_back(response_json(law));
    return json;
}

void write_spectra(std::ostream& out, const VibrationResult& result) {
    out << "freq_hz";
    std::size_t bins = 0;
    for (const LawResponse& law : result.laws) {
        out << ',' << law.name;
        bins = std::max(bins, law.response.spectrum.density.size());
    }
    out << '\n';
    for (std::size_t k = 0; k < bins; ++k) {
        out << fmt::format("{:.6g}", double(k) * result.laws.front().response.spectrum.step);
        for (const LawResponse& law : result.laws) {
            const Spectrum& spectrum = law.response.spectrum;
            out << fmt::format(",{:.6g}", k < spectrum.density.size() ? spectrum.density[k] : 0.0);
        }
        out << '\n';
    }
}

std::string spectra_picture(const VibrationResult& result, const std::string& title) {
    Chart plot{.title = title,
               .x = {"frequency, Hz", 0, seen_to, 10},
               .y = {"density of acceleration, (mm/s²)/√Hz", 0, 1},
               .series = {}};
    double most = 0;
    for (std::size_t i = 0; i < result.laws.size(); ++i) {
        const Spectrum& spectrum = result.laws[i].response.spectrum;
        ChartSeries series{.name = result.laws[i].name,
                           .ink = chart_inks[i % std::size(chart_inks)],
                           .mark = ChartMark::curve,
                           .points = {}};
        for (std::size_t k = 0; k < spectrum.density.size(); ++k) {
            const double f = double(k) * spectrum.step, d = std::sqrt(spectrum.density[k]);
            if (f > seen_to) break;
            series.points.push_back({f, d});
            most = std::max(most, d);
        }
        plot.series.push_back(std::move(series));
    }
    plot.y.to = most > 0 ? 1.05 * most : 1;
    return chart(plot);
}

std::string over_time_picture(const VibrationResult& result, const std::string& title) {
    double end = 0, most = 0;
    for (const LawResponse& law : result.laws)
        for (const RmsWindow& window : law.over_time) {
            end = std::max(end, window.to);
            most = std::max(most, window.rms);
        }
    const bool long_one = end > 600;
    const double unit = long_one ? 60 : 1;  // s
    Chart plot{.title = title,
               .x = {long_one ? "time, min" : "time, s", 0, end > 0 ? end / unit : 1},
               .y = {"acceleration, root mean square, mm/s²", 0, most > 0 ? 1.05 * most : 1},
               .series = {}};
    for (std::size_t i = 0; i < result.laws.size(); ++i) {
        ChartSeries series{.name = result.laws[i].name,
                           .ink = chart_inks[i % std::size(chart_inks)],
                           .mark = ChartMark::curve,
                           .points = {}};
        for (const RmsWindow& window : result.laws[i].over_time) {
            series.points.push_back({window.from / unit, window.rms});
            series.points.push_back({window.to / unit, window.rms});
        }
        plot.series.push_back(std::move(series));
    }
    return chart(plot);
}

}  // namespace bead::cli
