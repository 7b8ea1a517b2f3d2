#include "replay_pictures.h"

#include <fmt/ostream.h>

#include <algorithm>

#include "scene/chart.h"

namespace bead::cli {
namespace {

double published(const ModelEnergies& e) { return e.published; }
double standing(const ModelEnergies& e) { return e.standing; }
double xy_motors(const ModelEnergies& e) { return e.xy_motors; }
double machine(const ModelEnergies& e) { return e.machine; }

struct Model {
    const char* name;
    double (*energy)(const ModelEnergies&);
};
constexpr Model models[]{{"Eq. 28, as published", published},
                         {"Eq. 28, standing form", standing},
                         {"physics: X and Y motors", xy_motors},
                         {"physics: whole machine", machine}};

ChartSeries points_of(const Replay& replay, std::size_t shape, bool suspect) {
    ChartSeries series{suspect ? "" : std::string(shape_names[shape]),
                       chart_inks[shape],
                       suspect ? ChartMark::rings : ChartMark::dots,
                       {}};
    for (const ReplayedRun& run : replay.runs) {
        if (run.published.run.shape != static_cast<Shape>(shape)) continue;
        const bool doubted = run.published.suspect || !usable(run.published.run);
        if (doubted == suspect)
            series.points.push_back({run.published.energy / 1000, run.ours.energy / 1000});
    }
    return series;
}

}  // namespace

std::string scatter_picture(const Replay& replay) {
    Chart picture{"300 prints: ours against published (hollow: suspect rows)",
                  {"published, kJ", 4, 16, 2},
                  {"ours, kJ", 4, 16, 2},
                  {{"equal", "#888", ChartMark::curve, {{4, 4}, {16, 16}}}}};
    for (std::size_t shape = 0; shape < shape_names.size(); ++shape)
        for (const bool suspect : {true, false})
            picture.series.push_back(points_of(replay, shape, suspect));
    return chart(picture);
}

std::string angle_picture(const std::vector<ModelEnergies>& points) {
    Chart picture{"One print, its infill turned: energy against that at 0°",
                  {"angle of the infill, °", 0, 90, 15},
                  {"change, %", -20, 30, 10},
                  {}};
    for (std::size_t k = 0; k < std::size(models); ++k) {
        ChartSeries curve{models[k].name, chart_inks[k], ChartMark::curve, {}};
        const double first = models[k].energy(points.front());
        for (std::size_t i = 0; i < points.size(); ++i)
            curve.points.push_back(
                {static_cast<double>(i), 100 * (models[k].energy(points[i]) / first - 1)});
        picture.series.push_back(std::move(curve));
    }
    return chart(picture);
}

void write_angles(std::ostream& out, const std::vector<ModelEnergies>& points) {
    out << "infill_angle_deg,published_j,standing_form_j,xy_motors_j,machine_j,duration_s\n";
    for (std::size_t i = 0; i < points.size(); ++i)
        fmt::print(out, "{},{:.3f},{:.3f},{:.3f},{:.3f},{:.3f}\n", i, points[i].published,
                   points[i].standing, points[i].xy_motors, points[i].machine, points[i].duration);
}

}  // namespace bead::cli
