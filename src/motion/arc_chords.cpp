#include "motion/arc_chords.h"

#include <algorithm>
#include <cmath>

#include "geom/vec.h"

namespace bead {
namespace {

constexpr double turn = 2 * pi;
constexpr double shortest_arc = 1e-3;  // mm
constexpr double most_chords = 1e6;    // of one arc; no real one has as many

struct Axes {
    Axis p, q, along;  // the circle is in p and q
};

Axes axes_of(Plane plane) {
    if (plane == Plane::zx) return {axis_z, axis_x, axis_y};
    if (plane == Plane::yz) return {axis_y, axis_z, axis_x};
    return {axis_x, axis_y, axis_z};
}

// Angle from the start to the end, counter-clockwise positive; a whole turn if they are the same.
double angle_of(const Arc& arc, const Position& from, const Axes& axes, Vec2 start) {
    const Vec2 end{arc.end.to[axes.p] - arc.centre[0], arc.end.to[axes.q] - arc.centre[1]};
    double angle = std::atan2(start.x * end.y - start.y * end.x, start.x * end.x + start.y * end.y);
    if (angle < 0) angle += turn;
    if (arc.clockwise) angle -= turn;
    const bool closed = from[axes.p] == arc.end.to[axes.p] && from[axes.q] == arc.end.to[axes.q];
    if (angle == 0 && closed) angle = turn;
    return angle;
}

double marlin_chords(double flat, double angle, double longest) {
    constexpr double per_circle = 72, shortest = 0.1;
    const double least = std::max(1.0, std::ceil(per_circle * std::abs(angle) / turn));
    const double count = std::max(std::floor(flat / longest), least);
    if (flat / count > longest) return std::ceil(flat / longest);
    return flat / count < shortest ? std::max(1.0, std::floor(flat / shortest)) : count;
}

double chord_count(const ArcRule& rule, double radius, double angle, double rise) {
    const double flat = radius * std::abs(angle), way = std::hypot(flat, rise);
    if (way < shortest_arc) return 0;
    if (rule.style == ArcStyle::marlin) return marlin_chords(flat, angle, rule.resolution);
    if (rule.style == ArcStyle::prusa)
        return std::ceil(way / std::clamp(turn * radius / 20, 0.5, std::max(0.5, rule.resolution)));
    return std::max(1.0, std::floor(way / rule.resolution));
}

// Chords from one point to the next, turned step by step as the firmware turns them.
class Turning {
  public:
    Turning(ArcStyle style, Vec2 start, double angle) : start_(start), at_(start), step_(angle) {
        cos_ = 1 - angle * angle / 2;
        sin_ = style == ArcStyle::prusa_2017 ? angle : angle - angle * angle * angle / 6;
        exact_every_ = style == ArcStyle::klipper ? 1 : style == ArcStyle::marlin ? 25 : 26;
    }

    Vec2 next() {
        if (++count_ % exact_every_ != 0) {
            at_ = {at_.x * cos_ - at_.y * sin_, at_.x * sin_ + at_.y * cos_};
            return at_;
        }
        const double c = std::cos(double(count_) * step_), s = std::sin(double(count_) * step_);
        at_ = {start_.x * c - start_.y * s, start_.x * s + start_.y * c};
        return at_;
    }

  private:
    Vec2 start_, at_;
    double step_, cos_, sin_;
    std::int64_t count_ = 0, exact_every_;
};

void one_arc(const Arc& arc, const Position& from, const ArcRule& rule,
             const std::function<void(const Move&)>& tell) {
    const Axes axes = axes_of(arc.plane);
    const Vec2 start{from[axes.p] - arc.centre[0], from[axes.q] - arc.centre[1]};
    const double angle = angle_of(arc, from, axes, start);
    const double rise = arc.end.to[axes.along] - from[axes.along];
    const auto count = static_cast<std::int64_t>(
        std::min(most_chords, chord_count(rule, length(start), angle, rise)));
    if (count == 0) return;
    const double part = 1.0 / double(count);
    Turning turning(rule.style, start, angle * part);
    Move chord = arc.end;
    for (std::int64_t i = 1; i < count; ++i) {
        const Vec2 at = turning.next();
        chord.to[axes.p] = arc.centre[0] + at.x;
        chord.to[axes.q] = arc.centre[1] + at.y;
        for (const Axis axis : {axes.along, axis_e})
            chord.to[axis] = from[axis] + (arc.end.to[axis] - from[axis]) * (double(i) * part);
        tell(chord);
    }
    tell(arc.end);
}

}  // namespace

void each_chord(const Arc& arc, const Position& from, const ArcRule& rule,
                const std::function<void(const Move&)>& tell) {
    const Axes axes = axes_of(arc.plane);
    Position at = from;
    if (arc.more_turns > 0) {
        const Vec2 start{from[axes.p] - arc.centre[0], from[axes.q] - arc.centre[1]};
        const double angle = angle_of(arc, from, axes, start);
        const double whole = std::copysign(turn, arc.clockwise ? -1.0 : 1.0);
        const double share = whole / (angle + whole * arc.more_turns);
        for (int i = 0; i < arc.more_turns; ++i) {
            Arc circle = arc;
            circle.end.to = at;
            for (const Axis axis : {axes.along, axis_e})
                circle.end.to[axis] = at[axis] + (arc.end.to[axis] - from[axis]) * share;
            one_arc(circle, at, rule, tell);
            at = circle.end.to;
        }
    }
    one_arc(arc, at, rule, tell);
}

}  // namespace bead
