#include "simulate_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace bead::cli {
namespace {

constexpr std::array axis_names{"X", "Y", "Z", "E"};

double ratio(double part, double whole) { return whole > 0 ? part / whole : 0; }

void print_totals(const Console& console, const JudgedFile& judged) {
    const MotionTotals& m = judged.cost.motion;
    console.say("{}: {}\n", judged.name, described(judged.file));
    console.say("printing time {} ({:.1f} s)", console.strong(spoken_time(m.duration)), m.duration);
    if (judged.slicer_estimate)
        console.say("; the slicer says {}, ours is {:+.2f} %", spoken_time(*judged.slicer_estimate),
                    100 * (m.duration / *judged.slicer_estimate - 1));
    console.say(
        "\nhead {:.2f} m, of it {:.2f} m travel in {} moves; {} retractions; {:.2f} m of "
        "filament\n",
        m.length / 1000, m.travel / 1000, m.travel_moves, m.retractions, m.extruded / 1000);
    console.say("{} moves, of which {:.0f} % never reach their speed\n", m.moves,
                100 * ratio(double(m.short_of_speed), double(m.moves)));
}

void print_role(const Console& console, std::string_view name, const RoleMotion& role,
                double whole) {
    console.say("{:>10} {:>18} {:>6.1f} % {:>12.2f} m {:>8.1f} mm/s {:>10.2f} m\n", name,
                spoken_time(role.duration), 100 * ratio(role.duration, whole), role.length / 1000,
                ratio(role.length, role.duration), role.extruded / 1000);
}

void print_roles(const Console& console, const MotionTotals& m) {
    console.say("\n{:>10} {:>18} {:>8} {:>14} {:>13} {:>12}\n", "feature", "time", "share", "way",
                "mean speed", "filament");
    const PerRole<RoleMotion> by_role = motion_by_role(m);
    for (std::size_t i = 0; i < by_role.size(); ++i)
        if (by_role[i].moves > 0) print_role(console, role_names[i], by_role[i], m.duration);
    if (m.dwell > 0)
        console.say("{:>10} {:>18} {:>6.1f} %\n", "dwells", spoken_time(m.dwell),
                    100 * ratio(m.dwell, m.duration));
}

void print_axes(const Console& console, const JudgedFile& judged) {
    const MotionTotals& m = judged.cost.motion;
    console.say("\n{:>5} {:>11} {:>11} {:>11} {:>11} {:>12} {:>15} {:>12}\n", "axis", "speeding up",
                "coasting", "slowing", "standing", "way", "top speed", "asked");
    for (std::size_t i = 0; i < axis_names.size(); ++i) {
        const AxisTimes& axis = m.axes[i];
        console.say(
            "{:>5} {:>9.1f} s {:>9.1f} s {:>9.1f} s {:>9.1f} s {:>10.3f} m {:>10.1f} mm/s "
            "{:>7.1f} mm/s\n",
            axis_names[i], axis.accelerate, axis.coast, axis.decelerate, axis.hold,
            axis.distance / 1000, m.fastest_axis[i], judged.asked.axes()[i]);
    }
    console.say("{:>5} {:>47} {:>10.3f} m {:>10.1f} mm/s {:>7.1f} mm/s\n", "path", "",
                m.length / 1000, m.fastest, judged.asked.path());
}

std::string described(const std::vector<LayerMotion>& layers, std::size_t i) {
    return fmt::format("no. {} at {:.2f} mm {}", i + 1, layers[i].z,
                       spoken_time(duration(layers[i])));
}

void print_layers(const Console& console, const MotionTotals& m) {
    const std::vector<LayerMotion>& layers = m.by_layer;
    if (layers.empty()) return;
    const auto shorter = [](const LayerMotion& a, const LayerMotion& b) {
        return duration(a) < duration(b);
    };
    const auto [fastest, slowest] = std::ranges::minmax_element(layers, shorter);
    console.say("\n{} layers, {} each on average: first {}, slowest {}, fastest {}; {} before\n",
                layers.size(),
                spoken_time((m.duration - duration(m.before_layers)) / double(layers.size())),
                spoken_time(duration(layers.front())),
                described(layers, std::size_t(slowest - layers.begin())),
                described(layers, std::size_t(fastest - layers.begin())),
                spoken_time(duration(m.before_layers)));
}

Json by_role_json(const LayerMotion& layer) {
    Json roles = Json::object();
    for (std::size_t i = 0; i < layer.by_role.size(); ++i)
        if (layer.by_role[i].moves > 0)
            roles[std::string(role_names[i])] = layer.by_role[i].duration;
    return roles;
}

Json layer_json(const LayerMotion& layer) {
    const RoleMotion all = total(layer.by_role);
    return {{"z_mm", layer.z},
            {"height_mm", layer.height},
            {"time_s", duration(layer)},
            {"length_mm", all.length},
            {"extruded_mm", all.extruded},
            {"moves", all.moves},
            {"time_by_role_s", by_role_json(layer)}};
}

Json roles_json(const MotionTotals& motion) {
    const PerRole<RoleMotion> by_role = motion_by_role(motion);
    Json roles = Json::object();
    for (std::size_t i = 0; i < by_role.size(); ++i) {
        const RoleMotion& role = by_role[i];
        if (role.moves == 0) continue;
        roles[std::string(role_names[i])] = {{"time_s", role.duration},
                                             {"share", ratio(role.duration, motion.duration)},
                                             {"length_mm", role.length},
                                             {"extruded_mm", role.extruded},
                                             {"mean_speed_mm_s", ratio(role.length, role.duration)},
                                             {"moves", role.moves}};
    }
    return roles;
}

Json speeds_json(const JudgedFile& judged) {
    const auto of = [](double reached, double asked) {
        return Json{{"reached_mm_s", reached}, {"asked_mm_s", asked}};
    };
    const MotionTotals& m = judged.cost.motion;
    Json speeds{{"path", of(m.fastest, judged.asked.path())}};
    constexpr std::array names{"x", "y", "z", "e"};
    for (std::size_t i = 0; i < names.size(); ++i)
        speeds[names[i]] = of(m.fastest_axis[i], judged.asked.axes()[i]);
    return speeds;
}

class LayerRows {
  public:
    LayerRows(std::ostream& out, const std::string& name) : out_(out), name_(name) {}

