// Random streams of commands that G-code text can hold exactly: coordinates and feeds with as many
// decimals as are written, every move goes somewhere, something follows each layer's start.
//
//     RC_GTEST_PROP(Planner, keeps_limits, ()) {
//         const std::vector<Command> commands = stream_of(*stream_plans());
#pragma once
#include <rapidcheck.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <ostream>
#include <vector>

#include "toolpath/command.h"

namespace bead {

// One step of a stream in whole numbers: `kind` chooses what happens, the rest by how much.
struct StreamStep {
    int kind = 0;
    int x = 0, y = 0, z = 0, e = 0;
    int choice = 0;
};

inline std::ostream& operator<<(std::ostream& out, const StreamStep& step) {
    return out << "{" << step.kind << ": " << step.x << " " << step.y << " " << step.z << " "
               << step.e << ", " << step.choice << "}";
}

inline rc::Gen<StreamStep> stream_steps() {
    using rc::gen::inRange;
    return rc::gen::build<StreamStep>(rc::gen::set(&StreamStep::kind, inRange(0, 30)),
                                      rc::gen::set(&StreamStep::x, inRange(-200'000, 200'000)),
                                      rc::gen::set(&StreamStep::y, inRange(-200'000, 200'000)),
                                      rc::gen::set(&StreamStep::z, inRange(-2'000, 2'000)),
                                      rc::gen::set(&StreamStep::e, inRange(1, 500'000)),
                                      rc::gen::set(&StreamStep::choice, inRange(0, 1'000)));
}

class StreamBuilder {
  public:
    void add(const StreamStep& step) {
        switch (step.kind) {
            case 0:
                return set_position(step);
            case 1:
                return home(step);
            case 2:
                return put(Dwell{step.choice * 0.001});
            case 3:
                return put(Drain{});
            case 4:
                return put(SetHeat{.heater = step.x > 0 ? Heater::hotend : Heater::bed,
                                   .celsius = step.choice * 0.3,
                                   .wait = step.y > 0});
            case 5:
                return put(SetFan{(step.choice % 256) / 255.0});
            case 6:
                return set_limits(step);
            case 7:
                return layer(step);
            case 8:
                return move_filament(step);
            case 9:
            case 10:
            case 11:
            case 12:
                return travel(step);
            default:
                return extrude(step);
        }
    }
    std::vector<Command> commands;

  private:
    template <class What>
    void put(const What& what) {
        commands.push_back({what, 0});
    }

    Position place() const {
        Position at{};
        for (std::size_t axis = 0; axis < 3; ++axis) at[axis] = double(counts_[axis]) / 1e3;
        at[axis_e] = double(counts_[axis_e]) / 1e5;
        return at;
    }
    void put_move(Role role, const Bead& bead, int choice) {
        Move move;
        move.to = place();
        move.feed = (1 + choice) * 0.25;
        move.role = role;
        move.bead = bead;
        put(move);
    }
    void travel(const StreamStep& step) {
        counts_[axis_x] += step.x;
        counts_[axis_y] += step.y == 0 ? 1 : step.y;
        counts_[axis_z] += step.z;
        put_move(Role::travel, {}, step.choice);
    }
    void extrude(const StreamStep& step) {
        counts_[axis_x] += step.x == 0 ? 1 : step.x;
        counts_[axis_y] += step.y;
        if (step.kind == 13) counts_[axis_z] += step.z;
        counts_[axis_e] += step.e;
        const Bead bead{.width = 0.3 + step.choice % 7 * 0.05,
                        .height = 0.1 + step.choice % 3 * 0.05};
        put_move(Role(1 + step.choice % (int(role_names.size()) - 1)), bead, step.choice);
    }
    void move_filament(const StreamStep& step) {
        counts_[axis_e] += step.x > 0 ? step.e : -step.e;
        put_move(Role::travel, {}, step.choice);
    }
    void set_position(const StreamStep& step) {
        const std::array<int, 4> values{step.x, step.y, step.z, step.e};
        SetPosition position;
        for (std::size_t axis = 0; axis < axis_count; ++axis) {
            if ((1 + step.choice % 15) >> axis & 1) {
                counts_[axis] = values[axis];
                position.to[axis] = place()[axis];
            }
        }
        put(position);
    }
    void home(const StreamStep& step) {
        Home home;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            home.axes[axis] = (1 + step.choice % 7) >> axis & 1;
            if (home.axes[axis]) counts_[axis] = 0;
        }
        put(home);
    }
    void set_limits(const StreamStep& step) {
        SetLimits limits;
        const double value = 1 + step.choice;
        const PerAxis<std::optional<double>> some{value, {}, 2 * value, 0.125 * value};
        switch (step.choice % 4) {
            case 0:
                limits.max_acceleration = some;
                break;
            case 1:
                limits.max_feedrate = some;
                break;
            case 2:
                limits.jerk = some;
                break;
            default:
                limits.acceleration = value;
                limits.travel_acceleration = 2 * value;
        }
        put(limits);
    }
    void layer(const StreamStep& step) {
        counts_[axis_z] = 200 * (1 + step.choice);
        put(LayerStart{.z = place()[axis_z], .height = 0.05 * (step.choice % 5)});
        step.choice % 2 == 0 ? travel(StreamStep{}) : extrude(step);
    }

    std::array<std::int64_t, axis_count> counts_{};  // 0.001 mm; of E 0.00001 mm
};

inline std::vector<Command> stream_of(const std::vector<StreamStep>& steps) {
    StreamBuilder builder;
    for (const StreamStep& step : steps) builder.add(step);
    builder.add({.kind = 20, .x = 1000, .e = 100});
    return builder.commands;
}

inline rc::Gen<std::vector<StreamStep>> stream_plans() {
    return rc::gen::container<std::vector<StreamStep>>(stream_steps());
}

}  // namespace bead
