#include "smooth_report.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/error.h"
#include "core/output_file.h"
#include "core/parallel.h"
#include "layer_outline.h"
#include "scene/layer_picture.h"
#include "setpoints.h"
#include "smooth_rows.h"

namespace bead::cli {
namespace {

constexpr std::int64_t sample_size = 24;   // layers
constexpr double most_sampled_time = 900;  // s

struct Row {
    const char* label;
    double (*value)(const SmoothSide&);
    int decimals;
};
using S = const SmoothSide&;
constexpr std::array rows{
    Row{"length, m", [](S s) { return s.figures().length / 1000; }, 2},
    Row{"  travel, m", [](S s) { return s.figures().travel / 1000; }, 2},
    Row{"  infill with its travel, m", [](S s) { return s.figures().infill_length / 1000; }, 2},
    Row{"points", [](S s) { return s.figures().points; }, 0},
    Row{"turning points (45°)", [](S s) { return s.figures().turning; }, 0},
    Row{"  within 1 mm", [](S s) { return s.figures().windowed; }, 0},
    Row{"volume, mm³", [](S s) { return s.figures().volume; }, 1},
    Row{"material, g", [](S s) { return s.material(); }, 2},
    Row{"under-fill, mm² *", [](S s) { return s.figures().underfill; }, 2},
    Row{"over-fill, mm² *", [](S s) { return s.figures().overfill; }, 2},
    Row{"outline off by, mm *", [](S s) { return s.figures().outline_deviation; }, 3},
    Row{"time, s", [](S s) { return s.time(); }, 0},
    Row{"energy, kJ", [](S s) { return total(s.energy()) / 1000; }, 1},
    Row{"CO2, g", [](S s) { return s.co2(); }, 1},
    Row{"rms acceleration, mm/s² *", [](S s) { return s.response().rms_acceleration; }, 0},
    Row{"  of it 5-40 Hz *", [](S s) { return s.response().rms_5_40hz; }, 0},
    Row{"deviation mean, mm *", [](S s) { return s.response().deviation.mean; }, 4},
    Row{"  largest *", [](S s) { return s.response().deviation.max; }, 4},
    Row{"contour error mean, mm *", [](S s) { return s.response().contour.mean; }, 4},
    Row{"  99 % below *", [](S s) { return s.response().contour.p99; }, 4},
    Row{"  largest *", [](S s) { return s.response().contour.max; }, 4},
};

std::string change(double before, double after) {
    if (!(std::abs(before) > 1e-12)) return "";
    return fmt::format("{:+.1f} %", 100 * (after / before - 1));
}

}  // namespace

struct SmoothReport::State {
    SmoothReportOptions options;
    SmoothSide before, after;
    std::optional<Setpoints> setpoints;
    std::int64_t seen = -1;  // part of the file of which a layer is sampled
    int sampled = 0;
    double sampled_time = 0;  // s, of nominal speed
    std::optional<LayerPair> pictured;
    SmoothedFile file;

    explicit State(const SmoothReportOptions& o)
        : options(o), before(options.machine, options.law), after(options.machine, options.law) {
        if (options.setpoints.empty()) return;
        setpoints.emplace(options.setpoints, options.machine, options.law);
    }

    // One in every part of the file, but no more than so many seconds of printing in all.
    bool is_sampled(const LayerPair& pair) {
        if (options.all_layers) return true;
        const std::int64_t part = options.bytes > 0 ? pair.bytes * sample_size / options.bytes : 0;
        if (part <= seen) return false;
        seen = part;
        const double share = double(part + 1) / double(sample_size);
        if (sampled > 0 && sampled_time > most_sampled_time * share) return false;
        for (const Path& path : pair.before)
            if (path.speed > 0) sampled_time += length(path) / path.speed;
        return true;
    }

    void keep_for_picture(const LayerPair& pair) {
        if (options.picture.empty()) return;
        if (options.pictured) {
            if (pair.index + 1 == *options.pictured) pictured = pair;
        } else if (pair.smoothed && (!pictured || 2 * pictured->bytes < options.bytes)) {
            pictured = pair;
        }
    }

