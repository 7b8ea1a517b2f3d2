#include "scene/layout_picture.h"

#include <fmt/format.h>

#include <algorithm>

#include "scene/svg.h"

namespace bead {
namespace {

// Pixels.
constexpr double layout_width = 1200, layout_margin = 28, layout_title = 40, layout_caption = 28,
                 key_height = 44;
constexpr double tallest = 1000;
constexpr double layout_rim = 0.15;  // of the bead's width, left between beads that touch

struct LayoutPage {
    Box2 box;
    double scale = 1;
    [[nodiscard]] double bottom() const {
        return layout_margin + layout_title + scale * box.size().y;
    }
    // SVG counts y downwards.
    [[nodiscard]] std::string frame() const {
        return fmt::format("translate({} {}) scale({})", decimal(layout_margin - scale * box.low.x),
                           decimal(bottom() + scale * box.low.y), decimal(scale));
    }
};

std::string stroke(const Polyline& line) {
    std::vector<Vec3> points;
    for (const Vec2 p : line) points.push_back(at_height(p, 0));
    return stroke_data(points);
}

std::string outline(const Region& part) {
    std::string data;
    for (const Polygon& polygon : part) {
        data += stroke(polygon.outer) + "z";
        for (const Polyline& hole : polygon.holes) data += stroke(hole) + "z";
    }
    return fmt::format("<path d=\"{}\" fill=\"#f4f1ea\" fill-rule=\"evenodd\" stroke=\"none\"/>\n",
                       data);
}

std::string beads(const PicturedLines& group, double width) {
    std::string data;
    for (const Polyline& line : group.lines) data += stroke(line);
    if (data.empty()) return "";
    return fmt::format(
        "<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"{}\" stroke-linecap=\"round\" "
        "stroke-linejoin=\"round\"/>\n",
        data, group.ink, decimal((1 - layout_rim) * width));
}

std::string words(double x, double y, int size, std::string_view text) {
    return fmt::format("<text x=\"{}\" y=\"{}\" font-size=\"{}\" fill=\"#1f2933\">{}</text>\n",
                       decimal(x), decimal(y), size, escaped(text));
}

std::string key(const std::vector<PicturedLines>& groups, double y) {
    constexpr double letter = 7.5, gap = 56;
    std::string svg;
    double x = layout_margin;
    for (const PicturedLines& group : groups) {
        if (group.lines.empty()) continue;
        svg += fmt::format(
            "<path d=\"M{} {}h22\" stroke=\"{}\" stroke-width=\"6\" "
            "stroke-linecap=\"round\"/>\n",
            decimal(x), decimal(y - 5), group.ink);
        svg += words(x + 30, y, 14, group.name);
        x += gap + letter * static_cast<double>(group.name.size());
    }
    return svg;
}

}  // namespace

std::string layout_picture(const LayoutPicture& picture) {
    LayoutPage page{bounds(picture.part), 1};
    const Vec2 size = page.box.size();
    page.scale = std::min((layout_width - 2 * layout_margin) / size.x, tallest / size.y);
    const double below = page.bottom();
    const double height = below + layout_caption + key_height;
    std::string svg = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" "
        "height=\"{1}\" font-family=\"sans-serif\">\n<rect width=\"{0}\" height=\"{1}\" "
        "fill=\"#ffffff\"/>\n",
        decimal(layout_width), decimal(height));
    svg += words(layout_margin, layout_margin + 8, 18, picture.title);
    svg += fmt::format("<g transform=\"{}\">\n", page.frame());
    svg += outline(picture.part);
    for (const PicturedLines& group : picture.groups) svg += beads(group, picture.bead_width);
    svg += "</g>\n";
    svg += words(layout_margin, below + 22, 14, picture.caption);
    svg += key(picture.groups, below + layout_caption + 22);
    return svg + "</svg>\n";
}

}  // namespace bead
