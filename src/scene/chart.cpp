#include "scene/chart.h"

#include <fmt/format.h>

#include <cmath>

#include "scene/svg.h"

namespace bead {
namespace {

constexpr double width = 600, height = 400, left = 70, top = 46;  // px, of the plot
constexpr double below = 56, key_line = 20;
constexpr int key_columns = 3;

double round_step(const ChartAxis& axis) {
    if (axis.step > 0) return axis.step;
    const double raw = (axis.to - axis.from) / 6;
    const double decade = std::pow(10, std::floor(std::log10(raw)));
    return decade * (raw > 5 * decade ? 10 : raw > 2 * decade ? 5 : raw > decade ? 2 : 1);
}

double part_of(const ChartAxis& axis, double value) {
    return (value - axis.from) / (axis.to - axis.from);
}

bool holds(const ChartAxis& axis, double value) {
    constexpr double slack = 1e-9;
    const double part = part_of(axis, value);
    return part >= -slack && part <= 1 + slack;
}

// On the page.
Vec2 place(const Chart& chart, Vec2 p) {
    return {left + width * part_of(chart.x, p.x), top + height * (1 - part_of(chart.y, p.y))};
}

std::string words(Vec2 at, std::string_view anchor, std::string_view text) {
    return fmt::format("<text x=\"{}\" y=\"{}\" text-anchor=\"{}\">{}</text>\n", decimal(at.x),
                       decimal(at.y), anchor, escaped(text));
}

// From one mark to the next, the first at a multiple of the step.
std::vector<double> marks(const ChartAxis& axis) {
    const double step = round_step(axis);
    std::vector<double> values;
    for (double k = std::ceil(axis.from / step - 1e-9); k * step <= axis.to + 1e-9 * step; ++k)
        values.push_back(k * step);
    return values;
}

std::string grid(const Chart& chart) {
    std::string out;
    for (const double y : marks(chart.y)) {
        const Vec2 at = place(chart, {chart.x.from, y});
        out += fmt::format("<path d=\"M{} {}h{}\" stroke=\"{}\"/>", decimal(at.x), decimal(at.y),
                           decimal(width), y == 0 ? "#888" : "#ddd");
        out += words({at.x - 8, at.y + 4}, "end", decimal(y));
    }
    for (const double x : marks(chart.x)) {
        const Vec2 at = place(chart, {x, chart.y.from});
        out += fmt::format("<path d=\"M{} {}v5\" stroke=\"#888\"/>", decimal(at.x), decimal(at.y));
        out += words({at.x, at.y + 20}, "middle", decimal(x));
    }
    out += fmt::format(
        "<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"none\" "
        "stroke=\"#888\"/>\n",
        decimal(left), decimal(top), decimal(width), decimal(height));
    out += words({left + width / 2, top + height + 42}, "middle", chart.x.name);
    out += fmt::format("<g transform=\"translate(16 {}) rotate(-90)\">{}</g>\n",
                       decimal(top + height / 2), words({}, "middle", chart.y.name));
    return out;
}

std::string mark(Vec2 at, const ChartSeries& series) {
    const bool full = series.mark == ChartMark::dots;
    return fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"3\" fill=\"{}\" stroke=\"{}\"/>\n",
                       decimal(at.x), decimal(at.y), full ? series.ink : "none", series.ink);
}

// Broken where it leaves the axes.
std::string curve(const Chart& chart, const ChartSeries& series) {
    std::string d;
    bool within = false;
    for (const Vec2 p : series.points) {
        const bool was_within = within;
        within = holds(chart.x, p.x) && holds(chart.y, p.y);
        if (!within) continue;
        const Vec2 at = place(chart, p);
        d += fmt::format("{}{} {}", was_within ? 'L' : 'M', decimal(at.x), decimal(at.y));
    }
    return fmt::format("<path fill=\"none\" stroke=\"{}\" stroke-width=\"2\" d=\"{}\"/>\n",
                       series.ink, d);
}

std::string drawn(const Chart& chart, const ChartSeries& series) {
    if (series.mark == ChartMark::curve) return curve(chart, series);
    std::string out;
    for (const Vec2 p : series.points)
        if (holds(chart.x, p.x) && holds(chart.y, p.y)) out += mark(place(chart, p), series);
    return out;
}

std::string key(const std::vector<const ChartSeries*>& named) {
    std::string out;
    for (std::size_t k = 0; k < named.size(); ++k) {
        const ChartSeries& series = *named[k];
        const double x = left + width / key_columns * static_cast<double>(k % key_columns);
        const std::size_t row = 1 + k / key_columns;
        const double y = top + height + below + key_line * static_cast<double>(row);
        if (series.mark == ChartMark::curve)
            out += fmt::format("<path d=\"M{} {}h20\" stroke=\"{}\" stroke-width=\"3\"/>",
                               decimal(x), decimal(y - 4), series.ink);
        else
            out += mark({x + 10, y - 4}, series);
        out += words({x + 26, y}, "start", series.name);
    }
    return out;
}

}  // namespace

std::string chart(const Chart& chart) {
    std::vector<const ChartSeries*> named;
    for (const ChartSeries& series : chart.series)
        if (!series.name.empty()) named.push_back(&series);
    const std::size_t rows = (named.size() + key_columns - 1) / key_columns;
    const auto key_rows = static_cast<double>(rows);
    std::string out = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {} {}\" "
        "font-family=\"sans-serif\" font-size=\"13\">\n"
        "<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n",
        decimal(left + width + 24), decimal(top + height + below + key_line * key_rows + 16));
    out += fmt::format("<g font-weight=\"bold\">{}</g>\n",
                       words({left + width / 2, 26}, "middle", chart.title));
    out += grid(chart);
    for (const ChartSeries& series : chart.series) out += drawn(chart, series);
    return out + key(named) + "</svg>\n";
}

}  // namespace bead