    void add(const std::vector<LayerPair>& layers) {
        std::vector<char> sampled_here;
        for (const LayerPair& pair : layers) {
            sampled_here.push_back(char(is_sampled(pair)));
            sampled += sampled_here.back();
            keep_for_picture(pair);
        }
        std::vector<std::array<PathFigures, 2>> figures(layers.size());
        parallel_for(layers.size(), options.threads, [&](std::size_t i) {
            figures[i] = {path_figures(layers[i].before), path_figures(layers[i].after)};
            if (sampled_here[i] != 0) add_coverage(layers[i], figures[i][0], figures[i][1]);
        });
        parallel_for(2, options.threads, [&](std::size_t side) {
            for (std::size_t i = 0; i < layers.size(); ++i) {
                SmoothSide& judged = side == 0 ? before : after;
                judged.add(figures[i][side]);
                if (setpoints && side == 1) setpoints->add(layers[i].after, layers[i].z);
                if (sampled_here[i] != 0)
                    judged.add(side == 0 ? layers[i].before : layers[i].after);
                else
                    judged.add_time(side == 0 ? layers[i].before_time : layers[i].after_time);
            }
        });
    }

    void draw() const {
        if (!pictured)
            throw Error(fmt::format("--layer: the print has no layer {}; it has {}",
                                    options.pictured.value_or(1), file.layers),
                        Fault::usage);
        const auto caption = [](const Toolpath& layer) {
            const PathFigures f = path_figures(layer);
            return fmt::format("{:.0f} mm, {:.0f} points, {:.0f} turning points", f.length,
                               f.points, f.windowed);
        };
        const std::array panels{Panel{"before", pictured->before, caption(pictured->before)},
                                Panel{"after", pictured->after, caption(pictured->after)}};
        OutputFile out(options.picture);
        out.stream() << layer_picture(
            panels, fmt::format("Layer {}, z = {:.2f} mm", pictured->index + 1, pictured->z));
        out.keep();
    }
};

SmoothReport::SmoothReport(const SmoothReportOptions& options)
    : state_(std::make_unique<State>(options)) {}
SmoothReport::~SmoothReport() = default;

void SmoothReport::add(const std::vector<LayerPair>& layers) { state_->add(layers); }

void SmoothReport::finish(const SmoothedFile& file) {
    state_->file = file;
    state_->before.finish();
    state_->after.finish();
    if (!state_->options.picture.empty()) state_->draw();
    if (state_->setpoints) state_->setpoints->finish();
}

void SmoothReport::print(const Console& console, const std::string& name) const {
    const SmoothedFile& file = state_->file;
    console.say("{}: {} of {} layers smoothed; under {}, modes of {:.1f} and {:.1f} Hz\n", name,
                file.smoothed, file.layers, state_->options.law_name, state_->options.modes[0],
                state_->options.modes[1]);
    for (const auto& [reason, count] : file.left)
        console.say("  {} layer{} left as {}: {}\n", count, count == 1 ? "" : "s",
                    count == 1 ? "it was" : "they were", reason);
    if (file.kept > 0)
        console.say("  {} strokes left as they were: a tolerance could not be kept\n", file.kept);
    console.say("{:<30}{:>14}{:>14}{:>12}\n", "", "before", "after", "change");
    for (const Row& row : rows) {
        const double b = row.value(state_->before), a = row.value(state_->after);
        const std::string label(row.label);
        const auto letters =
            std::ranges::count_if(label, [](char c) { return (c & 0xC0) != 0x80; });
        console.say("{}{:>{}}{:>14.{}f}{:>14.{}f}{:>12}\n", label, "", 30 - letters, b,
                    row.decimals, a, row.decimals, change(b, a));
    }
    console.say("* of {} of {} layers\n", state_->sampled, file.layers);
}

Json SmoothReport::json() const {
    const SmoothReportOptions& o = state_->options;
    const SmoothedFile& file = state_->file;
    const Json timing{{"law", o.law_name},
                      {"profile", profile_names[std::size_t(o.law.profile)]},
                      {"acceleration_mm_s2", o.law.acceleration},
                      {"square_corner_velocity_mm_s", o.law.square_corner_velocity}};
    const Json machine{{"modes_hz", {o.modes[0], o.modes[1]}}};
    Json before = state_->before.json(), after = state_->after.json();
    for (Json* const side : {&before, &after}) {
        (*side)["timing"] = timing;
        (*side)["machine"] = machine;
    }
    Json left = Json::object();
    for (const auto& [reason, count] : file.left) left[reason] = count;
    return {{"before", before},
            {"after", after},
            {"layers", file.layers},
            {"layers_smoothed", file.smoothed},
            {"layers_left", left},
            {"strokes_left", file.kept},
            {"layers_sampled", state_->sampled},
            {"chains", file.chains},
            {"links", file.links},
            {"arcs", file.arcs},
            {"blends", file.blends}};
}

}  // namespace bead::cli
