#include "stress_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "fem/plane_solver.h"
#include "scene/svg.h"

namespace bead::cli {
namespace {

constexpr double page = 900;    // px, width of the part
constexpr double margin = 30;   // px
constexpr double foot = 70;     // px, below, for the key
constexpr double crosses = 40;  // along the longer side
constexpr int shades = 12;      // of each colour

struct Page {
    Box2 box;
    double scale = 1;
    [[nodiscard]] std::string at(Vec2 p) const {
        return decimal(margin + scale * (p.x - box.low.x)) + "," +
               decimal(margin + scale * (box.high.y - p.y));
    }
};

// Larger than what 98 of 100 nodes have: the few at singular points would bleach the rest.
double scale_of(const std::vector<PlaneTensor>& stress) {
    std::vector<double> sizes;
    for (const PlaneTensor& t : stress) {
        const Principal p = principal(t);
        sizes.push_back(std::max(std::abs(p.first), std::abs(p.second)));
    }
    const auto place = sizes.begin() + std::ptrdiff_t(0.98 * double(sizes.size() - 1));
    std::nth_element(sizes.begin(), place, sizes.end());
    return *place > 0 ? *place : 1;
}

// From -shades (compression) to shades (tension), by the principal stress that is larger.
int shade(PlaneTensor t, double scale) {
    const Principal p = principal(t);
    const double value = std::abs(p.first) >= std::abs(p.second) ? p.first : p.second;
    return std::clamp(int(std::lround(value / scale * shades)), -shades, shades);
}

std::string colour(int shade) {
    const double t = std::abs(shade) / double(shades);
    constexpr int white[] = {246, 244, 240}, red[] = {176, 42, 32}, blue[] = {24, 78, 140};
    const int(&full)[3] = shade >= 0 ? red : blue;
    const auto mix = [&](int k) { return int(std::lround(white[k] + t * (full[k] - white[k]))); };
    return fmt::format("#{:02x}{:02x}{:02x}", mix(0), mix(1), mix(2));
}

// Elements of one shade are one path.
std::string elements(const Sheet& sheet, const Page& page_of, double scale) {
    std::vector<std::string> paths(2 * shades + 1);
    const auto corners = std::size_t(corners_of(sheet.mesh.kind));
    for (std::size_t e = 0; e < sheet.mesh.count(); ++e) {
        const std::span<const int> nodes = sheet.mesh.element(e);
        PlaneTensor mean;
        for (const int node : nodes.first(corners))
            mean = mean + 1.0 / double(corners) * sheet.answers[0].stress[std::size_t(node)];
        const int at = shade(mean, scale) + shades;
        std::string& path = paths[std::size_t(at)];
        char stroke = 'M';
        for (const int node : nodes.first(corners)) {
            path.push_back(stroke);
            path.append(page_of.at(sheet.mesh.nodes[std::size_t(node)]));
            stroke = 'L';
        }
        path.push_back('Z');
    }
    std::string text;
    for (int k = -shades; k <= shades; ++k) {
        const int at = k + shades;
        const std::string& path = paths[std::size_t(at)];
        if (!path.empty())
            text +=
                fmt::format("<path fill=\"{0}\" stroke=\"{0}\" stroke-width=\"0.4\" d=\"{1}\"/>\n",
                            colour(k), path);
    }
    return text;
}

std::string directions(const LoadCase& load_case, const Sheet& sheet, const Page& page_of,
                       double scale) {
    const Vec2 size = page_of.box.size();
    const double step = std::max(size.x, size.y) / crosses;
    std::string tension, compression;
    for (double y = page_of.box.low.y + step / 2; y < page_of.box.high.y; y += step)
        for (double x = page_of.box.low.x + step / 2; x < page_of.box.high.x; x += step) {
            const Vec2 p{x, y};
            if (!contains(load_case.part, p)) continue;
            const auto place = locate(sheet.mesh, p);
            if (!place) continue;
            const Principal s = principal(stress_at(sheet.mesh, sheet.answers[0].stress, *place));
            const auto draw = [&](double value, Vec2 direction) {
                const Vec2 half =
                    0.48 * step * std::sqrt(std::min(1.0, std::abs(value) / scale)) * direction;
                std::string& lines = value >= 0 ? tension : compression;
                lines.append("M").append(page_of.at(p - half));
                lines.append("L").append(page_of.at(p + half));
            };
            draw(s.first, unit(s.angle));
            draw(s.second, left_of(unit(s.angle)));
        }
    return fmt::format(
        "<path fill=\"none\" stroke=\"#5a0f08\" stroke-width=\"1.1\" d=\"{}\"/>\n"
        "<path fill=\"none\" stroke=\"#08244a\" stroke-width=\"1.1\" d=\"{}\"/>\n",
        tension, compression);
}

std::string outline(const LoadCase& load_case, const Page& page_of) {
    std::string path;
    const auto add = [&](const Polyline& loop) {
        for (std::size_t i = 0; i < loop.size(); ++i) {
            path.push_back(i == 0 ? 'M' : 'L');
            path.append(page_of.at(loop[i]));
        }
        path.push_back('Z');
    };
    for (const Polygon& polygon : load_case.part) {
        add(polygon.outer);
        std::ranges::for_each(polygon.holes, add);
    }
    return fmt::format("<path fill=\"none\" stroke=\"#222\" stroke-width=\"1.2\" d=\"{}\"/>\n",
                       path);
}

std::string key(double top, double scale) {
    std::string text;
    for (int k = -shades; k <= shades; ++k)
        text += fmt::format("<rect x=\"{}\" y=\"{}\" width=\"12\" height=\"12\" fill=\"{}\"/>\n",
                            decimal(margin + 12 * (k + shades)), decimal(top), colour(k));
    const double right = margin + 12 * (2 * shades + 1);
    return text + fmt::format(
                      "<text x=\"{}\" y=\"{}\">compression {:.3g} MPa</text>\n"
                      "<text x=\"{}\" y=\"{}\" text-anchor=\"end\">tension {:.3g} MPa</text>\n",
                      decimal(margin), decimal(top + 27), scale, decimal(right), decimal(top + 27),
                      scale);
}

}  // namespace

std::string stress_picture(const LoadCase& load_case, const Sheet& sheet) {
    Page on;
    on.box = bounds(load_case.part);
    const Vec2 size = on.box.size();
    on.scale = page / std::max(size.x, size.y);
    const double width = std::max(on.scale * size.x, 400.0) + 2 * margin;
    const double height = on.scale * size.y + 2 * margin + foot;
    const double scale = scale_of(sheet.answers[0].stress);
    return fmt::format(
               "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" "
               "width=\"{0}\" height=\"{1}\" font-family=\"sans-serif\" "
               "font-size=\"13\">\n<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n"
               "<text x=\"{2}\" y=\"20\" font-size=\"15\">{3}</text>\n",
               decimal(width), decimal(height), decimal(margin),
               escaped(load_case.title.empty() ? "Principal stresses" : load_case.title)) +
           elements(sheet, on, scale) + outline(load_case, on) +
           directions(load_case, sheet, on, scale) + key(on.scale * size.y + 2 * margin, scale) +
           "</svg>\n";
}

}  // namespace bead::cli
