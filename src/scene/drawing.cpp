#include "scene/drawing.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "scene/looks.h"
#include "scene/svg.h"

namespace bead {
namespace {

constexpr double unknown_width = 0.4;  // mm, where a file does not tell the bead's width
constexpr double rim = 0.16;           // of a bead's width, both sides together
constexpr double travel_width = 0.9;   // px

double drawn_width(const Path& path) {
    return path.bead.width > 0 ? path.bead.width : unknown_width;
}

Box2 extent_of(const Toolpath& layer, bool travel) {
    Box2 box;
    for (const Path& path : layer) {
        if (!is_drawn(path) || (path.role == Role::travel) != travel) continue;
        const double half = travel ? 0 : drawn_width(path) / 2;
        for (const Vec3& point : path.points) {
            box.include(flat(point) - Vec2{half, half});
            box.include(flat(point) + Vec2{half, half});
        }
    }
    return box;
}

// All strokes of one role, by their width in hundredths of a millimetre.
std::map<long, std::string> strokes_of(const Toolpath& layer, Role role) {
    std::map<long, std::string> strokes;
    for (const Path& path : layer)
        if (path.role == role && is_drawn(path))
            strokes[std::lround(100 * drawn_width(path))] += stroke_data(path.points);
    return strokes;
}

// Drawn twice, rim and body, from one copy of the points.
std::string beads(const std::string& data, double width, const Look& look) {
    const std::string name = content_name(data);
    return fmt::format(
        "<defs><path id=\"{0}\" d=\"{1}\"/></defs>\n"
        "<use href=\"#{0}\" stroke=\"{2}\" stroke-width=\"{3}\"/>\n"
        "<use href=\"#{0}\" stroke=\"{4}\" stroke-width=\"{5}\"/>\n",
        name, data, look.edge, decimal(width), look.body, decimal(width * (1 - rim)));
}

std::string travel_lines(const std::string& data, double scale) {
    const auto px = [scale](double length) { return decimal(length / scale); };
    return fmt::format(
        "<path d=\"{}\" stroke=\"{}\" stroke-width=\"{}\" stroke-dasharray=\"{} {}\" "
        "stroke-linecap=\"butt\"/>\n",
        data, travel_ink, px(travel_width), px(4), px(3));
}

}  // namespace

bool is_drawn(const Path& path) {
    return std::ranges::any_of(path.points,
                               [&](const Vec3& point) { return point != path.points.front(); });
}

Box2 extent(const Toolpath& layer) {
    const Box2 printed = extent_of(layer, false);
    if (!printed.is_empty()) return printed;
    const Box2 travelled = extent_of(layer, true);
    return travelled.is_empty() ? Box2{{-5, -5}, {5, 5}} : travelled;
}

std::string drawing(const Toolpath& layer, const Frame& frame, double scale) {
    const Vec2 size{frame.width / scale, frame.height / scale};
    const Vec2 middle = extent(layer).centre();
    std::string svg = fmt::format(
        "<svg x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" viewBox=\"{} {} {} {}\" fill=\"none\" "
        "stroke-linecap=\"round\" stroke-linejoin=\"round\">\n",
        decimal(frame.left), decimal(frame.top), decimal(frame.width), decimal(frame.height),
        decimal(middle.x - size.x / 2), decimal(-middle.y - size.y / 2), decimal(size.x),
        decimal(size.y));
    for (const Look& look : looks) {
        if (look.role == Role::travel) continue;
        for (const auto& [hundredths, data] : strokes_of(layer, look.role))
            svg += beads(data, double(hundredths) / 100, look);
    }
    for (const auto& [any_width, data] : strokes_of(layer, Role::travel))
        svg += travel_lines(data, scale);
    return svg + "</svg>\n";
}

}  // namespace bead
