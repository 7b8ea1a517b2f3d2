#include "job/outline_svg.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <optional>
#include <pugixml.hpp>
#include <set>

#include "core/error.h"
#include "geom/clip.h"
#include "job/case_checks.h"
#include "job/one_line.h"
#include "job/svg_path.h"

namespace bead {
namespace {

double leading_number(std::string_view text, double fallback) {
    double value = fallback;
    text = trimmed(text);
    std::from_chars(text.data(), text.data() + text.size(), value);
    return std::isfinite(value) ? value : fallback;
}

// One of the drawing's lengths in mm; nothing without a unit.
std::optional<double> millimetres(std::string_view text) {
    const double value = leading_number(text, 0);
    for (const auto& [unit, size] :
         {std::pair{"mm", 1.0}, {"cm", 10.0}, {"in", 25.4}, {"pt", 25.4 / 72}, {"pc", 25.4 / 6}})
        if (text.ends_with(unit) && value > 0) return value * size;
    return std::nullopt;
}

Polyline ellipse(Vec2 centre, double a, double b) {
    Polyline loop;
    constexpr int count = 180;
    for (int i = 0; i < count; ++i) {
        const Vec2 u = unit(2 * pi * i / count);
        loop.push_back({centre.x + a * u.x, centre.y + b * u.y});
    }
    return loop;
}

bool is_hidden(const pugi::xml_node& node) {
    const std::string_view style = node.attribute("style").value();
    return std::string_view(node.attribute("display").value()) == "none" ||
           style.find("display:none") != style.npos || style.find("display: none") != style.npos;
}

// A loop whose area by even and odd is not that within it goes across itself somewhere.
void expect_simple(const Polyline& loop, const std::string& name) {
    const double within = std::abs(signed_area(loop));
    const double by_parity = area(region_of({loop}, FillRule::even_odd));
    if (std::abs(within - by_parity) <= 1e-3 * std::max(within, by_parity)) return;
    const Vec2 place = self_crossing(loop).value_or(bounds(loop).centre());
    throw Error(
        fmt::format("{}: a shape crosses itself at ({:.4g}, {:.4g}) mm; draw it as one "
                    "simple outline, holes as shapes of their own",
                    name, place.x, place.y));
}

class Drawing {
  public:
    explicit Drawing(std::string name) : name_(std::move(name)) {}

    std::vector<Polyline> loops;

    void read(const pugi::xml_node& node, const SvgTransform& outer) {
        const SvgTransform inner =
            outer * svg_transform(node.attribute("transform").value(), name_);
        const std::string_view kind = node.name();
        static const std::set<std::string_view> unseen{"defs",     "clipPath", "mask",  "symbol",
                                                       "metadata", "style",    "title", "desc"};
        if (unseen.contains(kind) || is_hidden(node)) return;
        for (Polyline& loop : shapes(node, kind)) {
            for (Vec2& p : loop) p = inner(p);
            if (loop.size() > 2) loops.push_back(std::move(loop));
        }
        for (const pugi::xml_node child : node.children()) read(child, inner);
    }

  private:
    static double number(const pugi::xml_node& node, const char* key) {
        return leading_number(node.attribute(key).value(), 0);
    }
    [[nodiscard]] std::vector<Polyline> shapes(const pugi::xml_node& node,
                                               std::string_view kind) const {
        if (kind == "path") return svg_path(node.attribute("d").value(), name_);
        if (kind == "polygon") return {svg_points(node.attribute("points").value(), name_)};
        if (kind == "circle")
            return {ellipse({number(node, "cx"), number(node, "cy")}, number(node, "r"),
                            number(node, "r"))};
        if (kind == "ellipse")
            return {ellipse({number(node, "cx"), number(node, "cy")}, number(node, "rx"),
                            number(node, "ry"))};
        if (kind != "rect") return {};
        const double x = number(node, "x"), y = number(node, "y");
        const double w = number(node, "width"), h = number(node, "height");
        return {{{x, y}, {x + w, y}, {x + w, y + h}, {x, y + h}}};
    }

    std::string name_;
};

}  // namespace

Region outline_of_svg(std::string_view text, const std::string& name) {
    pugi::xml_document document;
    const pugi::xml_parse_result parsed = document.load_buffer(text.data(), text.size());
    const pugi::xml_node svg = document.child("svg");
    if (!parsed || !svg) throw Error(name + ": is no SVG drawing; save it as plain SVG");
    Drawing drawing(name);
    drawing.read(svg, {});
    if (drawing.loops.empty())
        throw Error(name + ": has no closed shape; draw the outline as a path, polygon or rect");
    const std::vector<double> box = svg_numbers(svg.attribute("viewBox").value(), name);
    const std::optional<double> width = millimetres(svg.attribute("width").value());
    const double scale = width && box.size() == 4 && box[2] > 0 ? *width / box[2] : 1;
    const double top =
        box.size() == 4 ? box[1] + box[3] : leading_number(svg.attribute("height").value(), 0);
    for (Polyline& loop : drawing.loops)
        for (Vec2& p : loop) {
            p = scale * Vec2{p.x - (box.size() == 4 ? box[0] : 0), top - p.y};
            if (!(std::abs(p.x) < 1e5 && std::abs(p.y) < 1e5))
                throw Error(name + ": reaches beyond 100 m; is its unit right?");
        }
    for (const Polyline& loop : drawing.loops) expect_simple(loop, name);
    return region_of(drawing.loops, FillRule::even_odd);
}

}  // namespace bead
