#include "gcode/motion_text.h"

#include <cmath>

#include "gcode/arc_fit.h"
#include "gcode/fixed_point.h"

namespace bead {
namespace {

constexpr int place_decimals = 3, filament_decimals = 5, feed_decimals = 1;

double rounded(double value, int decimals) {
    const double one = double(power_of_ten(decimals));
    return std::round(value * one) / one;
}
Vec2 rounded(Vec2 place) {
    return {rounded(place.x, place_decimals), rounded(place.y, place_decimals)};
}
Vec2 flat(const Position& at) { return {at[axis_x], at[axis_y]}; }

}  // namespace

MotionText::MotionText(const MotionStyle& style, const MotionState& state)
    : style_(style), state_(state), exact_e_(state.at[axis_e]) {}

void MotionText::word(char letter, double value, int decimals) {
    text_ += ' ';
    text_ += letter;
    append_fixed(text_, fixed(value, decimals), decimals);
}
void MotionText::end_line() { text_ += '\n'; }

void MotionText::feed_word(double speed) {
    const double told = rounded(speed * 60, feed_decimals) / 60;
    if (told <= 0 || told == state_.feed) return;
    word('F', told * 60, feed_decimals);
    state_.feed = told;
}

bool MotionText::is_at(Vec2 place) const { return flat(state_.at) == rounded(place); }

void MotionText::go(Vec2 to, double speed) {
    if (is_at(to)) return;
    const Vec2 place = rounded(to);
    text_ += "G1";
    if (place.x != state_.at[axis_x]) word('X', place.x, place_decimals);
    if (place.y != state_.at[axis_y]) word('Y', place.y, place_decimals);
    state_.at[axis_x] = place.x;
    state_.at[axis_y] = place.y;
    feed_word(speed);
    end_line();
}

void MotionText::raise(double z) {
    const double to = rounded(z, place_decimals);
    if (to == state_.at[axis_z]) return;
    text_ += "G1";
    word('Z', to, place_decimals);
    state_.at[axis_z] = to;
    feed_word(style_.z_speed);
    end_line();
}

// Feeds to the place in the filament, counted as the layer's text does from its start.
void MotionText::set_e(double e) {
    const double to = rounded(e, filament_decimals);
    word('E', style_.absolute_e ? to : to - state_.at[axis_e], filament_decimals);
    state_.at[axis_e] = to;
}

void MotionText::pull_back(double to, double speed) {
    if (std::abs(to - state_.pulled_back) < 1e-6) return;
    if (style_.by_firmware) {
        text_ += to > state_.pulled_back ? "G10\n" : "G11\n";
    } else {
        exact_e_ -= to - state_.pulled_back;
        text_ += "G1";
        set_e(exact_e_);
        feed_word(speed);
        end_line();
    }
    state_.pulled_back = to;
}

void MotionText::travel(const Path& path) {
    const bool pulls = style_.retract_length > 0 && path.retracted;
    if (pulls && state_.pulled_back < style_.retract_length) {
        pull_back(style_.retract_length, style_.retract_speed);
        if (style_.lift > 0) raise(z_ + style_.lift);
    }
    if (state_.at[axis_z] < z_) raise(z_);
    for (const Vec3& point : path.points) go(bead::flat(point), path.speed);
}

void MotionText::name(const Path& path) {
    const std::string& line = style_.role_lines[std::size_t(path.role)];
    if (role_ != path.role) text_ += line;
    role_ = path.role;
    const auto tell = [&](const std::string& tag, double value, std::int64_t& last) {
        const std::int64_t told = fixed(value, place_decimals);
        if (tag.empty() || told == last) return;
        text_ += tag;
        append_fixed(text_, told, place_decimals);
        text_ += '\n';
        last = told;
    };
    tell(style_.width_tag, path.bead.width, width_);
    tell(style_.height_tag, path.bead.height, height_);
}

void MotionText::ask(double acceleration) {
    if (acceleration <= 0 || acceleration == state_.acceleration) return;
    const auto lines = style_.limits.find(acceleration);
    if (lines == style_.limits.end()) return;
    text_ += lines->second;
    state_.acceleration = acceleration;
}

void MotionText::print_line(Vec2 to, double filament, double speed) {
    exact_e_ += filament;
    fed_ += filament;
    if (is_at(to)) return;  // its filament goes with the next line
    const Vec2 place = rounded(to);
    text_ += "G1";
    if (place.x != state_.at[axis_x]) word('X', place.x, place_decimals);
    if (place.y != state_.at[axis_y]) word('Y', place.y, place_decimals);
    state_.at[axis_x] = place.x;
    state_.at[axis_y] = place.y;
    set_e(exact_e_);
    feed_word(speed);
    end_line();
}

void MotionText::print(const Path& path) {
    go(bead::flat(path.points.front()), path.speed);
    raise(z_);
    pull_back(0, style_.return_speed);
    ask(path.acceleration);
    name(path);
    const double per_mm = section(path.bead) / (pi / 4 * style_.filament * style_.filament);
    if (arc_tolerance_ > 0) return print_pieces(path, per_mm);
    for (std::size_t i = 1; i < path.points.size(); ++i)
        print_line(bead::flat(path.points[i]), length(path.points[i] - path.points[i - 1]) * per_mm,
                   path.speed);
}

// An arc gets the filament of the chords that it stands for.
void MotionText::print_pieces(const Path& path, double per_mm) {
    Polyline line;
    for (const Vec3& point : path.points)
        if (line.empty() || bead::flat(point) != line.back()) line.push_back(bead::flat(point));
    for (const FittedPiece& piece : fitted_pieces(line, arc_tolerance_)) {
        double way = 0;
        for (std::size_t i = piece.first; i < piece.last; ++i)
            way += distance(line[i], line[i + 1]);
        if (piece.is_arc)
            print_arc(line[piece.last], piece.centre, piece.clockwise, way * per_mm, path.speed);
        else
            print_line(line[piece.last], way * per_mm, path.speed);
    }
}

void MotionText::print_arc(Vec2 to, Vec2 centre, bool clockwise, double filament, double speed) {
    if (is_at(to)) return print_line(to, filament, speed);
    const Vec2 place = rounded(to);
    exact_e_ += filament;
    fed_ += filament;
    text_ += clockwise ? "G2" : "G3";
    word('X', place.x, place_decimals);
    word('Y', place.y, place_decimals);
    word('I', centre.x - state_.at[axis_x], place_decimals);
    word('J', centre.y - state_.at[axis_y], place_decimals);
    state_.at[axis_x] = place.x;
    state_.at[axis_y] = place.y;
    set_e(exact_e_);
    feed_word(speed);
    end_line();
}

void MotionText::follow(const Toolpath& layer, double z) {
    z_ = z;
    state_.feed = 0;  // said again in every layer
    if (style_.absolute_e) {
        text_ += "G92 E0\n";
        exact_e_ = state_.at[axis_e] = 0;
    } else {
        exact_e_ = state_.at[axis_e];
    }
    for (const Path& path : layer) {
        if (path.points.empty()) continue;
        if (path.role == Role::travel)
            travel(path);
        else
            print(path);
    }
}

void MotionText::restore(const MotionState& to) {
    const bool away = distance(flat(state_.at), flat(to.at)) > 0.0005;
    if (to.pulled_back > state_.pulled_back || (away && to.pulled_back > 0))
        pull_back(to.pulled_back, style_.retract_speed);
    const double speed = to.feed > 0 ? to.feed : state_.feed;
    if (to.at[axis_z] > state_.at[axis_z]) raise(to.at[axis_z]);
    if (away) go(flat(to.at), speed);
    raise(to.at[axis_z]);
    pull_back(to.pulled_back, style_.return_speed);
    ask(to.acceleration);
    if (style_.absolute_e) {
        text_ += "G92";
        word('E', to.at[axis_e], filament_decimals);
        end_line();
        state_.at[axis_e] = to.at[axis_e];
    }
    if (to.feed > 0 && std::abs(to.feed - state_.feed) > 1e-9) {
        text_ += "G1 F";
        append_fixed(text_, fixed(to.feed * 60, 3), 3);
        end_line();
        state_.feed = to.feed;
    }
    exact_e_ = state_.at[axis_e] = to.at[axis_e];
}

}  // namespace bead
