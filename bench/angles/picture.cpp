#include "picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "scene/svg.h"

namespace bead::angles {
namespace {

constexpr double width = 330, height = 200, left = 56, top = 40, gap = 64, below = 66;  // px
constexpr std::size_t columns = 2;
constexpr std::array inks{"#b5702f", "#e0b07a", "#86351d", "#2c5a85", "#7fb0dd", "#3f746c"};

std::vector<double> above_least(const std::vector<double>& values) {
    const double least = std::ranges::min(values);
    std::vector<double> percent(values);
    for (double& value : percent) value = 100 * (value / least - 1);
    return percent;
}

double highest(const Panel& panel) {
    double most = 1;
    for (const Curve& curve : panel.curves)
        most = std::max(most, std::ranges::max(above_least(curve.values)));
    return most;
}

struct Corner {
    double x = 0, y = 0;
};

// The place of cell k when they are put in rows of `across`.
Corner cell(std::size_t k, std::size_t across, double wide, double high) {
    const std::size_t row = k / across, column = k % across;
    return {wide * static_cast<double>(column), high * static_cast<double>(row)};
}

std::string grid(Corner at, double most, double step) {
    std::string out;
    for (double percent = 0; percent <= most; percent += step) {
        const double y = at.y + height * (1 - percent / most);
        out += fmt::format("<path d=\"M{} {}h{}\" stroke=\"#ddd\"/>", decimal(at.x), decimal(y),
                           decimal(width));
        out += fmt::format("<text x=\"{}\" y=\"{}\" text-anchor=\"end\">{} %</text>\n",
                           decimal(at.x - 6), decimal(y + 4), decimal(percent));
    }
    for (int degrees = 0; degrees <= 90; degrees += 15)
        out +=
            fmt::format("<text x=\"{}\" y=\"{}\" text-anchor=\"middle\">{}°</text>\n",
                        decimal(at.x + width * degrees / 90), decimal(at.y + height + 18), degrees);
    return out;
}

std::string drawn(const Panel& panel, Corner at) {
    const double raw = highest(panel) / 5;
    const double decade = std::pow(10, std::floor(std::log10(raw)));
    const double step = decade * (raw > 5 * decade ? 10 : raw > 2 * decade ? 5 : 2);
    const double most = step * std::ceil(highest(panel) / step);
    std::string out = grid(at, most, step);
    out += fmt::format("<text x=\"{}\" y=\"{}\" text-anchor=\"middle\">{}</text>\n",
                       decimal(at.x + width / 2), decimal(at.y - 14), escaped(panel.title));
    for (std::size_t k = 0; k < panel.curves.size(); ++k) {
        const std::vector<double> values = above_least(panel.curves[k].values);
        std::string points;
        for (std::size_t i = 0; i < values.size(); ++i)
            points += fmt::format("{},{} ",
                                  decimal(at.x + width * static_cast<double>(i) /
                                                     static_cast<double>(values.size() - 1)),
                                  decimal(at.y + height * (1 - values[i] / most)));
        out += fmt::format(
            "<polyline fill=\"none\" stroke=\"{}\" stroke-width=\"2\" points=\"{}\"/>\n",
            inks[k % inks.size()], points);
    }
    return out;
}

std::string key(const std::vector<Curve>& curves, double bottom) {
    std::string out;
    for (std::size_t k = 0; k < curves.size(); ++k) {
        const Corner at = cell(k, 3, 250, 20);
        const double x = left + at.x, y = bottom + at.y;
        out += fmt::format(
            "<path d=\"M{} {}h24\" stroke=\"{}\" stroke-width=\"3\"/><text x=\"{}\" y=\"{}\">{}"
            "</text>\n",
            decimal(x), decimal(y - 4), inks[k % inks.size()], decimal(x + 30), decimal(y),
            escaped(curves[k].name));
    }
    return out;
}

}  // namespace

std::string picture(const std::vector<Panel>& panels) {
    const double whole = left + columns * width + (columns - 1) * gap + 24;
    const double bottom = cell(panels.size() + columns - 1, columns, 0, height + below).y + 32;
    std::string out = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {} {}\" "
        "font-family=\"sans-serif\" "
        "font-size=\"13\">\n<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n",
        decimal(whole), decimal(bottom + 36));
    for (std::size_t i = 0; i < panels.size(); ++i) {
        const Corner at = cell(i, columns, width + gap, height + below);
        out += drawn(panels[i], {left + at.x, top + at.y});
    }
    return out + key(panels.front().curves, bottom) + "</svg>\n";
}

}  // namespace bead::angles
