#include "plan/program.h"

#include <algorithm>
#include <cmath>

#include "core/expects.h"

namespace bead {
namespace {

constexpr double place_steps = 1e3;     // per mm: 3 decimals
constexpr double filament_steps = 1e5;  // 5 decimals

// The double that reading the printed decimal gives.
double rounded(double value, double steps) { return std::round(value * steps) / steps; }

double filament_area(const ProgramOptions& options) {
    return pi / 4 * options.filament * options.filament;
}

// Writes the moves of one layer.
class Writer {
  public:
    Writer(std::vector<Command>& out, Nozzle& nozzle, const ProgramOptions& options)
        : out_(out), nozzle_(nozzle), options_(options) {}

    void start_layer(double z, double height, int index) {
        out_.push_back({LayerStart{z, height}});
        SetPosition zero;
        zero.to[axis_e] = 0;
        out_.push_back({zero});
        nozzle_.exact_e -= nozzle_.at[axis_e];
        nozzle_.at[axis_e] = 0;
        if (index == 0) out_.push_back({SetFan{0}});
        if (index != 1) return;
        out_.push_back({SetFan{options_.fan}});
        if (options_.hotend != options_.hotend_first)
            out_.push_back({SetHeat{Heater::hotend, options_.hotend, false}});
    }

    void raise_to(double z) {
        Position to = nozzle_.at;
        to[axis_z] = rounded(z, place_steps);
        move(to, options_.z_speed, Role::travel, {});
    }

    void retract() {
        if (nozzle_.retracted || options_.retract_length <= 0) return;
        feed_filament(-options_.retract_length);
        nozzle_.retracted = true;
    }

    void follow(const Path& path) {
        if (path.role == Role::travel)
            travel(path);
        else
            print(path);
    }

  private:
    void travel(const Path& path) {
        if (path.retracted) retract();
        for (const Vec3& point : path.points) move(place_of(point), path.speed, Role::travel, {});
    }

    void print(const Path& path) {
        if (nozzle_.retracted) feed_filament(options_.retract_length);
        nozzle_.retracted = false;
        set_acceleration(path.acceleration);
        const double per_mm = section(path.bead) / filament_area(options_);
        BEAD_EXPECTS(is_at(path.points.front()));
        for (std::size_t i = 1; i < path.points.size(); ++i) {
            const Vec3 way = path.points[i] - path.points[i - 1];
            nozzle_.exact_e += length(way) * per_mm;
            Position to = place_of(path.points[i]);
            if (is_here(to)) continue;  // its filament goes with the next move
            to[axis_e] = rounded(nozzle_.exact_e, filament_steps);
            move(to, path.speed, path.role, path.bead);
        }
    }

    // Other than the usual acceleration can be asked for only if there is a known usual to return
    // to.
    void set_acceleration(double asked) {
        const std::optional<double> usual = options_.limits.acceleration;
        if (!usual) return;
        const double wanted = asked > 0 ? asked : *usual;
        const double present = nozzle_.acceleration > 0 ? nozzle_.acceleration : *usual;
        nozzle_.acceleration = wanted;
        if (wanted == present) return;
        SetLimits limits;
        limits.acceleration = wanted;
        out_.push_back({limits});
    }

    void feed_filament(double by) {
        nozzle_.exact_e += by;
        Position to = nozzle_.at;
        to[axis_e] = rounded(nozzle_.exact_e, filament_steps);
        move(to, options_.retract_speed, Role::travel, {});
    }

    void move(const Position& to, double speed, Role role, const Bead& bead) {
        if (to == nozzle_.at) return;
        out_.push_back({Move{to, speed, role, bead}});
        nozzle_.at = to;
    }

    [[nodiscard]] Position place_of(const Vec3& point) const {
        return {rounded(point.x, place_steps), rounded(point.y, place_steps),
                rounded(point.z, place_steps), nozzle_.at[axis_e]};
    }
    [[nodiscard]] bool is_here(const Position& place) const {
        return place[axis_x] == nozzle_.at[axis_x] && place[axis_y] == nozzle_.at[axis_y] &&
               place[axis_z] == nozzle_.at[axis_z];
    }
    [[nodiscard]] bool is_at(const Vec3& point) const {
        constexpr double near = 2e-3;  // mm, more than rounding twice
        return length(point - Vec3{nozzle_.at[axis_x], nozzle_.at[axis_y], nozzle_.at[axis_z]}) <
               near;
    }

    std::vector<Command>& out_;
    Nozzle& nozzle_;
    const ProgramOptions& options_;
};

bool names_any(const SetLimits& limits) {
    for (std::size_t i = 0; i < axis_count; ++i)
        if (limits.max_acceleration[i] || limits.max_feedrate[i] || limits.jerk[i]) return true;
    return limits.acceleration || limits.retract_acceleration || limits.travel_acceleration;
}

}  // namespace

void append_start(std::vector<Command>& out, Nozzle& nozzle, const ProgramOptions& options) {
    if (names_any(options.limits)) out.push_back({options.limits});
    out.push_back({SetHeat{Heater::hotend, options.hotend_first, false}});
    out.push_back({SetHeat{Heater::bed, options.bed, false}});
    out.push_back({SetHeat{Heater::bed, options.bed, true}});
    out.push_back({SetHeat{Heater::hotend, options.hotend_first, true}});
    out.push_back({Home{}});
    SetPosition zero;
    zero.to[axis_e] = 0;
    out.push_back({zero});
    out.push_back({SetFan{0}});
    nozzle = {};
}

void append_layer(std::vector<Command>& out, const Toolpath& layer, double z, double height,
                  int index, Nozzle& nozzle, const ProgramOptions& options) {
    Writer writer(out, nozzle, options);
    writer.start_layer(z, height, index);
    if (layer.empty()) return;
    if (layer.front().retracted) writer.retract();
    writer.raise_to(z);
    for (const Path& path : layer) writer.follow(path);
}

void append_end(std::vector<Command>& out, Nozzle& nozzle, const ProgramOptions& options) {
    constexpr double clearance = 10;  // mm
    Writer writer(out, nozzle, options);
    writer.retract();
    writer.raise_to(
        std::max(nozzle.at[axis_z], std::min(nozzle.at[axis_z] + clearance, options.highest)));
    out.push_back({SetHeat{Heater::hotend, 0, false}});
    out.push_back({SetHeat{Heater::bed, 0, false}});
    out.push_back({SetFan{0}});
}

}  // namespace bead
