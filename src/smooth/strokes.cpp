#include "smooth/strokes.h"

#include <algorithm>
#include <utility>

#include "core/expects.h"
#include "smooth/same_place.h"

namespace bead {
namespace {

bool same(Vec3 a, Vec3 b) { return length(a - b) <= same_place; }

void append(std::vector<Vec3>& points, const std::vector<Vec3>& more) {
    const bool meets = !points.empty() && !more.empty() && same(points.back(), more.front());
    points.insert(points.end(), more.begin() + (meets ? 1 : 0), more.end());
}

// As it was if it still leads from here to there; straight otherwise.
Path leading(Path travel, Vec3 from, Vec3 to) {
    if (travel.points.size() > 1 && same(travel.points.front(), from) &&
        same(travel.points.back(), to))
        return travel;
    travel.points.clear();
    if (!same(from, to)) travel.points = {from, to};
    return travel;
}

const Path* first_travel(const Strokes& strokes) {
    for (const Stroke& stroke : strokes.strokes)
        if (!stroke.travel.points.empty()) return &stroke.travel;
    return nullptr;
}

}  // namespace

Strokes strokes_of(const Toolpath& layer) {
    Strokes result;
    const auto first =
        std::ranges::find_if(layer, [](const Path& path) { return !path.points.empty(); });
    if (first != layer.end()) result.start = first->points.front();
    Path travel;
    for (const Path& path : layer) {
        if (path.points.empty()) continue;
        if (path.role != Role::travel) {
            result.strokes.push_back({path, std::exchange(travel, {})});
        } else if (travel.points.empty()) {
            travel = path;
        } else {
            travel.retracted = travel.retracted || path.retracted;
            append(travel.points, path.points);
        }
    }
    result.leaving = std::move(travel);
    return result;
}

Toolpath joined(Strokes strokes) {
    Toolpath layer;
    const Path* usual = first_travel(strokes);
    const Path pattern = usual != nullptr ? *usual : strokes.leaving;
    Vec3 here = strokes.start;
    for (Stroke& stroke : strokes.strokes) {
        if (stroke.travel.points.empty()) stroke.travel = pattern;
        Path travel = leading(std::move(stroke.travel), here, stroke.path.points.front());
        here = stroke.path.points.back();
        if (!travel.points.empty()) layer.push_back(std::move(travel));
        layer.push_back(std::move(stroke.path));
    }
    if (!strokes.leaving.points.empty()) {
        const Vec3 end = strokes.leaving.points.back();
        Path last = leading(std::move(strokes.leaving), here, end);
        if (!last.points.empty()) layer.push_back(std::move(last));
    }
    return layer;
}

bool is_loop(const Path& path) {
    return path.role != Role::travel && path.points.size() > 3 &&
           same(path.points.front(), path.points.back());
}

Polyline loop_of(const Path& path) {
    Polyline loop;
    for (std::size_t i = 0; i + 1 < path.points.size(); ++i) loop.push_back(flat(path.points[i]));
    return loop;
}

Path along_loop(const Path& like, const Polyline& loop) {
    BEAD_EXPECTS(!loop.empty() && !like.points.empty());
    const Vec3 start = like.points.front();
    const auto nearest = std::ranges::min_element(
        loop, {}, [&](Vec2 corner) { return distance(corner, flat(start)); });
    Path path = like;
    path.points.clear();
    for (auto it = nearest; it != loop.end(); ++it) path.points.push_back(at_height(*it, start.z));
    for (auto it = loop.begin(); it != nearest; ++it)
        path.points.push_back(at_height(*it, start.z));
    path.points.push_back(path.points.front());
    return path;
}

double width_for(double section, double height) {
    const double half_discs = pi / 4 * height * height;
    if (section < half_discs) return section / (pi / 4 * height);
    return (section - half_discs) / height + height;
}

}  // namespace bead