    void write(std::size_t number, const LayerMotion& layer) {
        for (std::size_t i = 0; i < layer.by_role.size(); ++i)
            if (layer.by_role[i].moves > 0) row(number, layer, role_names[i], layer.by_role[i]);
        if (layer.dwell > 0) row(number, layer, "dwell", {0, layer.dwell, 0, 0});
    }

  private:
    void row(std::size_t number, const LayerMotion& layer, std::string_view role,
             const RoleMotion& motion) {
        out_ << name_
             << fmt::format("{},{:.6g},{:.6g},{},{:.9g},{:.9g},{:.9g},{},{:.6g}\n", number, layer.z,
                            layer.height, role, motion.duration, motion.length, motion.extruded,
                            motion.moves, ratio(motion.length, motion.duration));
    }

    std::ostream& out_;
    std::string name_;
};

// As a field of CSV.
std::string quoted(const std::string& text) {
    std::string field = "\"";
    for (const char c : text) field += c == '"' ? std::string("\"\"") : std::string(1, c);
    return field + '"';
}

}  // namespace

void print_simulation(const Console& console, const JudgedFile& judged,
                      const MachineOptions& options) {
    const MotionTotals& m = judged.cost.motion;
    print_totals(console, judged);
    print_roles(console, m);
    print_axes(console, judged);
    print_layers(console, m);
    print_limits(console, judged);
    console.say("\nfirmware {} (from: {}), quirks {}, look-ahead {}\n",
                name_of(judged.choice.firmware.firmware), judged.choice.firmware.source,
                options.quirks, options.lookahead);
    if (const std::string ignored = ignored_in(judged.file); !ignored.empty())
        console.say("without effect here: {}\n", ignored);
    for (const std::string& note : judged.choice.notes) console.say("note: {}\n", note);
}

Json simulation_json(const JudgedFile& judged, const MachineOptions& options) {
    Json result = motion_json(judged.cost);
    result["roles"] = roles_json(judged.cost.motion);
    result["speeds"] = speeds_json(judged);
    Json layers = Json::array();
    for (const LayerMotion& layer : judged.cost.motion.by_layer)
        layers.push_back(layer_json(layer));
    result["before_layers_s"] = duration(judged.cost.motion.before_layers);
    result["by_layer"] = std::move(layers);
    result["lines"] = judged.file.lines;
    result["slicer"] = judged.file.slicer;
    if (judged.slicer_estimate) result["slicer_estimate_s"] = *judged.slicer_estimate;
    result["limits"] = limits_json(judged);
    result["firmware"] = name_of(judged.choice.firmware.firmware);
    result["firmware_source"] = judged.choice.firmware.source;
    result["quirks"] = options.quirks;
    result["lookahead"] = options.lookahead;
    result["ignored"] = judged.file.ignored;
    return result;
}

void write_layers_head(std::ostream& out, bool with_name) {
    out << (with_name ? "file," : "")
        << "layer,z_mm,height_mm,role,time_s,length_mm,extruded_mm,moves,mean_speed_mm_s\n";
}

void write_layers(std::ostream& out, const JudgedFile& judged, bool with_name) {
    LayerRows rows(out, with_name ? quoted(judged.name) + ',' : "");
    const MotionTotals& m = judged.cost.motion;
    rows.write(0, m.before_layers);
    for (std::size_t i = 0; i < m.by_layer.size(); ++i) rows.write(i + 1, m.by_layer[i]);
}

}  // namespace bead::cli
