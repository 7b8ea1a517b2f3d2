#include "study/asked_speeds.h"

#include <algorithm>
#include <cmath>

namespace bead {

void AskedSpeeds::add(const Command& command) {
    if (const Move* move = std::get_if<Move>(&command.what)) {
        take(*move);
    } else if (const Arc* arc = std::get_if<Arc>(&command.what)) {
        take(*arc);
    } else if (const SetPosition* position = std::get_if<SetPosition>(&command.what)) {
        for (std::size_t i = 0; i < place_.size(); ++i)
            place_[i] = position->to[i].value_or(place_[i]);
    } else if (const Home* home = std::get_if<Home>(&command.what)) {
        for (std::size_t i = 0; i < home->axes.size(); ++i)
            if (home->axes[i]) place_[i] = 0;
    }
}

// Squares are compared: no root and no division unless an axis is asked for more than ever before.
void AskedSpeeds::take(const Move& move) {
    PerAxis<double> way;
    for (std::size_t i = 0; i < way.size(); ++i) way[i] = move.to[i] - place_[i];
    place_ = move.to;
    const double head =
        way[axis_x] * way[axis_x] + way[axis_y] * way[axis_y] + way[axis_z] * way[axis_z];
    if (head > 0) path_ = std::max(path_, move.feed);
    const double length2 = head > 0 ? head : way[axis_e] * way[axis_e];
    if (length2 <= 0) return;
    const double feed2 = move.feed * move.feed;
    for (std::size_t i = 0; i < way.size(); ++i)
        if (way[i] * way[i] * feed2 > axes_[i] * axes_[i] * length2)
            axes_[i] = std::abs(way[i]) * move.feed / std::sqrt(length2);
}

// Somewhere along it both axes of its plane may have the whole speed; what a short arc does not
// reach is passed over.
void AskedSpeeds::take(const Arc& arc) {
    place_ = arc.end.to;
    path_ = std::max(path_, arc.end.feed);
    const bool x = arc.plane != Plane::yz, y = arc.plane != Plane::zx, z = arc.plane != Plane::xy;
    const PerAxis<bool> in_plane{x, y, z, false};
    for (std::size_t i = 0; i < in_plane.size(); ++i)
        if (in_plane[i]) axes_[i] = std::max(axes_[i], arc.end.feed);
}

}  // namespace bead
